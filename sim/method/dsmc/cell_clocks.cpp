#include "sim/method/dsmc/cell_clocks.hpp"

#include <algorithm>

namespace sandglass::dsmc {

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
  ahead_ = memory.at("dsmc/clocks");
  dt_ = memory.at("dsmc/clock-step").at(0);
}

}  // namespace sandglass::dsmc
