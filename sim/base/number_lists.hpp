#pragma once

#include <cstddef>
#include <vector>

namespace sandglass {

/// Appends a list of numbers to a message, after its length.
inline void append_list(std::vector<double>& message, const std::vector<double>& list) {
  message.push_back(static_cast<double>(list.size()));
  message.insert(message.end(), list.begin(), list.end());
}

/// Takes the lists of a message out again, one after the other.
class NumberLists {
 public:
  /// `message` must outlive it.
  explicit NumberLists(const std::vector<double>& message) : message_(message) {}
  bool any() const { return next_ < message_.size(); }
  std::vector<double> take() {
    const auto count = static_cast<std::size_t>(message_.at(next_));
    const auto first = message_.begin() + static_cast<std::ptrdiff_t>(next_ + 1);
    next_ += 1 + count;
    return {first, first + static_cast<std::ptrdiff_t>(count)};
  }

 private:
  const std::vector<double>& message_;
  std::size_t next_ = 0;
};

}  // namespace sandglass
