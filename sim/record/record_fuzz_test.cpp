#include "sim/base/error.hpp"
#include "sim/base/test_fuzz.hpp"
#include "sim/record/describe.hpp"
#include "sim/record/export.hpp"
#include "sim/record/hdf5/file.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/sample.hpp"
#include "sim/record/scratch.hpp"

#include <filesystem>
#include <functional>

#include <gtest/gtest.h>

// Property: whatever another program has made of a record's groups, datasets and attributes, with checksums that are right,
// it is read or refused in words; and what is read can be described and exported. HDF5 itself is not what is tested here:
// the file stays one that it can open.

namespace sandglass::record_fuzz_test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

/// Names of all objects of one kind below the top.
Strings objects_of(hid_t file, H5O_type_t kind) {
  struct Search {
    H5O_type_t kind;
    Strings found;
  } search{kind, {}};
  const auto collect = [](hid_t, const char* name, const H5O_info_t* info, void* data) -> herr_t {
    auto& all = *static_cast<Search*>(data);
    if (info->type == all.kind && name[0] != '.') all.found.emplace_back(name);
    return 0;
  };
  hdf5::require(H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, collect, &search));
  return search.found;
}

Strings attributes_of(hid_t object) {
  Strings found;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
    static_cast<Strings*>(data)->emplace_back(name);
    return 0;
  };
  hdf5::require(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &found));
  return found;
}

const std::string& pick(const Strings& all, std::mt19937& engine) { return all[engine() % all.size()]; }

/// The group that a path ends in, opened, and the last name.
std::pair<hdf5::Writer, std::string> split(hid_t file, const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "/" : path.substr(0, slash);
  return {hdf5::Writer(hdf5::Handle(H5Gopen2(file, folder.c_str(), H5P_DEFAULT), H5Gclose)),
          slash == std::string::npos ? path : path.substr(slash + 1)};
}

hdf5::Extents strange_extents(std::mt19937& engine) {
  const hsize_t sizes[] = {0, 1, 2, 3, 4, 5, 7, 15};
  hdf5::Extents extents(engine() % 5);
  for (hsize_t& extent : extents) extent = sizes[engine() % std::size(sizes)];
  return extents;
}

template <class T>
void put_strange_numbers(const hdf5::Writer& group, const std::string& name, std::mt19937& engine) {
  const hdf5::Extents extents = strange_extents(engine);
  std::vector<T> values(hdf5::elements(extents));
  for (T& value : values) {
    const double strange = hostile_number(engine);
    value = std::is_same_v<T, double> ? static_cast<T>(strange) : static_cast<T>(engine() * (engine() % 3));
  }
  group.numbers<T>(name, extents, std::span<const T>(values));
}

/// Another dataset in the place of one: other numbers, another shape, another type, or text.
void replace_dataset(hid_t file, const std::string& path, std::mt19937& engine) {
  const auto [group, name] = split(file, path);
  hdf5::require(H5Ldelete(file, path.c_str(), H5P_DEFAULT));
  switch (engine() % 4) {
    case 0:
      return put_strange_numbers<double>(group, name, engine);
    case 1:
      return put_strange_numbers<std::uint64_t>(group, name, engine);
    case 2:
      return put_strange_numbers<std::uint8_t>(group, name, engine);
    default:
      return group.text(name, std::string(engine() % 40, '['));
  }
}

/// One number of a dataset of reals, which keeps its shape.
void change_number(hid_t file, const std::string& path, std::mt19937& engine) {
  const hdf5::Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const hdf5::Handle type(H5Dget_type(dataset), H5Tclose), space(H5Dget_space(dataset), H5Sclose);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  if (H5Tget_class(type) != H5T_FLOAT || count == 0) return;
  hdf5::Extents extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  if (!extents.empty()) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  std::vector<double> values(count);
  hdf5::require(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  double& value = values[engine() % count];
  value = hostile_number(engine, value);
  const auto [group, name] = split(file, path);
  hdf5::require(H5Ldelete(file, path.c_str(), H5P_DEFAULT));
  group.numbers<double>(name, extents, std::span<const double>(values));
}

void change_attribute(hid_t file, std::mt19937& engine) {
  const std::string path = pick(objects_of(file, H5O_TYPE_GROUP), engine);
  hdf5::Handle group(H5Gopen2(file, path.c_str(), H5P_DEFAULT), H5Gclose);
  const Strings names = attributes_of(group);
  if (names.empty()) return;
  const std::string name = pick(names, engine);
  hdf5::require(H5Adelete(group, name.c_str()));
  const hdf5::Writer writer(std::move(group));
  switch (engine() % 5) {
    case 0:
      return;
    case 1:
      return writer.attribute(name, static_cast<int>(engine()));
    case 2:
      return writer.attribute(name, std::vector<std::uint64_t>(engine() % 4, engine() % 3));
    case 3:
      return writer.attribute(name,
                              Strings(engine() % 5, pick({"x", "", "position", "..", "momentum"}, engine)));
    default:
      return writer.attribute(name, std::vector<double>(1 + engine() % 3, hostile_number(engine)));
  }
}

void spoil(const std::string& path, std::mt19937& engine) {
  const hdf5::Session session;
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const std::string dataset = pick(objects_of(file, H5O_TYPE_DATASET), engine);
  switch (engine() % 6) {
    case 0:
      hdf5::require(H5Ldelete(file, dataset.c_str(), H5P_DEFAULT));
      return;
    case 1:
      hdf5::require(H5Ldelete(file, pick(objects_of(file, H5O_TYPE_GROUP), engine).c_str(), H5P_DEFAULT));
      return;
    case 2:
      return replace_dataset(file, dataset, engine);
    case 3:
      return change_attribute(file, engine);
    default:
      return change_number(file, dataset, engine);
  }
}

void read_and_show(const std::string& path, const ScratchFolder& folder, std::mt19937& engine) {
  try {
    const Record record = read_record(path);
    EXPECT_FALSE(describe_record(record).empty());
    try {
      export_record(record, export_formats()[engine() % export_formats().size()].name, folder / "out");
    } catch (const InputError& error) {
      EXPECT_STRNE(error.what(), "");
    }
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  } catch (const std::exception& other) {
    ADD_FAILURE() << "threw something else: " << other.what();
  }
}

TEST(RecordFuzz, ASpoiledRecordIsReadOrRefused) {
  const ScratchFolder folder;
  const std::string good = folder / "good.h5", path = folder / "spoiled.h5";
  write_record(good, sample_record());
  for (Trials trials(100); trials.next();) {
    std::mt19937 engine(trials.seed());
    fs::copy_file(good, path, fs::copy_options::overwrite_existing);
    spoil(path, engine);
    read_and_show(path, folder, engine);
  }
}

}  // namespace
}  // namespace sandglass::record_fuzz_test
