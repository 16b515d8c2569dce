#include "sim/run/event_trace.hpp"

#include "sim/base/error.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace sandglass {

namespace {
std::string heading(int dimension) {
  std::string line = "time,kind,first,second";
  for (const char* name : {"position", "normal", "velocity_1", "velocity_2"})
    for (int axis = 0; axis < dimension; ++axis) line += fmt::format(",{}_{}", name, "xyz"[axis]);
  return line + ",approach\n";
}
}  // namespace

template <int D>
EventTrace<D>::EventTrace(const std::string& path, bool append)
    : path_(path), file_(std::fopen(path.c_str(), append ? "a" : "w")) {
  if (!file_)
    throw RunError(fmt::format("cannot write the event trace '{}': {}", path, std::strerror(errno)));
  if (std::ftell(file_.get()) <= 0 && !append) std::fputs(heading(D).c_str(), file_.get());
}

template <int D>
void EventTrace<D>::put(const Vector<D>& vector) {
  for (int axis = 0; axis < D; ++axis) fmt::print(file_.get(), ",{}", vector[axis]);
}

template <int D>
void EventTrace<D>::record(const Event<D>& event) {
  fmt::print(file_.get(), "{},{},{},{}", event.time,
             event.kind == Event<D>::Kind::collision ? "collision" : "agent", event.first, event.second);
  put(event.position);
  put(event.normal);
  put(event.velocity_1);
  put(event.velocity_2);
  fmt::print(file_.get(), ",{}\n", event.approach);
}

template <int D>
void EventTrace<D>::flush() {
  if (std::fflush(file_.get()) != 0 || std::ferror(file_.get()) != 0)
    throw RunError(fmt::format("cannot write the event trace '{}': {}", path_, std::strerror(errno)));
}

template class EventTrace<2>;
template class EventTrace<3>;

}  // namespace sandglass
