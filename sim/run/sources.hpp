#pragma once

#include "sim/base/random.hpp"
#include "sim/run/placement_room.hpp"
#include "sim/run/schedule.hpp"
#include "sim/run/setup.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

/// Height of the pile above the end that gravity pulls to: of the highest particle that moves along gravity no faster than
/// `speed` (falling_speed()); 0 without one. The source of Mueller (2001, 3.5) stands above the highest of all particles,
/// and so would climb on what it pours whenever that falls less than its height until the next one comes. Who bounces
/// counts; with restitution below 1 it rises less high than it was poured from.
template <int D>
double pile_height(const View<D>& view, int axis, bool down, double speed);

/// The sources of a scene at work: until time t each has brought in floor(rate t) particles, between steps. The n-th
/// particle of a source draws its place from a stream of its own. Particles with a surface take the first of a hundred
/// places that is free, and come in after a later step if none is.
template <int D>
class Sources {
 public:
  Sources(const Setup<D>& setup, const Streams& streams);

  /// Brings in what is due. Throws RunError where that would be outside the box or in an obstacle.
  void pour(Simulator<D>& simulator, const Clock& clock);
  /// Particles brought in so far, by source.
  const std::vector<double>& poured() const { return poured_; }
  /// "particles-poured"; of particles with a surface also how often one found no place.
  std::map<std::string, double> counters() const;
  std::vector<double> save() const;
  void load(const std::vector<double>& state);

 private:
  double due(const Source& source, double time) const;
  double level(Simulator<D>& simulator) const;
  Vector<D> low_corner(const Source& source, double level) const;
  void bring_in(Simulator<D>& simulator, std::size_t index, double count, double level);
  static std::optional<Vector<D>> free_place(Simulator<D>& simulator, const Vector<D>& low,
                                             const Vector<D>& width, Random random);
  Particles<D> draw(Simulator<D>& simulator, std::size_t index, double count, double level) const;
  void refuse_outside(const Source& source, const Vector<D>& low, const Clock& clock) const;

  const Setup<D>& setup_;
  Streams streams_;
  Room<D> room_;
  int axis_ = -1;     ///< along which heights are counted; -1: none is
  bool down_ = true;  ///< gravity points to the low end
  double speed_ = 0;  ///< above which a particle still falls
  double radius_;     ///< of what they pour
  std::vector<double> poured_, refusals_;
};

extern template double pile_height(const View<2>&, int, bool, double);
extern template double pile_height(const View<3>&, int, bool, double);
extern template class Sources<2>;
extern template class Sources<3>;

}  // namespace sandglass
