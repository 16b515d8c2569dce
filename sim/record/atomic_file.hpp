#pragma once

#include <string>
#include <string_view>

namespace sandglass {

/// What to do with a file that stands where one is to be written.
enum class Existing { keep, replace };

/// A file that appears whole or not at all: filled as `<path>.part-<process id>`, flushed to disk, then
/// renamed. Whatever stood at `path` before stays until commit(); without commit() the partial file is
/// removed. Only regular files are replaced. Every function throws RunError naming the path and the system's
/// reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write until commit().
  const std::string& part() const { return part_; }
  /// Appends to the part.
  void write(std::string_view bytes);
  /// Why the disk gives the part no more room, in the system's words; "" when it does. MPI-IO keeps this to
  /// itself.
  std::string refusal() const;
  /// Gives the part's bytes back to the disk, even while another descriptor holds it open.
  void empty();
  /// Returns the path that the file has now: with Existing::keep and something at `path`, the first of
  /// "name-1.ending", "name-2.ending", ... that is free.
  std::string commit(Existing existing = Existing::replace);

 private:
  [[noreturn]] void fail() const;
  std::string take_free_name() const;
  void sync_folder() const;

  std::string path_;
  std::string part_;
  int descriptor_ = -1;
  bool committed_ = false;
};

/// Throws RunError now when a file could not be written at `path` later (no such folder, not writable, a
/// folder).
void require_writable(const std::string& path);

}  // namespace sandglass
