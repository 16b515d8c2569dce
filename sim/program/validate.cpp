#include "sim/base/error.hpp"
#include "sim/program/options.hpp"

namespace sandglass::program {

int validate(const Options&) { throw InputError("validate: not built yet"); }

}  // namespace sandglass::program
