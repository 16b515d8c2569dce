#include "sim/method/event_driven/era.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::event_driven {

namespace {
constexpr double kEventsPerEra = 12;
constexpr double kFewestPerBucket = 16, kMostPerBucket = 256;
constexpr double kParticlesPerEntry =
    1000;  // with more particles fewer, fuller buckets: their ends stay in the cache
constexpr double kFewestBuckets = 64;
constexpr double kMostEventsPerEra = 100;
constexpr double kInstant = 1e-300;
}  // namespace

template <int D>
Era plan_era(const Gas<D>& gas) {
  std::vector<double> delays;
  for (const Next& next : gas.next)
    if (next.time > 0 && next.time < HUGE_VAL) delays.push_back(next.time);
  if (delays.empty()) {
    // Simultaneous contacts say nothing of the times to come: they have an era of their own, too short for anything else.
    const bool now = std::ranges::any_of(gas.next, [](const Next& next) { return next.time <= 0; });
    return now ? Era{kInstant, 1} : Era{};
  }
  const auto middle = delays.begin() + static_cast<std::ptrdiff_t>(delays.size() / 2);
  std::nth_element(delays.begin(), middle, delays.end());
  // The median of an exponential distribution is ln 2 times its mean.
  const double interval = std::max(*middle / M_LN2, kInstant);
  const double count = static_cast<double>(delays.size());
  const double per_bucket = std::clamp(count / kParticlesPerEntry, kFewestPerBucket, kMostPerBucket);
  const double buckets = std::max(kFewestBuckets, std::ceil(kEventsPerEra * count / per_bucket));
  return {kEventsPerEra * interval / buckets, static_cast<std::size_t>(buckets),
          static_cast<std::uint64_t>(kMostEventsPerEra * (count + kFewestBuckets))};
}

template <int D>
std::vector<std::uint32_t> order_by_cell(const Gas<D>& gas, const Cells<D>& cells) {
  std::vector<std::uint32_t> first(cells.size() + 1), order(gas.size());
  for (const Next& next : gas.next) ++first[cells.linear(next.cell) + 1];
  for (std::size_t cell = 1; cell < first.size(); ++cell) first[cell] += first[cell - 1];
  for (std::uint32_t i = 0; i < gas.size(); ++i) order[first[cells.linear(gas.next[i].cell)]++] = i;
  return order;
}

template <int D>
double speed_scale(const Gas<D>& gas) {
  double square = 0;
  for (const Particle<D>& particle : gas.particles) square += particle.velocity.squaredNorm();
  return gas.size() > 0 ? std::sqrt(square / gas.size()) : 0;
}

template Era plan_era(const Gas<2>&);
template Era plan_era(const Gas<3>&);
template std::vector<std::uint32_t> order_by_cell(const Gas<2>&, const Cells<2>&);
template std::vector<std::uint32_t> order_by_cell(const Gas<3>&, const Cells<3>&);
template double speed_scale(const Gas<2>&);
template double speed_scale(const Gas<3>&);

}  // namespace sandglass::event_driven
