#include "sim/program/progress_line.hpp"

#include "sim/program/launcher.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace sandglass::program {

namespace {
std::string duration(double seconds) {
  if (seconds < 0) return "?";
  const long whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{}s", whole);
  if (whole < 3600) return fmt::format("{}m{:02}s", whole / 60, whole % 60);
  return fmt::format("{}h{:02}m", whole / 3600, whole / 60 % 60);
}
}  // namespace

ProgressLine::ProgressLine(bool quiet)
    : live_(!quiet && isatty(STDERR_FILENO) != 0 && !launch_of_this_program().starts_mpi) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

std::function<void(const Progress&)> ProgressLine::callback() {
  if (!live_) return {};
  return [this](const Progress& progress) { show(progress); };
}

void ProgressLine::show(const Progress& progress) {
  const std::string line =
      fmt::format("\r\033[K{:5.1f}%  {} left  {:.3g} moves/s  step {}  t = {:.5g}  replica {}",
                  100 * progress.fraction, duration(progress.seconds_left), progress.moves_per_second,
                  progress.step, progress.time, progress.replica + 1);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace sandglass::program
