#include "sim/program/failure.hpp"

#include "sim/base/error.hpp"
#include "sim/program/options.hpp"
#include "sim/run/run.hpp"

#include <new>

namespace sandglass::program {

Failure current_failure() {
  try {
    throw;
  } catch (const Failure& failure) {
    return failure;
  } catch (const InputError& error) {
    return {error.what(), bad_input};
  } catch (const Interrupted& stop) {
    return {stop.what(), run_broke, stop.everywhere()};
  } catch (const std::bad_alloc&) {
    return {"error: not enough memory; `sandglass plan` says what a scene needs", run_broke};
  } catch (const std::exception& error) {
    return {std::string("error: ") + error.what(), run_broke};
  }
}

void fail_together(Communicator* ranks, const std::optional<Failure>& own) {
  if (ranks == nullptr) return;
  const auto codes = collect<int>(*ranks, {own ? own->code : int{all_well}});
  for (std::size_t rank = 0; rank < codes.size(); ++rank) {
    if (codes[rank].front() == all_well) continue;
    throw Failure{rank == ranks->rank() ? own->words : "", codes[rank].front(), true};
  }
}

}  // namespace sandglass::program
