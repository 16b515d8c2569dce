#include "sim/base/communicator.hpp"

#include "sim/base/number_lists.hpp"
#include "sim/base/thread_ranks.hpp"

#include <gtest/gtest.h>

namespace sandglass::communicator_test {
namespace {

TEST(Communicator, SumsAreThoseOfAllRanks) {
  on_ranks(4, [](Communicator& ranks) {
    for (std::uint64_t round = 0; round < 20; ++round) {
      const auto sums = sum_over(ranks, {ranks.rank(), round, 1});
      EXPECT_EQ(sums, (std::vector<std::uint64_t>{6, 4 * round, 4}));
    }
  });
}

TEST(Communicator, TheFirstRankAloneGathers) {
  on_ranks(3, [](Communicator& ranks) {
    const std::vector<double> own(ranks.rank(), 0.5);
    const auto all = gather(ranks, bytes_of<double>(own));
    for (std::size_t rank = 0; rank < 3; ++rank)
      EXPECT_EQ(numbers_of<double>(all[rank]).size(), ranks.is_first() ? rank : 0);
  });
}

/// Threads share replicas of a run, and one of them may break while the others go on.
TEST(Communicator, AnErrorOfOneThreadEndsTheOthers) {
  const auto work = [](Communicator& ranks) {
    for (int round = 0; round < 10; ++round) {
      if (round == 5 && ranks.rank() == 1) throw InputError("the second one");
      collect<int>(ranks, {round});
    }
  };
  try {
    on_ranks(3, work);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("the second one"), std::string::npos);
  }
}

TEST(NumberLists, ComeOutAsTheyWentIn) {
  std::vector<double> message;
  const std::vector<std::vector<double>> lists = {{1, 2}, {}, {-0.5}};
  for (const auto& list : lists) append_list(message, list);
  NumberLists all(message);
  for (const auto& list : lists) EXPECT_EQ(all.take(), list);
  EXPECT_FALSE(all.any());
}

}  // namespace
}  // namespace sandglass::communicator_test
