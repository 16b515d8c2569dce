#include "sim/run/sharing.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <fmt/format.h>

namespace sandglass {

Sharing sharing_of(const Scene& scene, std::size_t ranks, bool goes_on) {
  if (ranks == 1) return Sharing::none;
  const bool restarts = goes_on || scene.output.checkpoint;
  if (scene.run.replicas >= ranks && !restarts) return Sharing::replicas;
  const std::string whole = kept_whole(scene);
  if (whole.empty()) return Sharing::cells;
  if (scene.run.replicas < ranks)
    throw InputError(
        fmt::format("started on {} ranks, but {} keeps the cells of a replica on one rank, and there "
                    "are not as many replicas; start it on one rank, or set 'run.replicas' to {} or more",
                    ranks, whole, ranks));
  throw InputError(
      fmt::format("started on {} ranks, but {} keeps the cells of a replica on one rank, and ranks "
                  "that share replicas neither write nor read checkpoints; start it on one rank{}",
                  ranks, whole, goes_on ? "" : ", or remove 'output.checkpoint'"));
}

}  // namespace sandglass
