#include "sim/record/hdf5/whole_file.hpp"

#include "sim/base/error.hpp"
#include "sim/record/atomic_file.hpp"
#include "sim/record/hdf5/file.hpp"

namespace sandglass::hdf5 {
namespace {

/// HDF5 cannot let go of a file whose last bytes do not fit (it crashes at the end of MPI): after a failure,
/// what was written is given back to the disk first.
void write_part(AtomicFile& target, const std::function<void(const Writer&)>& fill) {
  Handle file = create_file(target.part());
  try {
    fill(Writer(Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose)));
    require(H5Fflush(file, H5F_SCOPE_LOCAL));
  } catch (const Failure& failure) {
    const std::string refusal = target.refusal();
    target.empty();
    throw Failure(refusal.empty() ? failure.what() : refusal);
  }
  file.close();
}

}  // namespace

std::string write_whole_file(const std::string& path, const std::function<void(const Writer&)>& fill,
                             Existing existing) {
  const Session session;
  AtomicFile file(path);
  try {
    write_part(file, fill);
  } catch (const Failure& failure) {
    throw RunError("cannot write '" + path + "': " + failure.what());
  }
  return file.commit(existing);
}

}  // namespace sandglass::hdf5
