#include "sim/record/atomic_file.hpp"

#include "sim/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace sandglass {

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), part_(path_ + ".part-" + std::to_string(::getpid())) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path_, ignored)) {
    errno = EISDIR;
    fail();
  }
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

void AtomicFile::commit() {
  if (::fsync(descriptor_) != 0) fail();
  if (std::rename(part_.c_str(), path_.c_str()) != 0) fail();
  committed_ = true;
  sync_folder();
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
