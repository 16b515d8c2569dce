#include "sim/method/dsmc/dsmc.hpp"

#include "sim/base/saved.hpp"
#include "sim/base/stop_request.hpp"

namespace sandglass::dsmc {

namespace {
/// Particles that are collided and then moved while the first cache still holds them.
constexpr std::uint32_t kBlock = 512;

std::vector<SpeciesTraits> traits_of(const Parameters& parameters) {
  if (parameters.kinds.any()) return parameters.kinds.species;
  return {{parameters.diameter, parameters.mass}};
}
}  // namespace

template <int D>
Dsmc<D>::Dsmc(const LatticeOfCells<D>& cells, const Parameters& parameters,
              const motion::MotionParameters<D>& motion, const Streams& streams, Purpose purpose,
              const std::vector<ColumnInfo>& columns)
    : CellSimulator<D>(cells, traits_of(parameters), parameters.weight, motion, streams, columns),
      parameters_(parameters),
      purpose_(purpose),
      collisions_(parameters.faults.any() ? make_faulty_collision_stage<D>(parameters)
                                          : make_collision_stage<D>(parameters)),
      stages_(cells, this->periodic()) {
  if (parameters.count_by_species)
    tally_.by_species.resize(parameters.kinds.species.size() * parameters.kinds.species.size());
  for (const double weight : parameters.weights) relative_weights_.push_back(weight / parameters.weight);
  if (!parameters.weights.empty()) this->weigh_by_cell(parameters.weights, parameters.cloning);
  if (parameters.pair_count == PairCount::time_counter) clocks_.emplace(parameters.faults.clocks_forgotten);
  if (parameters.partners == Partners::contact)
    contact_ = std::make_unique<ContactPartners<D>>(parameters, cells.grid(), this->periodic());
  if (!parameters.excluded_volume.any()) return;
  excluded_ = std::make_unique<ExcludedVolumeOfCells<D>>(parameters, motion, store_.cells());
  add(excluded_->take_stage());
}

template <int D>
void Dsmc<D>::assign(const Particles<D>& particles) {
  if (store_.cells().shifted_cells()) shift_cells(drawn_shift(0));
  take_in(particles);
}

template <int D>
void Dsmc<D>::take_in(const Particles<D>& particles) {
  CellSimulator<D>::assign(particles);
  make_factor(static_cast<double>(particles.phases.size()) + parameters_.poured);
  // The stream of the step before all steps.
  if (clocks_)
    clocks_->start(store_.cells().size(), {streams_.seed, purpose_, streams_.replica, ~std::uint64_t{0}});
}

template <int D>
Vector<D> Dsmc<D>::drawn_shift(std::uint64_t step) const {
  Random random({streams_.seed, Purpose::lattice, streams_.replica, step}, 0);
  Vector<D> part;
  for (int axis = 0; axis < D; ++axis) part[axis] = random.uniform() - 0.5;
  return part;
}

template <int D>
void Dsmc<D>::shift_cells(const Vector<D>& part) {
  store_.shift_cells(part);
  if (factor_) factor_->update_volumes();
}

template <int D>
void Dsmc<D>::make_factor(double particles) {
  assigned_ = particles;
  if (PairFactor<D>::needed(parameters_, store_.cells()))
    factor_.emplace(parameters_, store_.cells(), this->periodic(), particles);
}

template <int D>
void Dsmc<D>::step(double dt, std::uint64_t step) {
  const StreamKey key(streams_.seed, purpose_, streams_.replica, step);
  if (excluded_) {
    excluded_->mark(store_.offsets());
    store_.sum_velocities(excluded_->wants_means());
  }
  stages_.apply(store_, key, step, dt);
  if (factor_)
    factor_->update(store_.offsets(), this->work(), excluded_ ? excluded_->full() : nullptr, species());
  if (clocks_) clocks_->begin_step(dt);
  const motion::MotionStep motion = this->motion_step(dt, step);
  const CollisionStep<D> collisions = collision_step(dt, key);
  if (excluded_ && excluded_->refuses()) {
    collide_and_enter(motion, collisions, {streams_.seed, Purpose::entry, streams_.replica, step});
  } else if (contact_) {
    contact_->collide(collisions);
    move(motion);
  } else {
    collide_and_move(motion, collisions);
  }
  if (store_.cells().shifted_cells()) find_cells_of(step + 1);
  this->end_step(dt, step);
}

template <int D>
void Dsmc<D>::find_cells_of(std::uint64_t next_step) {
  shift_cells(drawn_shift(next_step));
  store_.find_cells();
}

template <int D>
const double* Dsmc<D>::factor() const {
  if (!relative_weights_.empty()) return relative_weights_.data();
  return factor_ ? factor_->values() : nullptr;
}

template <int D>
CollisionStep<D> Dsmc<D>::collision_step(double dt, const StreamKey& key) {
  const double coefficient =
      parameters_.weight * parameters_.cross_section * dt / (2 * store_.grid().cell_volume());
  return {key,
          coefficient,
          factor(),
          excluded_ ? excluded_->still() : nullptr,
          impact_coefficient(),
          store_.phases().data(),
          store_.offsets().data(),
          &tally_,
          &bound_raised_,
          species(),
          parameters_.kinds.rough ? store_.column(column::spin<D>).data() : nullptr,
          factor_ ? factor_->contact_of_pairs() : nullptr,
          clocks_ ? clocks_->values() : nullptr};
}

template <int D>
const std::uint8_t* Dsmc<D>::species() {
  return parameters_.kinds.mixed() ? store_.column(column::species).data() : nullptr;
}

template <int D>
double Dsmc<D>::impact_coefficient() const {
  if (!parameters_.impact.fitted() || store_.size() == 0) return 0;
  const double collisions = 2 * static_cast<double>(tally_.collisions) / static_cast<double>(store_.size());
  return parameters_.impact.coefficient.at(collisions);
}

template <int D>
void Dsmc<D>::move(const motion::MotionStep& motion) {
  store_.begin_step();
  this->fly(0, store_.size(), motion);
}

template <int D>
template <class Move>
void Dsmc<D>::collide_and(const CollisionStep<D>& collisions, Move move) {
  const auto offsets = store_.offsets();
  const std::uint32_t cells = this->work().last();
  store_.begin_step();
  for (std::uint32_t first = this->work().first(); first < cells;) {
    stop_request.heed();
    std::uint32_t last = first + 1;
    while (last < cells && offsets[last] - offsets[first] < kBlock) ++last;
    collisions_->collide(collisions, first, last);
    move(first, last);
    first = last;
  }
}

template <int D>
void Dsmc<D>::collide_and_move(const motion::MotionStep& motion, const CollisionStep<D>& collisions) {
  collide_and(collisions, [&](std::uint32_t first, std::uint32_t last) {
    this->fly(store_.offsets()[first], store_.offsets()[last], motion);
  });
}

template <int D>
void Dsmc<D>::collide_and_enter(const motion::MotionStep& motion, const CollisionStep<D>& collisions,
                                const StreamKey& key) {
  excluded_->begin_moves(store_.offsets(), key);
  collide_and(collisions, [&](std::uint32_t first, std::uint32_t last) {
    excluded_->advance(store_, first, last, motion);
  });
}

template <int D>
std::map<std::string, double> Dsmc<D>::counters() const {
  std::map<std::string, double> counters = CellSimulator<D>::counters();
  if (excluded_) counters.merge(excluded_->counters());
  counters["bound-raised"] = static_cast<double>(bound_raised_);
  return counters;
}

template <int D>
std::vector<std::uint64_t*> Dsmc<D>::counts() {
  std::vector<std::uint64_t*> counts = CellSimulator<D>::counts();
  counts.push_back(&bound_raised_);
  return counts;
}

template <int D>
Memory Dsmc<D>::save() const {
  Memory memory = CellSimulator<D>::save();
  memory["dsmc/bound-raised"] = {static_cast<double>(bound_raised_)};
  memory["dsmc/window"] = {assigned_};
  if (const auto& shifted = store_.cells().shifted_cells())
    memory["dsmc/shift"] = {shifted->part().begin(), shifted->part().end()};
  if (excluded_) excluded_->save(memory);
  if (clocks_) clocks_->save(memory);
  return memory;
}

template <int D>
void Dsmc<D>::load(const Memory& memory) {
  CellSimulator<D>::load(memory);
  bound_raised_ = saved_count(memory.at("dsmc/bound-raised").at(0));
  if (excluded_) excluded_->load(memory);
  if (clocks_) clocks_->load(memory);
  const double assigned = saved_number(memory.at("dsmc/window").at(0), 0, 0x1p53, "a number of particles");
  if (assigned != assigned_) make_factor(assigned);
}

/// The particles stand in the order of the cells of the coming step.
template <int D>
void Dsmc<D>::restore(const Particles<D>& particles, const Memory& memory) {
  if (store_.cells().shifted_cells()) {
    Vector<D> shift;
    for (std::size_t axis = 0; axis < D; ++axis)
      shift[static_cast<int>(axis)] =
          saved_number(memory.at("dsmc/shift").at(axis), -0.5, 0.5, "the shift of the cells");
    shift_cells(shift);
  }
  take_in(particles);
  load(memory);
}

template <int D>
std::size_t Dsmc<D>::bytes() const {
  return CellSimulator<D>::bytes() + stages_.bytes() + (factor_ ? factor_->bytes() : 0) +
         (excluded_ ? excluded_->bytes() : 0) + (contact_ ? contact_->bytes() : 0) +
         (clocks_ ? clocks_->bytes() : 0) + relative_weights_.capacity() * sizeof(double);
}

template class Dsmc<2>;
template class Dsmc<3>;

}  // namespace sandglass::dsmc
