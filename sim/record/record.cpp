#include "sim/record/record.hpp"

#include "sim/base/error.hpp"
#include "sim/record/hdf5/file.hpp"
#include "sim/record/hdf5/whole_file.hpp"
#include "sim/record/schema/names.hpp"
#include "sim/record/schema/particles.hpp"
#include "sim/record/schema/provenance.hpp"
#include "sim/record/schema/series.hpp"
#include "sim/record/schema/state.hpp"

#include <cerrno>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <unistd.h>

namespace sandglass {
namespace {

void write_h5md(const hdf5::Writer& file, const Record& record) {
  schema::write_convention(file, record.provenance);
  const hdf5::Writer all = file.group(schema::names::particles).group(schema::names::all);
  schema::write_box(all.group(schema::names::box), record);
  schema::write_trajectory(all, record.trajectory, record.dimension);
  const hdf5::Writer observables = file.group(schema::names::observables);
  if (!record.replicas.empty()) schema::write_observables(observables, record.replicas.front().series);
}

void write_sandglass(const hdf5::Writer& file, const Record& record) {
  const hdf5::Writer group = file.group(schema::names::root);
  group.attribute(schema::names::version, std::vector<int>{schema::version_major, schema::version_minor});
  group.text(schema::names::scene, record.scene);
  group.attribute(schema::names::warnings, record.warnings);
  group.attribute(schema::names::changes, record.changes);
  group.attribute(schema::names::broken, record.broken);
  file.group(schema::names::parameters).link(schema::names::scene, group, schema::names::scene);
  schema::write_provenance(group.group(schema::names::provenance), record.provenance);
  schema::write_replicas(group, record.replicas);
  schema::write_scalars(group.group(schema::names::timings), record.timings);
  std::vector<const schema::SeriesList*> lists;
  for (const Replica& replica : record.replicas) lists.push_back(&replica.series);
  schema::write_series(group.group(schema::names::series), lists);
  schema::write_estimates(group.group(schema::names::estimates), record.estimates);
  if (record.state) schema::write_state(group.group(schema::names::state), *record.state, record.dimension);
}

Record read_hdf5(const std::string& path) {
  const hdf5::Handle file = hdf5::open_file(path);
  const hdf5::Reader top(hdf5::Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose), "/");
  schema::require_version(top);
  const hdf5::Reader group = top.group(schema::names::root);
  const hdf5::Reader all = top.group(schema::names::particles).group(schema::names::all);
  Record record;
  record.scene = group.text(schema::names::scene);
  record.warnings = group.words(schema::names::warnings);
  record.changes = group.words(schema::names::changes);
  record.broken = group.word(schema::names::broken);
  record.provenance = schema::read_provenance(group.group(schema::names::provenance));
  schema::read_box(all.group(schema::names::box), record);
  record.replicas = schema::read_replicas(group);
  auto lists = schema::read_series(group.group(schema::names::series), record.replicas.size());
  for (std::size_t index = 0; index < lists.size(); ++index)
    record.replicas[index].series = std::move(lists[index]);
  record.estimates = schema::read_estimates(group.group(schema::names::estimates));
  record.trajectory = schema::read_trajectory(all, record.dimension);
  record.timings = schema::read_scalars(group.group(schema::names::timings));
  if (group.has(schema::names::state))
    record.state = schema::read_state(group.sealed_group(schema::names::state), record.dimension);
  return record;
}

/// HDF5 hides why a file cannot be opened; the system says it.
void require_readable(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  char byte = 0;
  const bool readable = descriptor >= 0 && ::read(descriptor, &byte, 1) >= 0;
  const int reason = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!readable) throw InputError("cannot read '" + path + "': " + std::strerror(reason));
}

}  // namespace

std::string write_record(const std::string& path, const Record& record, Existing existing) {
  const auto fill = [&](const hdf5::Writer& root) {
    write_h5md(root, record);
    write_sandglass(root, record);
  };
  return hdf5::write_whole_file(path, fill, existing);
}

Record read_record(const std::string& path) {
  require_readable(path);
  const hdf5::Session session;
  try {
    return read_hdf5(path);
  } catch (const hdf5::Failure& failure) {
    throw InputError("cannot read '" + path + "' as a Sandglass record: " + failure.what());
  } catch (const std::bad_alloc&) {
    throw InputError("cannot read '" + path + "': it says that it holds more than fits into memory");
  }
}

}  // namespace sandglass
