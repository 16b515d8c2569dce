#pragma once

#include "validation/suite/case.hpp"
#include "validation/suite/write_node.hpp"

namespace sandglass {

/// Multiplies the numbers of a scene: run.replicas (rounded), whatever run.duration gives, and with the size every
/// species' count and the edges of the box. Throws InputError, placed at the factors, where that leaves less than one or
/// the scene does not have what is multiplied.
void multiply(OriginNode& scene, const Factors& factors, const std::string& file);

}  // namespace sandglass
