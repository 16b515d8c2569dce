#include "sim/observe/tally.hpp"

#include "sim/base/saved.hpp"

#include <algorithm>

namespace sandglass {

namespace {
void add_to(std::vector<std::uint64_t>& counts, const std::vector<std::uint64_t>& others) {
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += others.at(i);
}

/// What was not counted before counts from now on; what nobody counts any more is left.
void load_counts(const std::vector<double>& saved, std::vector<std::uint64_t>& counts) {
  if (saved.empty() || counts.empty()) return;
  if (saved.size() != counts.size()) refuse_saved("counts by bin that are not as many as the bins");
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = saved_count(saved[i]);
}
}  // namespace

void Tally::add(const Tally& other) {
  collisions += other.collisions;
  candidates += other.candidates;
  moves += other.moves;
  transfer.add(other.transfer);
  cloning.resize(std::max(cloning.size(), other.cloning.size()));
  for (std::size_t i = 0; i < other.cloning.size(); ++i) cloning[i].add(other.cloning[i]);
  impact.resize(std::max(impact.size(), other.impact.size()));
  if (!other.impact.empty()) add_to(impact, other.impact);
  if (!other.by_species.empty()) add_to(by_species, other.by_species);
  deepest_overlap = std::max(deepest_overlap, other.deepest_overlap);
}

void Tally::clear() {
  const std::size_t bins = impact.size(), pairs = by_species.size(), clones = cloning.size();
  *this = {};
  cloning.resize(clones);
  impact.resize(bins);
  by_species.resize(pairs);
}

void Tally::save(Memory& memory) const {
  memory["tally/counts"] = {static_cast<double>(collisions), static_cast<double>(candidates),
                            static_cast<double>(moves), deepest_overlap};
  memory["tally/transfer"] = transfer.save();
  memory["tally/impact"] = {impact.begin(), impact.end()};
  for (std::size_t i = 0; i < cloning.size(); ++i)
    memory["tally/cloning-" + std::to_string(i)] = cloning[i].save();
  if (!by_species.empty()) memory["tally/by-species"] = {by_species.begin(), by_species.end()};
}

void Tally::load(const Memory& memory) {
  const std::vector<double>& counts = memory.at("tally/counts");
  collisions = saved_count(counts.at(0));
  candidates = saved_count(counts.at(1));
  moves = saved_count(counts.at(2));
  deepest_overlap = saved_number(counts.at(3), -HUGE_VAL, HUGE_VAL, "an overlap");
  transfer = ExactSum::load(memory.at("tally/transfer"));
  load_counts(memory.at("tally/impact"), impact);
  for (std::size_t i = 0; i < cloning.size(); ++i)
    cloning[i] = ExactSum::load(memory.at("tally/cloning-" + std::to_string(i)));
  if (memory.contains("tally/by-species")) load_counts(memory.at("tally/by-species"), by_species);
}

}  // namespace sandglass
