#include "sim/base/stop_request.hpp"

namespace sandglass {

namespace {
using Clock = std::chrono::steady_clock;
/// A step that ends within it leaves a checkpoint. Batch systems kill half a minute after their signal.
constexpr Clock::duration kPatience = std::chrono::seconds(2);
}  // namespace

void StopRequest::ask() {
  if (asked_) return;
  since_ = Clock::now().time_since_epoch().count();
  asked_ = true;
}

void StopRequest::end_overdue_step() const {
  if (Clock::now().time_since_epoch().count() - since_ > kPatience.count())
    throw StoppedWithinStep("the step that was under way did not end in time");
}

}  // namespace sandglass
