#include "sim/method/dsmc/motion_stage.hpp"

#include "sim/base/error.hpp"
#include "sim/space/cell_locator.hpp"
#include "sim/space/flight.hpp"

namespace sandglass::dsmc {

namespace {

enum class Walls { none, specular };

/// Flight without boundaries, all axes at once.
template <int D>
class FreeFlight {
 public:
  using Real = typename Lanes<D>::Real;

  FreeFlight(const Vector<D>& gravity, const Vector<D>& box, double dt)
      : gain_(Lanes<D>::from(Vector<D>(gravity * dt), 0)),
        half_gain_(0.5 * gain_),
        box_(Lanes<D>::from(box, HUGE_VAL)),
        dt_(dt) {}

  template <bool Gravity>
  Real end(const Real& position, const Real& velocity) const {
    if constexpr (Gravity) return position + dt_ * (velocity + half_gain_);
    return position + dt_ * velocity;
  }
  bool inside(const Real& position) const {
    const auto in = (position >= 0) & (position < box_);  // false for what is not a number
    if constexpr (D == 2)
      return (in[0] & in[1]) != 0;
    else
      return (in[0] & in[1] & in[2]) != 0;
  }
  const Real& gain() const { return gain_; }

 private:
  Real gain_, half_gain_, box_;
  double dt_;
};

template <int D, bool Gravity, Walls Sides, bool Crossings>
class MotionKernel final : public MotionStage<D> {
 public:
  explicit MotionKernel(const MotionParameters<D>& parameters) : parameters_(parameters) {}

  void advance(ParticleStore<D>& store, std::size_t first, std::size_t last, double dt) const override {
    const CellLocator<D> locator(store.grid());
    const FreeFlight<D> flight(parameters_.gravity, store.grid().box(), dt);
    Phase<D>* particles = store.phases().data();
    auto* places = store.places();
    std::uint32_t* arrivals = store.arrivals();
    for (std::size_t i = first; i < last; ++i) {
      Phase<D>& particle = particles[i];
      if constexpr (Crossings) count_crossings(particle, store.grid().box(), dt);
      const auto position = fly(particle, flight, store.grid().box(), dt);
      const std::uint32_t cell = locator.cell_of(position);
      places[i] = {cell, arrivals[cell]++};
    }
  }

 private:
  using Lane = Lanes<D>;

  /// Free flight where it stays in the box, which is nearly always; else axis by axis with the boundaries.
  typename Lane::Real fly(Phase<D>& particle, const FreeFlight<D>& flight, const Vector<D>& box,
                          double dt) const {
    double* components = particle.position.data();
    const typename Lane::Real start = Lane::load(components), velocity = Lane::load(components + D);
    const typename Lane::Real position = flight.template end<Gravity>(start, velocity);
    bool stays = flight.inside(position);
    if constexpr (Sides == Walls::specular) {
      // Gravity bends the path away from its tangent and no further than the chord from start to end.
      if constexpr (Gravity) stays = stays && flight.inside(flight.template end<false>(start, velocity));
      if (parameters_.offsets) stays = stays && flight.inside(start);
    }
    if (!stays) [[unlikely]]
      return fly_bounded(particle, box, dt);
    Lane::store(components, position);
    if constexpr (Gravity) Lane::store(components + D, velocity + flight.gain());
    return position;
  }

  [[gnu::noinline]] typename Lane::Real fly_bounded(Phase<D>& particle, const Vector<D>& box,
                                                    double dt) const {
    for (int axis = 0; axis < D; ++axis) fly_along(particle, axis, box[axis], dt);
    // What is not a number is never inside the box, so that it always comes by here.
    if (!particle.position.allFinite() || !particle.velocity.allFinite())
      throw RunError(
          "a position or velocity is not a finite number: time step too long, or too strong a force?");
    return Lane::from(particle.position, 0);
  }

  void fly_along(Phase<D>& particle, int axis, double length, double dt) const {
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
    x += dt * (velocity + 0.5 * dt * parameters_.gravity[axis]);
    velocity += dt * parameters_.gravity[axis];
    x = wrap(x, length, 1 / length);
  }

  /// Planes are normal to periodic axes without gravity: the signed number of passages is that of the unwrapped path.
  void count_crossings(const Phase<D>& particle, const Vector<D>& box, double dt) const {
    for (Plane& plane : *parameters_.planes) {
      const double length = box[plane.axis()], velocity = particle.velocity[plane.axis()];
      const double before = wrap(particle.position[plane.axis()], length, 1 / length) - plane.position();
      const double after = before + velocity * dt;
      if ((before < 0) == (after < 0) && std::abs(after) < length) [[likely]]
        continue;
      const double passages = std::floor(after / length) - std::floor(before / length);
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
