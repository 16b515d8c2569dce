#include "sim/record/hdf5/handle.hpp"

#include <utility>
#include <vector>

namespace sandglass::hdf5 {
namespace {

std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// At exit the library would flush what a full disk refused before, and crash. All that matters is closed by
/// then.
bool leave_exit_alone() {
  static const bool done = H5dont_atexit() >= 0;
  return done;
}

herr_t collect_description(unsigned, const H5E_error2_t* entry, void* descriptions) {
  if (entry->desc != nullptr) static_cast<std::vector<std::string>*>(descriptions)->emplace_back(entry->desc);
  return 0;
}

/// The text between the quotes of "error message = '...'", which HDF5 fills from strerror(); "" when absent.
std::string system_words(const std::string& description) {
  const std::string opening = "error message = '";
  const std::size_t begin = description.find(opening);
  if (begin == std::string::npos) return "";
  const std::size_t first = begin + opening.size();
  return description.substr(first, description.find('\'', first) - first);
}

}  // namespace

Session::Session() : lock_(library_mutex()) {
  leave_exit_alone();
  H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Session::~Session() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_data_); }

std::string last_reason() {
  std::vector<std::string> descriptions;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect_description, &descriptions);
  for (const std::string& description : descriptions)
    if (std::string words = system_words(description); !words.empty()) return words;
  return descriptions.empty() ? "unknown HDF5 error" : descriptions.front();
}

void require(herr_t status) {
  if (status < 0) throw Failure(last_reason());
}

Handle::Handle(hid_t id, Close closer) : id_(id), close_(closer) {
  if (id < 0) throw Failure(last_reason());
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

void Handle::close() { require(close_(std::exchange(id_, -1))); }

}  // namespace sandglass::hdf5
