#include "sim/program/mpi_communicator.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include <mpi.h>

namespace sandglass::program {

namespace {
using Bytes = Communicator::Bytes;

/// MPI counts in int: longer messages travel in parts.
constexpr std::size_t kPart = std::size_t{1} << 30;

/// Calls send_part(offset, bytes) for each part of a message.
template <class Function>
void for_each_part(std::size_t size, Function part) {
  for (std::size_t offset = 0; offset < size; offset += kPart)
    part(offset, static_cast<int>(std::min(kPart, size - offset)));
}

std::size_t ask(int (*question)(MPI_Comm, int*)) {
  int answer = 0;
  question(MPI_COMM_WORLD, &answer);
  return static_cast<std::size_t>(answer);
}
}  // namespace

MpiCommunicator::MpiCommunicator() : count_(ask(MPI_Comm_size)), rank_(ask(MPI_Comm_rank)) {}

std::vector<Bytes> MpiCommunicator::exchange(const std::vector<Bytes>& messages) {
  std::vector<std::uint64_t> sent, received(count_);
  for (const Bytes& message : messages) sent.push_back(message.size());
  MPI_Alltoall(sent.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::vector<Bytes> answers(count_);
  std::vector<MPI_Request> requests;
  for (std::size_t rank = 0; rank < count_; ++rank) {
    if (rank == rank_) {
      answers[rank] = messages[rank];
      continue;
    }
    const int other = static_cast<int>(rank);
    answers[rank].resize(received[rank]);
    for_each_part(received[rank], [&](std::size_t offset, int size) {
      MPI_Irecv(answers[rank].data() + offset, size, MPI_BYTE, other, 0, MPI_COMM_WORLD,
                &requests.emplace_back());
    });
    for_each_part(sent[rank], [&](std::size_t offset, int size) {
      MPI_Isend(messages[rank].data() + offset, size, MPI_BYTE, other, 0, MPI_COMM_WORLD,
                &requests.emplace_back());
    });
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return answers;
}

std::vector<Bytes> MpiCommunicator::collect(const Bytes& message) {
  const std::uint64_t own = message.size();
  std::vector<std::uint64_t> sizes(count_);
  MPI_Allgather(&own, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  const std::uint64_t all = std::reduce(sizes.begin(), sizes.end());
  if (all > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    return exchange(std::vector<Bytes>(count_, message));
  std::vector<int> counts(sizes.begin(), sizes.end()), begin(count_);
  std::exclusive_scan(counts.begin(), counts.end(), begin.begin(), 0);
  Bytes together(all);
  MPI_Allgatherv(message.data(), static_cast<int>(own), MPI_BYTE, together.data(), counts.data(),
                 begin.data(), MPI_BYTE, MPI_COMM_WORLD);
  std::vector<Bytes> answers;
  for (std::size_t rank = 0; rank < count_; ++rank)
    answers.emplace_back(together.begin() + begin[rank], together.begin() + begin[rank] + counts[rank]);
  return answers;
}

}  // namespace sandglass::program
