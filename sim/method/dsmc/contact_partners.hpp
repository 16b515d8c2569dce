#pragma once

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/particles_by_species.hpp"
#include "sim/method/dsmc/species_table.hpp"
#include "sim/method/dsmc/velocity_box.hpp"
#include "sim/space/neighbours.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace sandglass::dsmc {

/// Collisions of a particle with partners a diameter away (Enskog simulation Monte Carlo, Montanero & Santos 1996): a
/// direction k is drawn, the partner is any particle of the cell that contains x + d k, and the pair collides along k at
/// the rate of Enskog's collision term, with the contact factor of the midpoint (standard Enskog theory). Both particles
/// change, so that momentum and energy are kept pair by pair. Derivation: docs/theory.md.
///
/// Of several species, the partners of each are drawn in turn: d is that of the pair, and so are contact factor, masses and
/// restitution.
///
/// A cell must be a diameter wide at least: partners then stand in the cells around it, and cells of one colour
/// (cell_colours.hpp) share no particle. The colours are worked on one after the other, each in any order.
template <int D>
class ContactPartners {
 public:
  /// Throws InputError where an edge of a cell is shorter than a diameter.
  ContactPartners(const Parameters& parameters, const Grid<D>& grid, const std::array<bool, D>& periodic);

  /// A whole step: begin(), then collide() for each of colours().
  void collide(const CollisionStep<D>& step);

  const std::vector<std::vector<std::uint32_t>>& colours() const { return colours_; }
  void begin(const CollisionStep<D>& step);
  /// Cells of one colour.
  void collide(const CollisionStep<D>& step, std::span<const std::uint32_t> cells);

  std::size_t bytes() const;

 private:
  /// Of the cells in which partners may stand: no pair is above it, and no cell holds more.
  struct Surroundings {
    VelocityBox<D> box;
    double pairs = 0;  ///< most particles in a cell times largest contact factor
  };
  struct Candidate {
    std::uint32_t cell, partner_cell, one, two;  ///< particles by their places in memory
    std::size_t kinds;                           ///< of one and two, as of SpeciesTable
    Vector<D> direction;                         ///< from one to two
    double reach;                                ///< from one to two
    double others;                               ///< in the cell of the partner
    double approach;                             ///< speed along the direction
  };

  /// Partners of this species; `Mixed`: there are several.
  template <bool Mixed>
  void collide_cell(const CollisionStep<D>& step, std::uint32_t cell, std::uint8_t kind, Random& random);
  template <bool Mixed>
  Surroundings survey(const CollisionStep<D>& step, std::uint32_t cell, std::uint8_t kind) const;
  template <bool Mixed>
  bool draw(const CollisionStep<D>& step, std::uint32_t cell, std::uint8_t kind, Random& random,
            Candidate& candidate) const;
  bool draw_partner(const CollisionStep<D>& step, std::uint32_t bits, Candidate& candidate) const;
  bool draw_partner_of(std::uint8_t kind, std::uint32_t bits, Candidate& candidate) const;
  template <bool Mixed>
  double weight_of(const CollisionStep<D>& step, const Candidate& candidate) const;
  template <bool Mixed>
  double collide_pair(const CollisionStep<D>& step, const Candidate& candidate, VelocityBox<D>& around);
  double kick(const CollisionStep<D>& step, const Candidate& candidate) const;
  double kick_of_species(const CollisionStep<D>& step, const Candidate& candidate) const;
  bool wrap(Vector<D>& position) const;

  Grid<D> grid_;
  std::array<bool, D> periodic_;
  Neighbours<D> neighbours_;
  double reach_, contact_place_, restitution_, mass_;
  bool measure_transfer_;
  std::vector<std::vector<std::uint32_t>> colours_;
  std::vector<VelocityBox<D>> boxes_;     ///< by cell; of empty cells without meaning
  std::optional<SpeciesTable<D>> table_;  ///< of several species, as are the next
  std::vector<double> reaches_;           ///< of each pair of them
  ParticlesBySpecies by_species_;
};

extern template class ContactPartners<2>;
extern template class ContactPartners<3>;

}  // namespace sandglass::dsmc
