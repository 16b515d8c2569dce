#include "sim/space/event_calendar.hpp"

#include <algorithm>

namespace sandglass {

void EventCalendar::start(double width, std::size_t buckets) {
  per_width_ = 1 / width;
  end_ = static_cast<double>(buckets);
  next_ = 0;
  head_ = 0;
  due_.clear();
  bucket_.assign(buckets, {});
  chunk_.clear();
  free_ = kNone;
}

void EventCalendar::add_chunk(Bucket& bucket) {
  std::uint32_t index = free_;
  if (index != kNone) {
    free_ = chunk_[index].below;
  } else {
    index = static_cast<std::uint32_t>(chunk_.size());
    chunk_.emplace_back();
  }
  chunk_[index].below = bucket.chunk;
  bucket = {index, 0};
}

/// Into the sorted part, moving whichever side is shorter.
void EventCalendar::insert(const Entry& entry) {
  const auto begin = due_.begin() + static_cast<std::ptrdiff_t>(head_);
  const auto place = std::upper_bound(begin, due_.end(), entry);
  if (head_ > 0 && place - begin < due_.end() - place) {
    std::move(begin, place, begin - 1);
    *(place - 1) = entry;
    --head_;
  } else {
    due_.insert(place, entry);
  }
}

void EventCalendar::refill() {
  if (next_ == bucket_.size()) return;
  due_.erase(due_.begin(), due_.begin() + static_cast<std::ptrdiff_t>(head_));
  head_ = 0;
  while (due_.size() <= kAhead && next_ < bucket_.size()) {
    const auto sorted = static_cast<std::ptrdiff_t>(due_.size());
    take(bucket_[next_++]);
    std::sort(due_.begin() + sorted, due_.end());
  }
}

/// Moves the entries of a bucket to the end of `due_` and frees its chunks.
void EventCalendar::take(Bucket& bucket) {
  std::uint32_t filled = bucket.filled;
  while (bucket.chunk != kNone) {
    Chunk& chunk = chunk_[bucket.chunk];
    for (std::uint32_t i = 0; i < filled; ++i) due_.push_back({chunk.time[i], chunk.owner[i]});
    filled = Chunk::size;
    const std::uint32_t below = chunk.below;
    chunk.below = free_;
    free_ = bucket.chunk;
    bucket.chunk = below;
  }
}

std::size_t EventCalendar::bytes() const {
  return due_.capacity() * sizeof(Entry) + bucket_.capacity() * sizeof(Bucket) +
         chunk_.capacity() * sizeof(Chunk);
}

}  // namespace sandglass
