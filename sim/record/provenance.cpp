#include "sim/record/provenance.hpp"

#include "sandglass_build.hpp"
#include "sandglass_commit.hpp"

#include <ctime>

namespace sandglass {
namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[sizeof "2000-01-01T00:00:00Z"];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

Provenance current_provenance() {
  return {SANDGLASS_BUILD_VERSION, SANDGLASS_BUILD_COMMIT, SANDGLASS_BUILD_FLAGS, utc_now(), ""};
}

}  // namespace sandglass
