#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace sandglass {

/// How the processes that carry out one run together exchange messages. They are numbered from 0, their ranks, and all make
/// the same calls in the same order.
class Communicator {
 public:
  using Bytes = std::vector<std::byte>;

  virtual ~Communicator() = default;
  virtual std::size_t count() const = 0;
  virtual std::size_t rank() const = 0;
  /// Sends a message to each rank; returns those from each.
  virtual std::vector<Bytes> exchange(const std::vector<Bytes>& messages) = 0;
  /// The messages of all ranks, on all ranks.
  virtual std::vector<Bytes> collect(const Bytes& message) = 0;

  bool is_first() const { return rank() == 0; }
};

template <class T>
Communicator::Bytes bytes_of(std::span<const T> numbers) {
  const auto bytes = std::as_bytes(numbers);
  return {bytes.begin(), bytes.end()};
}

template <class T>
std::vector<T> numbers_of(const Communicator::Bytes& bytes) {
  std::vector<T> numbers(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(T));
  return numbers;
}

/// The numbers of all ranks, on all ranks.
template <class T>
std::vector<std::vector<T>> collect(Communicator& ranks, const std::vector<T>& numbers) {
  std::vector<std::vector<T>> all;
  for (const auto& bytes : ranks.collect(bytes_of<T>(numbers))) all.push_back(numbers_of<T>(bytes));
  return all;
}

/// The same on the first rank alone; empty lists elsewhere.
std::vector<Communicator::Bytes> gather(Communicator& ranks, Communicator::Bytes message);

/// Sums over the ranks, number by number.
std::vector<std::uint64_t> sum_over(Communicator& ranks, const std::vector<std::uint64_t>& numbers);

}  // namespace sandglass
