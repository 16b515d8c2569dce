#pragma once

#include "sim/record/export.hpp"

namespace sandglass {

using Paths = std::vector<std::string>;

// One function per format; each writes the paths that the function beside it names.
Paths vtp_paths(const Record& record, const std::string& path);
void export_vtp(const Record& record, const Paths& paths, const ParticleShape& shape);
Paths xyz_paths(const Record& record, const std::string& path);
void export_xyz(const Record& record, const Paths& paths, const ParticleShape& shape);
Paths mdanalysis_paths(const Record& record, const std::string& path);
void export_mdanalysis(const Record& record, const Paths& paths, const ParticleShape& shape);
Paths csv_paths(const Record& record, const std::string& path);
void export_csv(const Record& record, const Paths& paths, const ParticleShape& shape);

/// vector[particle][3] from vector[particle][dimension]: z = 0 in two dimensions.
std::vector<double> in_space(const std::vector<double>& vectors, int dimension);

/// The trajectory; of a checkpoint without one the particles of its state.
std::vector<Frame> frames_of(const Record& record);

/// Of each particle of a frame.
std::vector<double> diameters_of(const Frame& frame, int dimension, const ParticleShape& shape);

/// Three edges of the box: a flat box is one diameter high, since most programs refuse height zero.
std::vector<double> box_in_space(const Record& record, const ParticleShape& shape);

/// "folder/name" of "folder/name.ending" when the ending is the expected one, else the whole path.
std::string without_ending(const std::string& path, const std::string& ending);

}  // namespace sandglass
