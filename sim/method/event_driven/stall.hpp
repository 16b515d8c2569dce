#pragma once

#include "sim/base/error.hpp"

#include <cstdint>

namespace sandglass::event_driven {

/// Notices inelastic collapse: contact after contact at one and the same instant, ever softer (McNamara & Young 1992).
/// Simultaneous contacts of a lattice or a row of touching particles are not soft and pass.
class StallMonitor {
 public:
  /// Speed below which a contact is soft: the scale of the gas times 1e-9.
  void set_scale(double speed) { soft_ = 1e-9 * speed; }
  /// True when the contact is one too many. `now` in any unit that grows.
  bool contact(double now, double approach) {
    if (now > last_ || approach > soft_) {
      last_ = now;
      soft_contacts_ = 0;
      return false;
    }
    return ++soft_contacts_ >= kMost;
  }
  /// Lets times count from `origin`.
  void rebase(double origin) { last_ -= origin; }

 private:
  static constexpr std::uint32_t kMost = 64;
  double soft_ = 0, last_ = -1;
  std::uint32_t soft_contacts_ = 0;
};

}  // namespace sandglass::event_driven
