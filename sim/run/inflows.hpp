#pragma once

#include "sim/base/saved.hpp"
#include "sim/run/placement_room.hpp"
#include "sim/run/schedule.hpp"
#include "sim/run/setup.hpp"

#include <map>
#include <vector>

namespace sandglass {

/// The inflows of a scene at work, those by flux: each sends in what the Maxwellian of its stream sends through the side, at times that
/// are uniform within the step. The n-th particle of an inflow draws place, time, velocity and spin from a stream of its
/// own. Where regions have weights of their own, so have those who come in there.
template <int D>
class Inflows {
 public:
  Inflows(const Setup<D>& setup, const Streams& streams);

  /// Lets in what comes during the coming step, which has the length dt and ends at `end`. Throws RunError where that is more
  /// than a step can take.
  void enter(Simulator<D>& simulator, const Clock& clock, double dt, double end);
  /// "particles-entered", and the same by side.
  std::map<std::string, double> counters() const;
  /// Particles let in so far, by inflow.
  const std::vector<double>& entered() const { return entered_; }
  void load(const std::vector<double>& entered) {
    for (std::size_t i = 0; i < entered_.size(); ++i)
      entered_[i] = static_cast<double>(saved_count(entered.at(i)));
  }

 private:
  double due(std::size_t index, const Clock& clock, double dt, double end) const;
  void draw(std::size_t index, double count, double dt, Entrants<D>& entrants) const;

  const Setup<D>& setup_;
  Streams streams_;
  Room<D> room_;
  std::vector<double> rate_, entered_;                  ///< of each inflow
  std::vector<typename RegionWeights<D>::Side> sides_;  ///< the same; without regions none
};

extern template class Inflows<2>;
extern template class Inflows<3>;

}  // namespace sandglass
