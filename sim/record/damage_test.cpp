#include "sim/base/error.hpp"
#include "sim/record/atomic_file.hpp"
#include "sim/record/hdf5/file.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/record.hpp"
#include "sim/record/sample.hpp"
#include "sim/record/scratch.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sandglass::damage_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

std::string read_failure(const std::string& path) {
  return message_of<InputError>([&] { read_record(path); });
}

std::string write_failure(const std::string& path, const Record& record = sample_record()) {
  return message_of<RunError>([&] { write_record(path, record); });
}

/// Lets files grow to `bytes` only while it lives, as a full disk does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &former_);
    const rlimit limit{bytes, former_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &former_); }

 private:
  rlimit former_{};
};

TEST(RecordDamage, FullDiskIsNamedAndLeavesTheFormerFile) {
  const ScratchFolder folder;
  const std::string path = folder / "run.h5";
  write_record(path, sample_record());
  const auto size = fs::file_size(path);
  for (rlim_t limit : {rlim_t{0}, rlim_t{100}, rlim_t{3000}, rlim_t{size / 2}, rlim_t{size - 1}}) {
    const FileSizeLimit full(limit);
    const std::string message = write_failure(path);
    EXPECT_THAT(message, HasSubstr(path));
    EXPECT_THAT(message, HasSubstr("File too large")) << "at " << limit << " bytes";
  }
  EXPECT_EQ(folder.files(), std::vector<std::string>{"run.h5"});
  EXPECT_EQ(read_record(path).scene, sample_record().scene);
  write_record(path, sample_record());
}

TEST(RecordDamage, FolderThatCannotBeWritten) {
  const ScratchFolder folder;
  EXPECT_THAT(write_failure(folder / "missing/run.h5"), HasSubstr("No such file or directory"));
  EXPECT_THAT(write_failure("/proc/run.h5"), HasSubstr("/proc/run.h5"));
  std::ofstream(folder / "file") << "not a folder";
  EXPECT_THAT(write_failure(folder / "file/run.h5"), HasSubstr("Not a directory"));
  EXPECT_THAT(write_failure(folder.path()), HasSubstr("Is a directory"));
  EXPECT_THROW(require_writable(folder / "missing/run.h5"), RunError);
  EXPECT_NO_THROW(require_writable(folder / "run.h5"));
  EXPECT_EQ(folder.files(), std::vector<std::string>{"file"});
}

TEST(RecordDamage, InconsistentRecordIsNotWritten) {
  const ScratchFolder folder;
  Record record = sample_record();
  record.replicas[1].series[0].value.pop_back();
  EXPECT_THAT(write_failure(folder / "run.h5", record), HasSubstr("temperature"));
  record = sample_record();
  record.replicas[1].series.pop_back();
  EXPECT_THAT(write_failure(folder / "run.h5", record), HasSubstr("different quantities"));
  record = sample_record();
  record.trajectory[1].velocity.pop_back();
  EXPECT_THAT(write_failure(folder / "run.h5", record), HasSubstr("different numbers"));
  EXPECT_TRUE(folder.files().empty());
}

TEST(RecordDamage, TruncatedFileIsRefusedAtEveryLength) {
  const ScratchFolder folder;
  const std::string path = folder / "run.h5";
  write_record(path, sample_record());
  const auto size = fs::file_size(path);
  for (auto length = size - 1; length > 0; length -= std::min<std::uintmax_t>(length, 1 + length / 40)) {
    fs::resize_file(path, length);
    EXPECT_THAT(read_failure(path), HasSubstr(path)) << "cut at " << length << " of " << size;
  }
  fs::resize_file(path, 0);
  EXPECT_THAT(read_failure(path), HasSubstr(path));
}

TEST(RecordDamage, MissingAndForeignFiles) {
  const ScratchFolder folder;
  EXPECT_THAT(read_failure(folder / "run.h5"), HasSubstr("No such file or directory"));
  EXPECT_THAT(read_failure(folder.path()), HasSubstr("Is a directory"));
  std::ofstream(folder / "text.h5") << "title = 1\n";
  EXPECT_THAT(read_failure(folder / "text.h5"), HasSubstr("file signature not found"));
  {
    const hdf5::Session session;
    const hdf5::Writer root(hdf5::create_file(folder / "other.h5"));
    root.group("somebody-else");
  }
  EXPECT_THAT(read_failure(folder / "other.h5"), HasSubstr("no '/sandglass' group"));
}

TEST(RecordDamage, OtherSchemaIsNamedWithBothVersions) {
  const ScratchFolder folder;
  const std::string path = folder / "run.h5";
  {
    const hdf5::Session session;
    const hdf5::Writer root(hdf5::create_file(path));
    const hdf5::Writer group = root.group("sandglass");
    group.attribute("schema", std::vector<int>{7, 3});
    group.group("provenance").attribute("program_version", "9.9");
  }
  const std::string message = read_failure(path);
  EXPECT_THAT(message, HasSubstr("schema 7.3"));
  EXPECT_THAT(message, HasSubstr("Sandglass 9.9"));
  EXPECT_THAT(message, HasSubstr("this program reads schema 1.x"));
  EXPECT_THAT(message, HasSubstr("run its scene again"));
}

TEST(RecordDamage, LaterMinorSchemaIsRead) {
  const ScratchFolder folder;
  write_record(folder / "run.h5", sample_record());
  {
    const hdf5::Session session;
    const hdf5::Handle file(H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    hdf5::Handle group(H5Gopen2(file, "sandglass", H5P_DEFAULT), H5Gclose);
    hdf5::require(H5Adelete(group, "schema"));
    const hdf5::Writer writer(std::move(group));
    writer.attribute("schema", std::vector<int>{1, 9});
    writer.group("something-new");
  }
  EXPECT_EQ(read_record(folder / "run.h5").scene, sample_record().scene);
}

/// Names of all datasets below a group.
std::vector<std::string> datasets_of(const std::string& path, const std::string& group) {
  std::vector<std::string> found;
  const auto collect = [](hid_t, const char* name, const H5O_info_t* info, void* list) -> herr_t {
    if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  const hdf5::Session session;
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  hdf5::require(
      H5Ovisit_by_name(file, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, collect, &found, H5P_DEFAULT));
  for (std::string& name : found) name = group + "/" + name;
  return found;
}

/// Changes the last byte of a dataset, as an editor of HDF5 files would; false when it holds none.
bool flip_last_byte(const std::string& path, const std::string& dataset) {
  const hdf5::Session session;
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const hdf5::Handle place(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  const hdf5::Handle type(H5Dget_type(place), H5Tclose), space(H5Dget_space(place), H5Sclose);
  const auto size = H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  if (size == 0) return false;
  std::string bytes(size, '\0');
  hdf5::require(H5Dread(place, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()));
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  hdf5::require(H5Dwrite(place, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()));
  return true;
}

/// Restarts went on with edited numbers, or broke on them. `/observables` is for other readers.
TEST(RecordDamage, AnyChangedNumberIsRefused) {
  const ScratchFolder folder;
  const std::string path = folder / "run.h5";
  write_record(path, sample_record());
  std::size_t changed = 0;
  for (const char* group : {"sandglass", "particles"})
    for (const std::string& dataset : datasets_of(path, group)) {
      write_record(path, sample_record());
      if (!flip_last_byte(path, dataset)) continue;
      EXPECT_THAT(read_failure(path), HasSubstr("does not match its checksum")) << dataset;
      ++changed;
    }
  EXPECT_GT(changed, 40u);
}

/// Without checksums, as other programs write them, a record is read and a state is not.
TEST(RecordDamage, AStateWithoutChecksumsIsRefused) {
  const ScratchFolder folder;
  const std::string path = folder / "run.h5";
  const auto unseal = [&](const std::string& dataset) {
    const hdf5::Session session;
    const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    hdf5::require(H5Adelete_by_name(file, dataset.c_str(), "checksum", H5P_DEFAULT));
  };
  write_record(path, sample_record());
  unseal("sandglass/seed");
  EXPECT_EQ(read_record(path).replicas.size(), sample_record().replicas.size());
  unseal("sandglass/state/time");
  EXPECT_THAT(read_failure(path), HasSubstr("'/sandglass/state/time': has no checksum"));
}

[[noreturn]] void write_checkpoints_forever(const std::string& path) {
  Record record = sample_record();
  while (true) {
    ++record.state->step;
    write_record(path, record);
  }
}

/// Waits, at most a minute, until the child has written its first checkpoint.
bool wait_for(const std::string& path) {
  for (int tries = 0; tries < 60000 && !fs::exists(path); ++tries) ::usleep(1000);
  return fs::exists(path);
}

TEST(RecordDamage, KilledWriterLeavesTheLastCheckpoint) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  for (useconds_t round = 0; round < 20; ++round) {
    fs::remove(path);
    const pid_t child = fork();
    if (child == 0) write_checkpoints_forever(path);
    const bool started = wait_for(path);
    ::usleep(1700 * round);  // each round strikes at another moment of the write
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ASSERT_TRUE(started) << "no checkpoint was written within a minute";
    EXPECT_GT(read_record(path).state->step, sample_record().state->step);
  }
}

}  // namespace
}  // namespace sandglass::damage_test
