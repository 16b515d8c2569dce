#pragma once

#include "sim/base/communicator.hpp"
#include "sim/base/error.hpp"

#include <atomic>
#include <barrier>
#include <exception>
#include <thread>
#include <utility>

namespace sandglass {

/// Where the messages of all ranks lie until they are fetched.
struct MessageBoard {
  explicit MessageBoard(std::size_t ranks) : messages(ranks), barrier(static_cast<std::ptrdiff_t>(ranks)) {}
  std::vector<std::vector<Communicator::Bytes>> messages;  ///< [from][to]
  std::barrier<> barrier;
  std::atomic<bool> left{false};  ///< a rank has ended with an error
};

/// What the other ranks end with then.
class RankLeft : public RunError {
 public:
  RankLeft() : RunError("another rank has ended") {}
};

/// A rank that is a thread of this process.
class ThreadCommunicator : public Communicator {
 public:
  ThreadCommunicator(MessageBoard& board, std::size_t rank) : board_(board), rank_(rank) {}

  std::size_t count() const override { return board_.messages.size(); }
  std::size_t rank() const override { return rank_; }
  std::vector<Bytes> exchange(const std::vector<Bytes>& messages) override {
    board_.messages[rank_] = messages;
    meet();
    std::vector<Bytes> received;
    for (const auto& sent : board_.messages) received.push_back(sent[rank_]);
    meet();
    return received;
  }
  std::vector<Bytes> collect(const Bytes& message) override {
    return ThreadCommunicator::exchange(std::vector<Bytes>(count(), message));
  }

 private:
  void meet() {
    board_.barrier.arrive_and_wait();
    if (board_.left) throw RankLeft();
  }

  MessageBoard& board_;
  std::size_t rank_;
};

/// Calls work(communicator) on each rank; throws what the first of them has thrown of its own accord.
template <class Ranks = ThreadCommunicator, class Work>
void on_ranks(std::size_t count, Work work) {
  MessageBoard board(count);
  std::vector<std::exception_ptr> errors(count);
  std::vector<std::thread> threads;
  for (std::size_t rank = 0; rank < count; ++rank)
    threads.emplace_back([&, rank] {
      Ranks ranks(board, rank);
      try {
        work(ranks);
      } catch (const RankLeft&) {
        board.barrier.arrive_and_drop();
      } catch (...) {
        errors[rank] = std::current_exception();
        board.left = true;
        board.barrier.arrive_and_drop();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace sandglass
