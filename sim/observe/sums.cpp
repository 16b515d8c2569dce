#include "sim/observe/sums.hpp"

namespace sandglass {

void add_over_ranks(Communicator& ranks, std::span<ExactSum> sums) {
  std::vector<double> own;
  for (const ExactSum& sum : sums) {
    const std::vector<double> state = sum.save();
    own.insert(own.end(), state.begin(), state.end());
  }
  std::ranges::fill(sums, ExactSum());
  for (const std::vector<double>& states : collect(ranks, own)) {
    const std::size_t size = states.size() / sums.size();
    auto from = states.begin();
    for (ExactSum& sum : sums) {
      sum.add(ExactSum::load({from, from + static_cast<std::ptrdiff_t>(size)}));
      from += static_cast<std::ptrdiff_t>(size);
    }
  }
}

}  // namespace sandglass
