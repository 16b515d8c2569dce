#include "sim/program/signals.hpp"

#include "sim/base/stop_request.hpp"

#include <cerrno>
#include <csignal>
#include <string_view>

#include <unistd.h>

namespace sandglass::program {

namespace {
std::atomic<const char*> words{nullptr};

void ask_to_stop(int signal) {
  const int kept = errno;
  stop_request.ask();
  std::signal(signal, SIG_DFL);
  if (const char* line = words) {
    const std::string_view text = line;
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  }
  errno = kept;
}
}  // namespace

/// On a terminal the line takes the place of the progress.
const std::atomic<bool>& stop_on_signal(bool quiet) {
  const char* line = "stopping; again to end at once\n";
  if (isatty(STDERR_FILENO) != 0) line = "\r\033[Kstopping; again to end at once\n";
  words = quiet ? nullptr : line;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  return stop_request.asked();
}

}  // namespace sandglass::program
