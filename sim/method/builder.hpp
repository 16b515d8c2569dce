#pragma once

#include "sim/method/plan.hpp"
#include "sim/method/planted_fault.hpp"
#include "sim/method/simulator.hpp"
#include "sim/observe/event.hpp"
#include "sim/observe/observer.hpp"
#include "sim/scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace sandglass {

/// What the run attaches to a simulator. All of it must outlive the simulator.
template <int D>
struct Attachments {
  std::vector<Plane>* planes = nullptr;  ///< that count who passes; null: none
  EventSink<D>* trace = nullptr;         ///< takes every event; null: none is kept
  WallImpulses<D>* impulses = nullptr;   ///< takes what the walls take; null: it is not counted
};

/// A scene made ready for its family of methods: everything optional is decided when it is made, once.
template <int D>
class MethodBuilder {
 public:
  virtual ~MethodBuilder() = default;
  /// Expected collisions per particle and time of a uniform gas of this granular temperature; 0 without collisions.
  virtual double collision_rate(double temperature) const = 0;
  virtual std::unique_ptr<Simulator<D>> build(const Streams& streams,
                                              const Attachments<D>& attachments) const = 0;
  /// The same particles without loss, drive, planes and trace, to reach equilibrium before time zero.
  virtual std::unique_ptr<Simulator<D>> build_elastic(const Streams& streams) const = 0;
  /// Shortest edge of the cells in which particles collide; 0 without cells.
  virtual double cell_edge() const { return 0; }
  /// Length of a step of the elastic simulator; 0: as the scene says.
  virtual double elastic_step() const { return 0; }
  /// Fills in what the family alone knows: cells, columns, memory, features, warnings. The expected work stands there.
  virtual void plan(Plan& plan) const = 0;
  /// Writes the choices that it made into the scene, where the scene left them open.
  virtual void record_choices(Scene&) const {}
};

/// What a builder is made from.
struct BuildRequest {
  const Scene& scene;
  Needs needs;        ///< of all observers together
  std::string fault;  ///< name of a planted fault; empty: the honest method
};

/// What a family of methods brings to a run. What it brings to the scene stands in sim/scene/method.
struct FamilyBuilder {
  std::string name;
  std::vector<PlantedFault> faults;
  std::unique_ptr<MethodBuilder<2>> (*disks)(const BuildRequest&);
  std::unique_ptr<MethodBuilder<3>> (*spheres)(const BuildRequest&);
};

}  // namespace sandglass
