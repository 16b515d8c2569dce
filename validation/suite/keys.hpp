#pragma once

#include "validation/judge/judge.hpp"
#include "validation/suite/matrix.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

// Which verdict moves when a key of a scene does not reach the method as it is written? The method gets a scene with the key
// wired wrongly, the checks the record with the scene as it is.

namespace sandglass {

/// One run with the key wired wrongly.
struct KeyTrial {
  std::string case_name, variant, point;
  std::string how;    ///< "5% more", "left out"
  std::string check;  ///< the first whose verdict then blocks and did not; empty: none
};

struct KeyResult {
  std::string key, family;       ///< no family: no case writes the key
  bool is_used = false;          ///< some run says more than the default
  std::vector<KeyTrial> trials;  ///< empty though it is used: it cannot be changed alone
  bool seen() const { return !trials.empty() && !trials.back().check.empty(); }
};

struct KeyOptions {
  unsigned jobs = 1;
  Confidence confidence;
  std::vector<std::string>
      known;  ///< all keys there are; those that no case writes come without family and trials
  /// Called with keys done, all keys, and the last one; from one thread at a time.
  std::function<void(std::size_t, std::size_t, const std::string&)> finished;
  const std::atomic<bool>* stop = nullptr;
};

/// For each key and method family of these runs, up to the first verdict that moves: the cheapest runs of six cases that say
/// more than the default, the key 5% off; then the same runs with the key left out.
std::vector<KeyResult> try_keys(const std::vector<Task>& tasks, const KeyOptions& options);

}  // namespace sandglass
