#include "sim/run/event_trace.hpp"

#include "sim/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

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
EventTrace<D>::EventTrace(const std::string& path) : path_(path) {
  open("w");
  std::fputs(heading(D).c_str(), file_.get());
}

template <int D>
EventTrace<D>::EventTrace(const std::string& path, std::uintmax_t bytes) : path_(path) {
  std::error_code error;
  const std::uintmax_t there = std::filesystem::file_size(path, error);
  if (error || there < bytes)
    throw InputError(
        fmt::format("the event trace '{}' has {} bytes, and {} when the checkpoint was written; put the file "
                    "back, or run the "
                    "scene anew",
                    path, error ? 0 : there, bytes));
  std::filesystem::resize_file(path, bytes, error);
  if (error) throw RunError(fmt::format("cannot write the event trace '{}': {}", path, error.message()));
  open("a");
}

template <int D>
void EventTrace<D>::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  if (!file_)
    throw RunError(fmt::format("cannot write the event trace '{}': {}", path_, std::strerror(errno)));
}

template <int D>
void EventTrace<D>::put(const Vector<D>& vector) {
  for (int axis = 0; axis < D; ++axis) fmt::print(file_.get(), ",{}", vector[axis]);
}

template <int D>
void EventTrace<D>::hear(const Event<D>& event) {
  fmt::print(file_.get(), "{},{},{},{}", event.time,
             event.kind == Event<D>::Kind::collision ? "collision" : "agent", event.first, event.second);
  put(event.position);
  put(event.normal);
  put(event.velocity_1);
  put(event.velocity_2);
  fmt::print(file_.get(), ",{}\n", event.approach);
}

template <int D>
std::uintmax_t EventTrace<D>::flush() {
  if (std::fflush(file_.get()) != 0 || std::ferror(file_.get()) != 0)
    throw RunError(fmt::format("cannot write the event trace '{}': {}", path_, std::strerror(errno)));
  std::fseek(file_.get(), 0, SEEK_END);
  return static_cast<std::uintmax_t>(std::ftell(file_.get()));
}

template class EventTrace<2>;
template class EventTrace<3>;

}  // namespace sandglass
