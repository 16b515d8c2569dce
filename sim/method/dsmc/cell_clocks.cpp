#include "sim/method/dsmc/cell_clocks.hpp"

#include "sim/base/saved.hpp"

#include <algorithm>

namespace sandglass::dsmc {

namespace {
/// In steps; the pairs of a step are far fewer.
constexpr double kFarAhead = 1e12;
}  // namespace

void CellClocks::start(std::uint32_t cells, const StreamKey& key) {
  dt_ = 0;
  ahead_.resize(cells);
  for (std::uint32_t cell = 0; cell < cells; ++cell) ahead_[cell] = Random(key, cell).uniform();
}

void CellClocks::begin_step(double dt) {
  if (dt_ > 0 && dt_ != dt)
    for (double& ahead : ahead_) ahead *= dt_ / dt;
  dt_ = dt;
  if (forgotten_) std::fill(ahead_.begin(), ahead_.end(), 0.0);
}

void CellClocks::save(Memory& memory) const {
  memory["dsmc/clocks"] = ahead_;
  memory["dsmc/clock-step"] = {dt_};
}

void CellClocks::load(const Memory& memory) {
  const std::vector<double>& ahead = memory.at("dsmc/clocks");
  if (ahead.size() != ahead_.size()) refuse_saved("clocks that are not as many as the cells");
  for (std::size_t cell = 0; cell < ahead.size(); ++cell)
    ahead_[cell] = saved_number(ahead[cell], -1, kFarAhead, "the clock of a cell");
  dt_ = saved_number(memory.at("dsmc/clock-step").at(0), 0, 1e300, "a time step");
}

}  // namespace sandglass::dsmc
