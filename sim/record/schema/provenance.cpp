#include "sim/record/schema/provenance.hpp"

#include "sim/record/schema/names.hpp"

#include <fmt/format.h>

namespace sandglass::schema {

void write_provenance(const hdf5::Writer& group, const Provenance& provenance) {
  group.attribute("program_version", provenance.program_version);
  group.attribute("commit", provenance.commit);
  group.attribute("build", provenance.build);
  group.attribute("created", provenance.created);
  group.attribute("mutation", provenance.planted_fault);
}

Provenance read_provenance(const hdf5::Reader& group) {
  return {group.word("program_version"), group.word("commit"), group.word("build"), group.word("created"),
          group.word("mutation")};
}

void require_version(const hdf5::Reader& file) {
  if (!file.has(names::root) || !file.group(names::root).has_attribute(names::version))
    throw hdf5::Failure(
        fmt::format("the file has no '/{}' group with a '{}' attribute", names::root, names::version));
  const std::vector<int> found = file.group(names::root).attribute<int>(names::version);
  if (found.size() != 2)
    file.group(names::root).fail(names::version, "does not hold two numbers, major and minor");
  if (found[0] == version_major) return;
  const std::string writer = file.group(names::root).has(names::provenance)
                                 ? file.group(names::root).group(names::provenance).word("program_version")
                                 : "unknown";
  throw hdf5::Failure(fmt::format(
      "it has schema {}.{} (written by Sandglass {}), this program reads schema {}.x up to {}.{}; "
      "read it with the Sandglass that wrote it, or run its scene again with this one",
      found[0], found[1], writer, version_major, version_major, version_minor));
}

}  // namespace sandglass::schema
