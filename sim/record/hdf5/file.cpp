#include "sim/record/hdf5/file.hpp"

#include <mpi.h>

namespace sandglass::hdf5 {
namespace {

bool mpi_is_up() {
  int started = 0;
  int finished = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&finished);
  return started != 0 && finished == 0;
}

Handle access() {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_libver_bounds(properties, H5F_LIBVER_V18, H5F_LIBVER_LATEST));
  require(H5Pset_fclose_degree(properties, H5F_CLOSE_STRONG));
  if (!mpi_is_up()) return properties;
  require(H5Pset_fapl_mpio(properties, MPI_COMM_SELF, MPI_INFO_NULL));
  require(H5Pset_all_coll_metadata_ops(properties, true));
  require(H5Pset_coll_metadata_write(properties, true));
  return properties;
}

}  // namespace

Handle create_file(const std::string& path) {
  return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access()), H5Fclose);
}

Handle open_file(const std::string& path) {
  return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access()), H5Fclose);
}

Handle transfer() {
  Handle properties(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  if (mpi_is_up()) require(H5Pset_dxpl_mpio(properties, H5FD_MPIO_COLLECTIVE));
  return properties;
}

}  // namespace sandglass::hdf5
