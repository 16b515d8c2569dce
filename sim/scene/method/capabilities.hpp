#pragma once

#include "sim/scene/scene.hpp"

#include <vector>

namespace sandglass {

/// What a family of methods can do. The rest of the program asks for one of these, never for a family's name.
struct Capabilities {
  bool particles = true;   ///< holds particles in a box
  bool collisions = true;  ///< of particles with each other
  bool contacts = false;   ///< particles have a surface: none may overlap, and walls touch it, not the centre
  bool weights = false;    ///< a simulated particle may stand for more or fewer real ones
  bool regions = false;    ///< another number of them in some regions
  bool species = false;    ///< more than one
  bool spins = false;      ///< rough contacts
  bool walls = true;       ///< sides that are not periodic, with the rules below
  std::vector<SurfaceKind> wall_rules;
  bool obstacles = false;
  bool gravity = true;
  bool event_trace = false;
  bool varying_number = false;  ///< particles may enter and leave
  bool outflows = false;        ///< open sides may send back some of those who come
  bool cells = false;           ///< that the scene may choose, and in which particles collide
  bool restartable = true;
  bool ranks = false;  ///< ranks may share its cells; kept_whole() says what forbids it
};

/// Of the scene's family.
const Capabilities& capabilities(const Scene& scene);

// What a scene chose, whichever family offers the choice.

/// What of the scene keeps its box whole, where ranks might share the cells; empty where they can.
std::string kept_whole(const Scene& scene);
/// Cells along each axis; empty where the method chooses them.
std::vector<double> cells_along(const Scene& scene);
/// The whole numbers of cells nearest to this edge, at least one along each axis, and none that makes cells narrower than
/// least_cell_edge(). Cells that stand on a corner are counted from corner to corner.
std::vector<double> cells_of_edge(const Scene& scene, double edge);
/// Cells take in no more than the densest packing.
bool has_full_cells(const Scene& scene);
/// A diameter where partners are looked for that far away in the cells around; else 0.
double least_cell_edge(const Scene& scene);
/// Cells are squares that stand on a corner.
bool has_diagonal_cells(const Scene& scene);
/// Collisions push pairs apart that are then missing where pairs are counted: by offsets, or by partners at contact.
bool loses_pairs(const Scene& scene);
/// Cells across the window that the contact value of a cell is read from; 1 where the scene leaves it open or there is none.
double density_window(const Scene& scene);
/// The collision rate goes with the contact value of the local density.
bool has_contact_factor(const Scene& scene);
/// Partners of a collision stand a diameter apart.
bool has_partners_at_contact(const Scene& scene);
/// By how much partners are displaced along their momentum change, a length; 0 where they are not. The
/// offset carries m d r |c_n| a collision after the kick, hard cores carry m d (1 + r)/2 |c_n|.
double offset_along(const Scene& scene, double diameter, double restitution);
/// And in a random direction, in diameters.
double random_offset(const Scene& scene);

}  // namespace sandglass
