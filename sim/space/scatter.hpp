#pragma once

#include "sim/space/huge_page_allocator.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sandglass {

template <class T>
using Column = std::vector<T, HugePageAllocator<T>>;

/// CellPlace of a particle after the coming sort: its cell and its rank among the arrivals there.
struct CellPlace {
  std::uint32_t cell, rank;
};

/// Every address is known beforehand: the line of a particle this far ahead is on its way while others are copied.
inline constexpr std::size_t kAhead = 12;

/// Copies every value to its place and calls visit(cell, value); `begin` is where each cell begins.
template <class T, class Visit>
void scatter(const Column<T>& from, const Column<CellPlace>& places, const std::uint32_t* begin,
             Column<T>& to, Visit visit) {
  const T* source = from.data();
  const CellPlace* place = places.data();
  T* target = to.data();
  const auto slot = [begin, place](std::size_t i) { return begin[place[i].cell] + place[i].rank; };
  const std::size_t count = from.size(), ahead = count > kAhead ? count - kAhead : 0;
  const auto copy = [&](std::size_t i) {
    target[slot(i)] = source[i];
    visit(place[i].cell, source[i]);
  };
  for (std::size_t i = 0; i < ahead; ++i) {
    __builtin_prefetch(target + slot(i + kAhead), 1);
    copy(i);
  }
  for (std::size_t i = ahead; i < count; ++i) copy(i);
}
template <class T>
void scatter(const Column<T>& from, const Column<CellPlace>& places, const std::uint32_t* begin,
             Column<T>& to) {
  scatter(from, places, begin, to, [](std::uint32_t, const T&) {});
}

/// Gives back memory beyond that for `room` values.
template <class T>
void shrink(Column<T>& values, std::size_t room) {
  Column<T> smaller;
  smaller.reserve(room);
  smaller.assign(values.begin(), values.end());
  values.swap(smaller);
}

/// As std::rotate, by places.
template <class T>
void rotate(Column<T>& values, std::size_t first, std::size_t middle, std::size_t last) {
  const auto at = [&values](std::size_t place) {
    return values.begin() + static_cast<std::ptrdiff_t>(place);
  };
  std::rotate(at(first), at(middle), at(last));
}

}  // namespace sandglass
