#include "sim/method/event_driven/agents_by_cell.hpp"

#include "sim/base/error.hpp"

#include <limits>
#include <numeric>

namespace sandglass::event_driven {

namespace {
/// Calls `visit` with the place of each cell that the agent reaches into.
template <int D, class Visit>
void for_each_reached(const Cells<D>& cells, const Agent<D>& agent, Visit visit) {
  const Box<D> reach = agent.reach();
  cells.for_each_between(reach.low, reach.high, [&](std::uint32_t cell) {
    const Box<D> box{cells.low_corner(cell), cells.high_corner(cell)};
    if (reach.overlaps(box) && agent.reaches(box)) visit(cells.linear(cell));
  });
}
}  // namespace

template <int D>
AgentsByCell<D>::AgentsByCell(const Cells<D>& cells, const Agents<D>& agents) {
  std::vector<std::uint64_t> count(cells.size() + std::size_t{1});
  for (const auto& agent : agents)
    for_each_reached(cells, *agent, [&](std::uint32_t place) { ++count[place + 1]; });
  std::partial_sum(count.begin(), count.end(), count.begin());
  if (count.back() == 0) return;
  if (count.back() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("walls and obstacles reach into too many cells; take fewer or smaller obstacles");
  first_.assign(count.begin(), count.end());
  agent_.resize(count.back());
  for (std::uint32_t a = 0; a < agents.size(); ++a)
    for_each_reached(cells, *agents[a], [&](std::uint32_t place) { agent_[count[place]++] = a; });
}

template class AgentsByCell<2>;
template class AgentsByCell<3>;

}  // namespace sandglass::event_driven
