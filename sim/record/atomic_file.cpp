#include "sim/record/atomic_file.hpp"

#include "sim/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace sandglass {

namespace {

/// Renames unless `to` exists (EEXIST): in one step where the disk can, else through a link, else as well as it goes.
bool rename_to_new(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  if (::link(from.c_str(), to.c_str()) == 0) return ::unlink(from.c_str()) == 0;
  if (errno == EEXIST || std::filesystem::exists(to)) {
    errno = EEXIST;
    return false;
  }
  return std::rename(from.c_str(), to.c_str()) == 0;
}

std::string numbered(const std::string& path, int number) {
  const std::filesystem::path whole(path);
  return (whole.parent_path() /
          (whole.stem().string() + "-" + std::to_string(number) + whole.extension().string()))
      .string();
}

}  // namespace

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), part_(path_ + ".part-" + std::to_string(::getpid())) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path_, ignored)) {
    errno = EISDIR;
    fail();
  }
  if (std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored))
    throw RunError("cannot write '" + path_ + "': it is no regular file, and would be replaced by one");
  descriptor_ = ::open(part_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail();
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) empty();
  if (!committed_) std::filesystem::remove(part_, ignored);
  ::close(descriptor_);
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string AtomicFile::refusal() const {
  constexpr off_t some_room = 1 << 20;
  const off_t end = ::lseek(descriptor_, 0, SEEK_END);
  const int reason = ::posix_fallocate(descriptor_, end, some_room);
  return reason == 0 ? "" : std::strerror(reason);
}

void AtomicFile::empty() {
  std::error_code ignored;
  std::filesystem::resize_file(part_, 0, ignored);
}

std::string AtomicFile::commit(Existing existing) {
  if (::fsync(descriptor_) != 0) fail();
  std::string name = path_;
  if (existing == Existing::keep)
    name = take_free_name();
  else if (std::rename(part_.c_str(), path_.c_str()) != 0)
    fail();
  committed_ = true;
  sync_folder();
  return name;
}

std::string AtomicFile::take_free_name() const {
  std::string name = path_;
  for (int number = 1; !rename_to_new(part_, name); ++number) {
    if (errno != EEXIST) fail();
    name = numbered(path_, number);
  }
  return name;
}

/// The new name itself must reach the disk; folders that cannot be synchronised (some network disks) are left
/// alone.
void AtomicFile::sync_folder() const {
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void AtomicFile::fail() const { throw RunError("cannot write '" + path_ + "': " + std::strerror(errno)); }

void require_writable(const std::string& path) { AtomicFile probe(path); }

}  // namespace sandglass
