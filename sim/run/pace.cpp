#include "sim/run/pace.hpp"

namespace sandglass {

bool Pace::due() const {
  return report_ && Clock::now() - marks_.back().when > std::chrono::milliseconds(250);
}

void Pace::report(Progress progress, double moves) {
  marks_.push_back({Clock::now(), progress.fraction, moves});
  if (marks_.size() > 21) marks_.pop_front();
  const double seconds = std::chrono::duration<double>(marks_.back().when - marks_.front().when).count();
  const double gained = marks_.back().fraction - marks_.front().fraction;
  progress.moves_per_second = (moves - marks_.front().moves) / seconds;
  progress.seconds_left = gained > 0 ? (1 - progress.fraction) / gained * seconds : -1;
  report_(progress);
}

}  // namespace sandglass
