#include "sim/program/memory.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

namespace sandglass::program {

namespace {
double bytes_of_particles(const Plan& plan) {
  return plan.bytes_per_particle * static_cast<double>(std::max(plan.particles, plan.most_particles));
}

double bytes_of_machine() {
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
}
}  // namespace

std::string memory_words(const Plan& plan) {
  std::string words = "unknown: the scene does not say how many particles come";
  if (plan.particles > 0)
    words = fmt::format("{:.0f} bytes a particle, {:.3g} MB", plan.bytes_per_particle,
                        bytes_of_particles(plan) / 1e6);
  if (std::isfinite(plan.bytes_of_samples))
    words += fmt::format("; {:.3g} MB of samples", plan.bytes_of_samples / 1e6);
  if (exceeds_memory(plan)) words += fmt::format("; this machine has {:.3g} MB", bytes_of_machine() / 1e6);
  return words;
}

bool exceeds_memory(const Plan& plan) {
  double bytes = 0;
  for (const double part : {bytes_of_particles(plan), plan.bytes_of_samples})
    if (std::isfinite(part)) bytes += part;
  return bytes > bytes_of_machine();
}

}  // namespace sandglass::program
