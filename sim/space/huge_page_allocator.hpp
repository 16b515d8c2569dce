#pragma once

#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace sandglass {

/// Aligns to cache lines; asks for huge pages where an array spans several, so that a scatter does not miss the
/// page table at every store. Keeps two cache lines behind the array for those who read past its end.
template <class T>
struct HugePageAllocator {
  using value_type = T;

  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t page = count * sizeof(T) >= 4 * kHugePage ? kHugePage : 64;
    const std::size_t bytes = (count * sizeof(T) + 128 + page - 1) / page * page;
    void* memory = std::aligned_alloc(page, bytes);
    if (memory == nullptr) throw std::bad_alloc();
    if (page == kHugePage) madvise(memory, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  template <class U>
  bool operator==(const HugePageAllocator<U>&) const {
    return true;
  }

 private:
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;
};

}  // namespace sandglass
