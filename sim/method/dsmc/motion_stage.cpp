#include "sim/method/dsmc/motion_stage.hpp"

#include "sim/space/flight.hpp"

namespace sandglass::dsmc {

namespace {

enum class Walls { none, specular };

template <int D, bool Gravity, Walls Sides, bool Crossings>
class MotionKernel final : public MotionStage<D> {
 public:
  explicit MotionKernel(const MotionParameters<D>& parameters) : parameters_(parameters) {}

  void advance(ParticleStore<D>& store, std::size_t first, std::size_t last, double dt) const override {
    const Grid<D> grid = store.grid();
    const Vector<D> per_box = grid.box().cwiseInverse();
    Phase<D>* particles = store.phases().data();
    std::uint32_t* destination = store.destination();
    std::uint32_t* arrivals = store.arrivals();
    for (std::size_t i = first; i < last; ++i) {
      Phase<D>& particle = particles[i];
      if constexpr (Crossings) count_crossings(particle, grid.box(), dt);
      for (int axis = 0; axis < D; ++axis) fly(particle, axis, grid.box()[axis], per_box[axis], dt);
      destination[i] = grid.cell_of(particle.position);
      ++arrivals[destination[i]];
    }
  }

 private:
  void fly(Phase<D>& particle, int axis, double length, double per_length, double dt) const {
    double& x = particle.position[axis];
    double& velocity = particle.velocity[axis];
    if constexpr (Sides == Walls::specular) {
      if (parameters_.walled[static_cast<std::size_t>(axis)]) {
        if (parameters_.offsets) x = mirror(x, length);
        if (Gravity && parameters_.gravity[axis] != 0)
          fall_between_walls(x, velocity, parameters_.gravity[axis], dt, length);
        else
          fly_between_walls(x, velocity, dt, length);
        return;
      }
    }
    if constexpr (Gravity) {
      x += dt * (velocity + 0.5 * dt * parameters_.gravity[axis]);
      velocity += dt * parameters_.gravity[axis];
    } else {
      x += dt * velocity;
    }
    x = wrap(x, length, per_length);
  }

  /// Planes are normal to periodic axes without gravity: the signed number of passages is that of the unwrapped path.
  void count_crossings(const Phase<D>& particle, const Vector<D>& box, double dt) const {
    for (Plane& plane : *parameters_.planes) {
      const double length = box[plane.axis()], velocity = particle.velocity[plane.axis()];
      const double before = wrap(particle.position[plane.axis()], length, 1 / length) - plane.position();
      const double passages = std::floor((before + velocity * dt) / length) - std::floor(before / length);
      for (int i = 0; i < std::abs(static_cast<int>(passages)); ++i) plane.count(velocity);
    }
  }

  MotionParameters<D> parameters_;
};

template <int D, bool Gravity, Walls Sides>
std::unique_ptr<MotionStage<D>> with_planes(const MotionParameters<D>& parameters) {
  if (parameters.planes != nullptr && !parameters.planes->empty())
    return std::make_unique<MotionKernel<D, Gravity, Sides, true>>(parameters);
  return std::make_unique<MotionKernel<D, Gravity, Sides, false>>(parameters);
}

template <int D, bool Gravity>
std::unique_ptr<MotionStage<D>> with_walls(const MotionParameters<D>& parameters) {
  for (bool walled : parameters.walled)
    if (walled) return with_planes<D, Gravity, Walls::specular>(parameters);
  return with_planes<D, Gravity, Walls::none>(parameters);
}

}  // namespace

template <int D>
std::unique_ptr<MotionStage<D>> make_motion_stage(const MotionParameters<D>& parameters) {
  return parameters.gravity.isZero(0) ? with_walls<D, false>(parameters) : with_walls<D, true>(parameters);
}

template std::unique_ptr<MotionStage<2>> make_motion_stage(const MotionParameters<2>&);
template std::unique_ptr<MotionStage<3>> make_motion_stage(const MotionParameters<3>&);

}  // namespace sandglass::dsmc
