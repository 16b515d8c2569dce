#pragma once

#include <bit>
#include <cstdint>

#include <Random123/philox.h>

namespace sandglass {

/// Registry of every random stream. A stream is named by (seed, purpose, replica, step, index), never by process.
enum class Purpose : std::uint64_t {
  positions = 1,      ///< index: particle
  velocities = 2,     ///< index: particle
  collisions = 3,     ///< index: cell
  equilibration = 4,  ///< index: cell; the elastic collisions before time zero
  crossings = 5,      ///< index: direction; velocities drawn from the flux distribution
  walls = 6,          ///< step: particle, index: its changes of flight; draws at a wall or an obstacle
  species = 7,        ///< index: 0; which particle is of which species
  spins = 8,          ///< index: particle
  sources = 9,        ///< step: source, index: its particle; where it appears
  entry = 10,         ///< index: (cell, place); moves into cells that may refuse them
  lattice = 11,       ///< index: 0; where the cells of a step are displaced to
  inflow = 12,        ///< step: inflow, index: its particle; where, when and how it enters
  arrivals = 13,      ///< index: inflow; how many enter in a step
  cloning =
      14,  ///< index: (cell, place) before the step; copies of who crosses into a region of another weight
  places = 15,  ///< step: who comes in, index: its waits; another place where the first is taken
};

/// What all streams of one purpose share in one step. Philox4x64-10 (Salmon et al. 2011) mixes the four names.
struct StreamKey {
  std::uint64_t low = 0, high = 0;

  StreamKey() = default;
  StreamKey(std::uint64_t seed, Purpose purpose, std::uint64_t replica, std::uint64_t step) {
    const r123::Philox4x64 philox;
    const auto words = philox({{step, replica, static_cast<std::uint64_t>(purpose), 0}}, {{seed, 0x5a4d47}});
    low = words[0];
    high = words[1];
  }
};

/// xoroshiro128++ (Blackman & Vigna 2021), seeded per stream: 1 ns a draw and 3 ns to seed, where Philox takes 10.
class Random {
 public:
  Random() = default;  ///< no stream: to be assigned to
  Random(const StreamKey& key, std::uint64_t index)
      : a_(mix(key.low + index * 0x9e3779b97f4a7c15u)),
        b_(mix(key.high ^ (index * 0xd1342543de82ef95u)) | 1u) {}

  std::uint64_t bits() {
    const std::uint64_t a = a_;
    std::uint64_t b = b_;
    const std::uint64_t result = std::rotl(a + b, 17) + a;
    b ^= a;
    a_ = std::rotl(a, 49) ^ b ^ (b << 21);
    b_ = std::rotl(b, 28);
    return result;
  }

  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  using result_type = std::uint64_t;
  result_type operator()() { return bits(); }
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~std::uint64_t{0}; }

 private:
  /// Finalizer of SplitMix64 (Steele, Lea & Flood 2014).
  static std::uint64_t mix(std::uint64_t word) {
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
    word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
    return word ^ (word >> 31);
  }

  std::uint64_t a_, b_;
};

}  // namespace sandglass
