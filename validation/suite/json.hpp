#pragma once

#include "validation/suite/outcome.hpp"

#include <nlohmann/json.hpp>

namespace sandglass {

using Json = nlohmann::ordered_json;

/// One entry of verdicts.json.
Json verdict_json(const Outcome& outcome, const CheckOutcome& check);
Json figure_json(const Figure& figure);
Json run_json(const RunSummary& run);

}  // namespace sandglass
