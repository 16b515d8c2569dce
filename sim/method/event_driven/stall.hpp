#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace sandglass::event_driven {

/// Notices inelastic collapse: contact after contact at one and the same instant, ever softer (McNamara & Young 1992).
/// Simultaneous contacts of a lattice or a row of touching particles are not soft and pass.
class StallMonitor {
 public:
  /// A contact is soft below 1e-9 times the speed of the gas, and two are at one instant within 1e-12 times the time over
  /// which clocks run, where rounding decides. A gas that begins at rest takes its speed from its contacts.
  void set_scale(double speed, double time) { soft_ = 1e-9 * speed, instant_ = 1e-12 * time; }
  /// True when the contact is one too many. `now` in any unit that grows.
  bool contact(double now, double approach) {
    if (now - last_ > instant_ || approach > soft_) {
      last_ = now;
      soft_ = std::max(soft_, 1e-9 * approach);
      soft_contacts_ = 0;
      return false;
    }
    return ++soft_contacts_ >= kMost;
  }
  /// Lets times count from `origin`.
  void rebase(double origin) { last_ -= origin; }

 private:
  static constexpr std::uint32_t kMost = 64;
  double soft_ = 0, instant_ = 0, last_ = -HUGE_VAL;
  std::uint32_t soft_contacts_ = 0;
};

/// What a run says that collapsed; `first` and `second` name the pair.
std::string collapse_message(double time, const std::string& first, const std::string& second, bool falling);

}  // namespace sandglass::event_driven
