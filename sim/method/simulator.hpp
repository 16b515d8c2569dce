#pragma once

#include "sim/base/error.hpp"
#include "sim/observe/view.hpp"
#include "sim/space/particles.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// A method at work: what the run loop needs of it.
template <int D>
class Simulator {
 public:
  virtual ~Simulator() = default;
  /// Takes particles in the given order.
  virtual void assign(const Particles<D>& particles) = 0;
  /// Called before assign(), which every rank then gives all particles: works on a share of them from now on.
  virtual void share(Communicator&) {
    throw RunError("this method cannot share its particles out over ranks yet");
  }
  /// Advances by `dt`; `step` names the random streams.
  virtual void step(double dt, std::uint64_t step) = 0;
  /// Particles, cells and counters; time and step are the run's to fill in. Shared out: those of this rank.
  virtual View<D> view() = 0;
  /// Shared out: the particles and counts of all ranks, on the first of them.
  virtual View<D> view_of_all() { return view(); }
  /// Shared out: the first rank takes over what all have counted.
  virtual void gather_counts() {}
  virtual std::span<const std::uint64_t> ids() const = 0;
  /// Particles that it holds now.
  virtual std::uint64_t size() const = 0;
  /// Whether a particle of this species would overlap no other one there, as those without a surface never do.
  virtual bool has_room(const Vector<D>&, std::size_t) { return true; }
  /// Adds particles between two steps, with new ids; columns that are not given get their initial value.
  virtual void insert(const Particles<D>&) { refuse_other_number("insert"); }
  /// Takes in, during the coming step, particles that fly by themselves for what is left of it. Called before step(), with
  /// what that gets.
  virtual void enter(const Entrants<D>&, double, std::uint64_t) { refuse_other_number("let in"); }
  /// Removes, between two steps, the particles at these places of the view.
  virtual void remove(std::span<const std::uint32_t>) { refuse_other_number("remove"); }
  virtual Tally& tally() = 0;
  /// Counts of this method alone since time zero, by the name that they have in a record.
  virtual std::map<std::string, double> counters() const { return {}; }
  /// What a bitwise restart needs beside the view and the tally; and back, after assign().
  virtual Memory save() const { return {}; }
  virtual void load(const Memory&) {}
  /// Counts since time zero start anew, as on ranks that do not go on with them after a restart.
  virtual void clear_counts() {}
  /// Both, where the order of the particles depends on what was saved.
  virtual void restore(const Particles<D>& particles, const Memory& memory) {
    assign(particles);
    load(memory);
  }
  /// Bytes held, everything included.
  virtual std::size_t bytes() const = 0;

 private:
  [[noreturn]] static void refuse_other_number(const std::string& action) {
    throw RunError("this method cannot " + action +
                   " particles during a run yet: their number stays what it was at the start");
  }
};

/// The seed and replica that all random streams of a method share.
struct Streams {
  std::uint64_t seed = 1;
  std::uint64_t replica = 0;
};

}  // namespace sandglass
