#pragma once

#include "sim/base/vector.hpp"
#include "sim/space/quad.hpp"

#include <array>
#include <cstdint>

namespace sandglass::event_driven {

/// A partner's number: below this a particle, from here on an agent.
inline constexpr std::uint32_t kFirstAgent = std::uint32_t{1} << 31;
inline constexpr std::uint32_t kNobody = ~std::uint32_t{0};

/// A particle on its way, at the time of its last change: what those near it have to read. One cache line.
template <int D>
struct alignas(64) Particle {
  Vector<D> position, velocity;
  double time;
  std::uint32_t changes;  ///< of its flight; predictions made before the last one are out of date
  std::uint32_t below;    ///< the next particle in the same cell, or nobody
};

/// Four particles, each number of theirs side by side. Reads the lines whole.
template <int D>
class Columns {
 public:
  Columns(const Particle<D>* particles, const std::array<std::uint32_t, 4>& which) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto* numbers = reinterpret_cast<const double*>(particles + which[k]);
      low_[k] = read_quad(numbers);
      high_[k] = read_quad(numbers + 4);
    }
    transpose(low_);
    transpose(high_);
  }
  const Quad& position(int axis) const { return column(axis); }
  const Quad& velocity(int axis) const { return column(D + axis); }
  const Quad& time() const { return column(2 * D); }

 private:
  const Quad& column(int place) const { return place < 4 ? low_[place] : high_[place - 4]; }
  Quad low_[4], high_[4];
};

/// What will happen to a particle next: a contact or, before that, the crossing of a cell wall.
struct Next {
  double time;                    ///< of whichever comes first
  double contact;                 ///< time of the contact
  std::uint32_t partner;          ///< a particle, an agent (kFirstAgent + index), or nobody
  std::uint32_t partner_changes;  ///< changes of the partner when the contact was predicted
  std::uint32_t cell;             ///< where the particle is
  std::uint32_t exit;  ///< by which it leaves that cell: twice the axis, one more for upwards; nobody for one
                       ///< that has left the box
};

}  // namespace sandglass::event_driven
