#include "sim/base/saved.hpp"

#include "sim/base/error.hpp"

namespace sandglass {

void refuse_saved(const std::string& what) {
  throw InputError("the checkpoint holds a number that no run leaves there: " + what +
                   "; it was changed or damaged: go on from another one, or run its scene again");
}

}  // namespace sandglass
