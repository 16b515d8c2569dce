#pragma once

#include "sim/base/communicator.hpp"

#include <optional>
#include <string>

namespace sandglass::program {

/// What ends a command.
struct Failure {
  std::string words;        ///< empty: another rank says it
  int code;                 ///< with which the program ends
  bool everywhere = false;  ///< all ranks know and end with this code
};

/// Of the exception that is being handled.
Failure current_failure();

/// Throws the failure of the first rank that has one, on all ranks. `ranks` may be null.
void fail_together(Communicator* ranks, const std::optional<Failure>& own);

/// Does work that any rank may fail in, without messages in between.
template <class Work>
auto together(Communicator* ranks, Work work) {
  std::optional<decltype(work())> result;
  std::optional<Failure> failure;
  try {
    result = work();
  } catch (...) {
    if (ranks == nullptr) throw;
    failure = current_failure();
  }
  fail_together(ranks, failure);
  return std::move(*result);
}

}  // namespace sandglass::program
