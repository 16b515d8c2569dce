#include "sim/method/collisionless/collisionless.hpp"

namespace sandglass::collisionless {

template <int D>
void Collisionless<D>::step(double dt, std::uint64_t step) {
  this->store_.begin_step();
  this->fly(0, this->store_.size(), this->motion_step(faults_.flight * dt, step));
  this->end_step(dt, step);
}

template class Collisionless<2>;
template class Collisionless<3>;

}  // namespace sandglass::collisionless
