#pragma once

#include "validation/check/subject.hpp"
#include "validation/law/law.hpp"
#include "validation/law/vibrated_bed.hpp"

namespace sandglass {

/// Smooth particles of one species over a bottom that vibrates, gravity towards it, walls around.
bool is_vibrated_bed(const Scene& scene);

/// The bed of the scene in the terms of the law. A particle has N - 1 partners of N: `layers` is that much smaller.
law::VibratedBed bed_of(const Subject& subject);

/// "y" in two dimensions, "z" in three.
std::string vertical_name(const Scene& scene);

/// When the samples begin that count: after `settle-share` of the run.
double settled_from(const Subject& subject, const law::Arguments& numbers);

/// Mean height of the centre of mass from a time on.
Mean bed_height(const Subject& subject, double from);

}  // namespace sandglass
