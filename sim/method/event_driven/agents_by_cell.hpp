#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/cells.hpp"

#include <span>

namespace sandglass::event_driven {

/// The agents that reach into each cell, one row of numbers after the other (compressed rows). An event asks those of its
/// cell, however many there are elsewhere. Built at a cost that grows with the cells and the boxes reached.
template <int D>
class AgentsByCell {
 public:
  AgentsByCell(const Cells<D>& cells, const Agents<D>& agents);

  /// No agent acts on particles.
  bool empty() const { return agent_.empty(); }
  /// In ascending order; `place` is that of the cell in storage. Not of an empty table.
  std::span<const std::uint32_t> operator[](std::uint32_t place) const {
    return {agent_.data() + first_[place], agent_.data() + first_[place + 1]};
  }
  std::size_t bytes() const { return (first_.capacity() + agent_.capacity()) * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> first_;  ///< of each cell's row in `agent_`, and the end
  std::vector<std::uint32_t> agent_;
};

extern template class AgentsByCell<2>;
extern template class AgentsByCell<3>;

}  // namespace sandglass::event_driven
