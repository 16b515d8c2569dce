#pragma once

#include "sim/observe/event.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace sandglass {

/// Writes a line per event: time, kind (collision or agent), first, second (particle identities; an agent's number),
/// position of the first, normal from the second to the first, both velocities afterwards, speed of approach before.
template <int D>
class EventTrace final : public EventSink<D> {
 public:
  /// A new file. Throws RunError when it cannot be written.
  explicit EventTrace(const std::string& path);
  /// Goes on with a file that is there, whatever stands behind its first `bytes` cut off. Throws InputError when it has
  /// fewer.
  EventTrace(const std::string& path, std::uintmax_t bytes);
  void hear(const Event<D>& event) override;
  /// Bytes written so far, all of them on their way to the disk. Throws RunError if a line was lost (disk full).
  std::uintmax_t flush();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void open(const char* mode);
  void put(const Vector<D>& vector);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

extern template class EventTrace<2>;
extern template class EventTrace<3>;

}  // namespace sandglass
