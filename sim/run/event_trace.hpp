#pragma once

#include "sim/observe/event.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace sandglass {

/// Writes a line per event: time, kind (collision or agent), first, second (particle identities; an agent's number),
/// position of the first, normal from the second to the first, both velocities afterwards, speed of approach before.
template <int D>
class EventTrace final : public EventSink<D> {
 public:
  /// Throws RunError when the file cannot be written. `append` goes on with a trace that is there.
  EventTrace(const std::string& path, bool append);
  void record(const Event<D>& event) override;
  /// Throws RunError if a line was lost (disk full).
  void flush();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void put(const Vector<D>& vector);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

extern template class EventTrace<2>;
extern template class EventTrace<3>;

}  // namespace sandglass
