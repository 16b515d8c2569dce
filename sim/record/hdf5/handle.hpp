#pragma once

#include <mutex>
#include <stdexcept>
#include <string>

#include <hdf5.h>

namespace sandglass::hdf5 {

/// HDF5 refused something; what() is the reason found in its error stack.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reserves HDF5 for this thread (the library is not thread safe) and keeps it from printing its error stack.
/// Every public function of the record room holds one session while it touches HDF5.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
  H5E_auto2_t printer_ = nullptr;
  void* printer_data_ = nullptr;
};

/// The system's words ("No space left on device") when the error stack holds them, else the innermost
/// description.
std::string last_reason();

/// Throws Failure when an HDF5 call returned a negative status.
void require(herr_t status);

/// Owns one HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  /// Throws Failure when `id` is negative.
  Handle(hid_t id, Close closer);
  ~Handle();
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;

  operator hid_t() const { return id_; }
  /// Closes now; throws Failure when that fails, as it does for a file whose last bytes cannot be written.
  void close();

 private:
  hid_t id_;
  Close close_;
};

}  // namespace sandglass::hdf5
