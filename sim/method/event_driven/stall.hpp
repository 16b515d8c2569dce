#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

namespace sandglass::event_driven {

/// Notices inelastic collapse: contact after contact at one and the same instant, ever softer (McNamara & Young 1992).
/// Simultaneous contacts of a lattice or a row of touching particles are not soft and pass, unless they never end: a ring
/// of touching particles around a periodic box passes its momentum on for ever at one instant.
class StallMonitor {
 public:
  /// A contact is soft below 1e-9 times the speed of the gas, and two are at one instant within 1e-12 times the time over
  /// which clocks run, where rounding decides. A gas that begins at rest takes its speed from its contacts.
  void set_scale(double speed, double time) { soft_ = 1e-9 * speed, instant_ = 1e-12 * time; }
  void set_size(std::uint64_t particles) { most_at_once_ = 1'000'000 + 100 * particles; }
  /// True when the contact is one too many. `now` in any unit that grows.
  bool contact(double now, double approach) {
    at_once_ = now > latest_ ? 0 : at_once_ + 1;
    latest_ = std::max(now, latest_);
    if (at_once_ >= most_at_once_) return true;
    if (now - last_ > instant_ || approach > soft_) {
      last_ = now;
      soft_ = std::max(soft_, 1e-9 * approach);
      soft_contacts_ = 0;
      return false;
    }
    return ++soft_contacts_ >= kMost;
  }
  /// Lets times count from `origin`.
  void rebase(double origin) { last_ -= origin, latest_ -= origin; }

 private:
  static constexpr std::uint32_t kMost = 64;
  double soft_ = 0, instant_ = 0, last_ = -HUGE_VAL;
  std::uint32_t soft_contacts_ = 0;
  double latest_ = -HUGE_VAL;
  std::uint64_t at_once_ = 0, most_at_once_ = 1'000'000;
};

/// A particle by its identity, if it has one, and its place.
std::string describe_particle(std::span<const double> position, const std::uint64_t* id);

/// What a run says that collapsed; `first` and `second` name the pair.
std::string collapse_message(double time, const std::string& first, const std::string& second, bool falling);

}  // namespace sandglass::event_driven
