#pragma once

#include "sim/base/communicator.hpp"

namespace sandglass::program {

/// All processes that MPI has started.
class MpiCommunicator final : public Communicator {
 public:
  /// MPI must be up, and stay so.
  MpiCommunicator();

  std::size_t count() const override { return count_; }
  std::size_t rank() const override { return rank_; }
  std::vector<Bytes> exchange(const std::vector<Bytes>& messages) override;
  std::vector<Bytes> collect(const Bytes& message) override;

 private:
  std::size_t count_, rank_;
};

}  // namespace sandglass::program
