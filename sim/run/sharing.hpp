#pragma once

#include "sim/scene/scene.hpp"

namespace sandglass {

/// How ranks share the work of a run: the cells of every replica, or whole replicas.
enum class Sharing { none, cells, replicas };

/// Throws InputError where a scene can be shared in neither way, naming what forbids it and what to do. `goes_on`: from a
/// checkpoint. Whole replicas need no messages; but a checkpoint holds one that is under way, and asks for cells.
Sharing sharing_of(const Scene& scene, std::size_t ranks, bool goes_on);

}  // namespace sandglass
