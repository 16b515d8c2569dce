#include "sim/record/output_files.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sandglass {

namespace {

namespace fs = std::filesystem;

void refuse_wrong_kind(const std::string& path) {
  std::error_code none;
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder, none))
    throw InputError(
        fmt::format("{}: no such folder: {}; make it, or name another file", path, folder.string()));
  if (fs::is_directory(path, none)) throw InputError(fmt::format("{}: is a folder; name a file", path));
  if (fs::exists(path, none) && !fs::is_regular_file(path, none))
    throw InputError(fmt::format("{}: is no regular file; name a file that can be replaced", path));
}

bool is_same_file(const std::string& one, const std::string& two) {
  std::error_code none;
  if (fs::exists(one, none) && fs::exists(two, none)) return fs::equivalent(one, two, none);
  return fs::weakly_canonical(one, none) == fs::weakly_canonical(two, none);
}

/// Parts of an AtomicFile at `path`. Whoever holds the claim writes none yet, so that all are left over.
std::vector<std::string> remove_parts(const std::string& path) {
  std::vector<std::string> removed;
  std::error_code none;
  const std::string start = fs::path(path).filename().string() + ".part-";
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::absolute(path).parent_path(), none)) {
    const std::string name = entry.path().filename().string();
    const bool numbered = name.size() > start.size() && name.starts_with(start) &&
                          std::all_of(name.begin() + static_cast<std::ptrdiff_t>(start.size()), name.end(),
                                      [](unsigned char letter) { return std::isdigit(letter) != 0; });
    if (numbered && fs::remove(entry.path(), none)) removed.push_back(entry.path().string());
  }
  return removed;
}

/// Whether the locked file still stands at its path: its last holder removes it, perhaps while we waited to open it.
bool is_still_there(int descriptor, const std::string& path) {
  struct stat held {
  }, there{};
  return ::fstat(descriptor, &held) == 0 && ::stat(path.c_str(), &there) == 0 &&
         held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (const Lock& lock : locks_) {
    ::unlink(lock.path.c_str());
    ::close(lock.descriptor);
  }
}

std::vector<std::string> OutputFiles::claim(const OutputFile& output) {
  const std::string& path = output.path;
  refuse_wrong_kind(path);
  refuse_own_files(path);
  std::error_code none;
  if (output.existing == Existing::keep && fs::exists(path, none))
    throw InputError(fmt::format("{}: exists already; {}", path, output.remedy));
  lock(path);
  claimed_.push_back(path);
  std::vector<std::string> leftovers = remove_parts(path);
  require_writable(path);
  return leftovers;
}

void OutputFiles::refuse_own_files(const std::string& path) const {
  const auto same = [&path](const std::string& other) { return is_same_file(path, other); };
  if (std::ranges::any_of(inputs_, same))
    throw InputError(fmt::format("{}: is what the command reads; name another file to write", path));
  if (std::ranges::any_of(claimed_, same))
    throw InputError(fmt::format("{}: is written twice by this command; name another file", path));
}

/// On disks that know no locks (some network disks) every claim is granted.
void OutputFiles::lock(const std::string& path) {
  const std::string name = path + ".lock";
  for (;;) {
    const int descriptor = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) throw RunError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    const bool taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (taken) {
      ::close(descriptor);
      throw InputError(
          fmt::format("{}: another command is writing it; wait for it, or name another file", path));
    }
    if (is_still_there(descriptor, name)) {
      locks_.push_back({name, descriptor});
      return;
    }
    ::close(descriptor);
  }
}

}  // namespace sandglass
