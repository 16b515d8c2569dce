#pragma once

#include "sim/record/record.hpp"

namespace sandglass {

/// What a record's particles look like where all are alike; the record has columns for what species differ in.
struct ParticleShape {
  double diameter = 1;  ///< [length]
};

struct ExportFormat {
  std::string name;
  std::string summary;
};

/// vtp (ParaView), xyz (OVITO), mdanalysis, csv.
const std::vector<ExportFormat>& export_formats();

/// The files that export_record() writes. Throws InputError as it does.
std::vector<std::string> export_paths(const Record& record, const std::string& format,
                                      const std::string& path);

/// Writes `record` for another program and returns the paths of the files written, each whole or not at all.
/// `path` names the main file; frames (vtp) and estimates (csv) go beside it. Two dimensions are padded with
/// z = 0. Throws InputError for an unknown format or a record without the trajectory that the format needs,
/// RunError when a file cannot be written.
std::vector<std::string> export_record(const Record& record, const std::string& format,
                                       const std::string& path, const ParticleShape& shape = {});

}  // namespace sandglass
