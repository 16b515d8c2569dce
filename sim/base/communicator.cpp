#include "sim/base/communicator.hpp"

#include <utility>

namespace sandglass {

std::vector<Communicator::Bytes> gather(Communicator& ranks, Communicator::Bytes message) {
  std::vector<Communicator::Bytes> messages(ranks.count());
  messages.front() = std::move(message);
  return ranks.exchange(messages);
}

std::vector<std::uint64_t> sum_over(Communicator& ranks, const std::vector<std::uint64_t>& numbers) {
  std::vector<std::uint64_t> sums(numbers.size());
  for (const auto& own : collect(ranks, numbers))
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += own.at(i);
  return sums;
}

}  // namespace sandglass
