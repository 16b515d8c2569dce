#pragma once

#include "sim/space/huge_page_allocator.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace sandglass {

/// Times of events to come, earliest first, at a constant cost per event: a row of buckets of equal width, of which only the
/// first few are sorted (Brown 1988; Paul 2007). Nothing is ever taken out of the middle: who reads an entry compares its
/// time with the one that its owner now has and passes over what is out of date, so that a change touches no line of memory
/// but the end of one bucket. The row covers one era; what lies beyond it is left to the owner, who starts the next.
class EventCalendar {
 public:
  struct Entry {
    double time;
    std::uint32_t owner;
    bool operator<(const Entry& other) const {
      return time != other.time ? time < other.time : owner < other.owner;
    }
  };

  /// Forgets everything. The row begins at time zero and has `buckets` of `width`.
  void start(double width, std::size_t buckets);

  /// `time` is not negative, may be infinite.
  [[gnu::noinline]] void push(double time, std::uint32_t owner) {
    const double place = time * per_width_;
    if (!(place < end_)) return;
    const auto bucket = static_cast<std::uint32_t>(place);
    if (bucket < next_) return insert({time, owner});
    append(bucket, time, owner);
  }

  /// The earliest entry, or null when the era is over.
  const Entry* front() {
    if (head_ + kAhead >= due_.size()) [[unlikely]]
      refill();
    return head_ < due_.size() ? &due_[head_] : nullptr;
  }
  void pop() { ++head_; }
  /// The entry `ahead` places behind the front, for prefetching; null if it is not sorted yet.
  const Entry* peek(std::size_t ahead) const {
    return head_ + ahead < due_.size() ? &due_[head_ + ahead] : nullptr;
  }

  double width() const { return 1 / per_width_; }
  std::size_t buckets() const { return bucket_.size(); }
  std::size_t bytes() const;

 private:
  static constexpr std::size_t kAhead = 24;  ///< entries that are sorted before they are needed
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Two cache lines of entries.
  struct alignas(64) Chunk {
    static constexpr std::uint32_t size = 10;
    double time[size];
    std::uint32_t owner[size];
    std::uint32_t below;  ///< the chunk filled before this one, or the next free one
  };
  struct Bucket {
    std::uint32_t chunk = kNone;
    std::uint32_t filled = Chunk::size;  ///< entries in that chunk
  };

  void append(std::uint32_t bucket, double time, std::uint32_t owner) {
    Bucket& end = bucket_[bucket];
    if (end.filled == Chunk::size) [[unlikely]]
      add_chunk(end);
    Chunk& chunk = chunk_[end.chunk];
    chunk.time[end.filled] = time;
    chunk.owner[end.filled++] = owner;
  }
  void add_chunk(Bucket& bucket);
  void insert(const Entry& entry);
  void refill();
  void take(Bucket& bucket);

  double per_width_ = 1, end_ = 0;
  std::uint32_t next_ = 0;  ///< first bucket that is not sorted yet
  std::size_t head_ = 0;    ///< first entry of `due_` that is still to come
  std::vector<Entry> due_;  ///< sorted
  std::vector<Bucket, HugePageAllocator<Bucket>> bucket_;
  std::vector<Chunk, HugePageAllocator<Chunk>> chunk_;
  std::uint32_t free_ = kNone;
};

}  // namespace sandglass
