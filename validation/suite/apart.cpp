#include "validation/suite/apart.hpp"

#include "sim/base/error.hpp"
#include "validation/suite/run_task.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sandglass {

namespace {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kWell = 0, kBroke = 3, kInterrupted = 4;  // exit codes
constexpr double kPatience = 20;                        // clock over CPU time
constexpr int kLook = 200;  // milliseconds between looks at the clock and at `stop`

std::shared_mutex& gate() {
  static std::shared_mutex mutex;
  return mutex;
}

void limit_cpu(double seconds) {
  if (!(seconds < 1e9)) return;
  const auto soft = static_cast<rlim_t>(std::ceil(seconds));
  const rlimit limit{soft, soft + 1};
  setrlimit(RLIMIT_CPU, &limit);
}

[[noreturn]] void leave(int pipe, const char* text, int code) {
  [[maybe_unused]] const ssize_t written = write(pipe, text, std::strlen(text));
  _exit(code);
}

/// In the new process. Buffers of the old one are left as they are: nothing runs at the exit.
[[noreturn]] void carry_out(const std::function<void()>& work, double cpu_seconds, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit_cpu(cpu_seconds);
  try {
    work();
  } catch (const Interrupted& interrupted) {
    leave(pipe, interrupted.what(), kInterrupted);
  } catch (const std::exception& error) {
    leave(pipe, error.what(), kBroke);
  }
  leave(pipe, "", kWell);
}

struct Child {
  pid_t process;
  int pipe;  ///< what it says; ends with it
};

Child start(const std::function<void()>& work, double cpu_seconds) {
  const std::unique_lock lock(gate());
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw RunError(fmt::format("no pipe to a new process: {}", strerror(errno)));
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    carry_out(work, cpu_seconds, ends[1]);
  }
  close(ends[1]);
  if (process > 0) return {process, ends[0]};
  close(ends[0]);
  throw RunError(fmt::format("no new process: {}", strerror(errno)));
}

struct Ending {
  int status = 0;
  bool late = false, stopped = false;
  std::string text;
};

/// Adds what the process says; false at its end.
bool listen(int pipe, std::string& text) {
  pollfd ready{pipe, POLLIN, 0};
  if (poll(&ready, 1, kLook) <= 0) return true;
  std::array<char, 4096> buffer{};
  const ssize_t count = read(pipe, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

Ending wait_for(const Child& child, double seconds, const std::atomic<bool>* stop) {
  Ending ending;
  const auto begin = Clock::now();
  while (listen(child.pipe, ending.text)) {
    if (stop != nullptr && *stop && !ending.stopped) {
      ending.stopped = true;
      kill(child.process, SIGTERM);
    }
    if (std::chrono::duration<double>(Clock::now() - begin).count() > seconds && !ending.late) {
      ending.late = true;
      kill(child.process, SIGKILL);
    }
  }
  close(child.pipe);
  while (waitpid(child.process, &ending.status, 0) < 0 && errno == EINTR) {
  }
  return ending;
}

void report(const Ending& ending, double cpu_seconds) {
  const bool exited = WIFEXITED(ending.status);
  const int code = exited ? WEXITSTATUS(ending.status) : WTERMSIG(ending.status);
  if (exited && code == kWell) return;
  if (ending.stopped || (exited && code == kInterrupted))
    throw Interrupted(ending.text.empty() ? "stopped" : ending.text);
  if (exited && code == kBroke) throw RunError(ending.text);
  if (ending.late || (!exited && code == SIGXCPU))
    throw RunError(fmt::format("it was ended after {:.0f} s {}, many times what its plan expects: it hangs",
                               ending.late ? kPatience * cpu_seconds : cpu_seconds,
                               ending.late ? "by the clock" : "of CPU time"));
  throw RunError(exited ? fmt::format("it ended with exit code {}", code)
                        : fmt::format("it was killed by signal {}: {}", code, strsignal(code)));
}

/// Removed with the object when nobody has named it.
class RecordFile {
 public:
  explicit RecordFile(const std::string& path) : path_(path), passing_(path.empty()) {
    static std::atomic<int> number = 0;
    if (passing_) path_ = fs::temp_directory_path() / fmt::format("sandglass-{}-{}.h5", getpid(), number++);
  }
  ~RecordFile() {
    std::error_code ignored;
    if (passing_) fs::remove(path_, ignored);
  }
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  bool passing_;
};
}  // namespace

std::shared_lock<std::shared_mutex> hold_off_new_processes() { return std::shared_lock(gate()); }

void run_apart(const std::function<void()>& work, double cpu_seconds, const std::atomic<bool>* stop) {
  const Child child = start(work, cpu_seconds);
  report(wait_for(child, kPatience * cpu_seconds, stop), cpu_seconds);
}

double cpu_limit(const Scene& scene) {
  return 60 + static_cast<double>(scene.run.replicas) + 1e-5 * expected_work(scene);
}

Record run_scene_apart(const Scene& scene, const RunOptions& options, const std::string& path) {
  const RecordFile file(path);
  const double limit = [&] {
    const auto lock = hold_off_new_processes();
    if (file.path().has_parent_path()) fs::create_directories(file.path().parent_path());
    return cpu_limit(scene);
  }();
  run_apart([&] { write_record(file.path().string(), run_scene(scene, options)); }, limit, options.stop);
  const auto lock = hold_off_new_processes();
  return read_record(file.path().string());
}

}  // namespace sandglass
