#include "sim/method/event_driven/check_codes.hpp"

#include "sim/base/error.hpp"
#include "sim/method/event_driven/particle.hpp"

#include <fmt/format.h>

namespace sandglass::event_driven {

void check_codes(std::uint64_t particles, std::uint64_t agents) {
  constexpr std::uint64_t most_particles = kFirstAgent, most_agents = kNobody - kFirstAgent;
  if (particles > most_particles)
    throw InputError(
        fmt::format("{} particles: the event-driven method takes at most {}; lower "
                    "'species.count' or take a smaller box",
                    particles, most_particles));
  if (agents > most_agents)
    throw InputError(
        fmt::format("{} walls, obstacles and planes: the event-driven method takes at most {}; remove some "
                    "obstacles",
                    agents, most_agents));
}

}  // namespace sandglass::event_driven
