#include "sim/observe/tally.hpp"

namespace sandglass {

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
  collisions = static_cast<std::uint64_t>(counts.at(0));
  candidates = static_cast<std::uint64_t>(counts.at(1));
  moves = static_cast<std::uint64_t>(counts.at(2));
  deepest_overlap = counts.at(3);
  transfer = ExactSum::load(memory.at("tally/transfer"));
  const std::vector<double>& bins = memory.at("tally/impact");
  impact.assign(bins.begin(), bins.end());
  for (std::size_t i = 0; i < cloning.size(); ++i)
    cloning[i] = ExactSum::load(memory.at("tally/cloning-" + std::to_string(i)));
  if (by_species.empty()) return;
  const std::vector<double>& pairs = memory.at("tally/by-species");
  by_species.assign(pairs.begin(), pairs.end());
}

}  // namespace sandglass
