#include "sim/method/counts_of_ranks.hpp"

#include "sim/base/number_lists.hpp"

namespace sandglass {

template <int D>
void CountsOfRanks<D>::gather(Communicator& ranks) {
  const auto messages = sandglass::gather(ranks, packed());
  if (!ranks.is_first()) return clear();
  for (std::size_t rank = 1; rank < messages.size(); ++rank) add(numbers_of<double>(messages[rank]));
}

template <int D>
Communicator::Bytes CountsOfRanks<D>::packed() const {
  std::vector<double> numbers;
  Memory memory;
  tally.save(memory);
  for (const auto& [name, list] : memory) append_list(numbers, list);
  for (const std::uint64_t* count : others) append_list(numbers, {static_cast<double>(*count)});
  if (planes != nullptr)
    for (const Plane& plane : *planes) append_list(numbers, plane.save());
  if (impulses != nullptr) append_list(numbers, impulses->save());
  return bytes_of<double>(numbers);
}

template <int D>
void CountsOfRanks<D>::add(const std::vector<double>& numbers) {
  NumberLists lists(numbers);
  Memory memory;
  tally.save(memory);
  for (auto& [name, list] : memory) list = lists.take();
  Tally theirs = tally;
  theirs.load(memory);
  tally.add(theirs);
  for (std::uint64_t* count : others) *count += static_cast<std::uint64_t>(lists.take().at(0));
  if (planes != nullptr)
    for (Plane& plane : *planes) {
      Plane passed = plane;
      passed.load(lists.take());
      plane.add(passed);
    }
  if (impulses == nullptr) return;
  WallImpulses<D> given;
  given.load(lists.take());
  impulses->add(given);
}

template <int D>
void CountsOfRanks<D>::clear() {
  tally.clear();
  for (std::uint64_t* count : others) *count = 0;
  if (planes != nullptr)
    for (Plane& plane : *planes) plane.clear();
  if (impulses != nullptr) *impulses = {};
}

template struct CountsOfRanks<2>;
template struct CountsOfRanks<3>;

}  // namespace sandglass
