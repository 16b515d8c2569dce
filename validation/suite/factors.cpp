#include "validation/suite/factors.hpp"

#include "sim/base/error.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
class Multiplier {
 public:
  Multiplier(OriginNode& scene, const Factors& factors, const std::string& file)
      : scene_(scene), factors_(factors), file_(file) {}

  void replicas() {
    if (factors_.replicas == 1) return;
    OriginNode& run = needed(scene_, "run", "the scene has no [run]");
    if (!run.entry("replicas")) run.items.push_back(with_origin(whole("replicas", 1), file_));
    scale(*run.entry("replicas"), factors_.replicas, "'run.replicas'");
  }

  void duration() {
    if (factors_.duration == 1) return;
    OriginNode& run = needed(scene_, "run", "the scene has no [run]");
    for (OriginNode& number : needed(run, "duration", "the scene has no 'run.duration'").items)
      scale(number, factors_.duration, "'run.duration'");
  }

  /// At the same density: a box that the scene computes from the count follows by itself.
  void size() {
    if (factors_.size == 1) return;
    OriginNode* method = scene_.entry("method");
    if (method && method->entry("cells"))
      refuse("a factor on the size changes the box: give 'method.cell-size' instead of 'method.cells'");
    for (OriginNode& species : needed(scene_, "species", "the scene has no [[species]]").items)
      scale(needed(species, "count", "a factor on the size needs the 'count' of every species"),
            factors_.size, "'species.count'");
    OriginNode& domain = needed(scene_, "domain", "the scene has no [domain]");
    if (OriginNode* edges = domain.entry("size"))
      for (OriginNode& edge : edges->items) stretch(edge.node, 1 / static_cast<double>(edges->items.size()));
  }

 private:
  static Node whole(const std::string& key, std::int64_t value) {
    Node node;
    node.kind = Node::Kind::whole;
    node.key = key;
    node.whole = value;
    return node;
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError({Diagnostic{file_, factors_.place.line, factors_.place.column, message}});
  }

  OriginNode& needed(OriginNode& table, const std::string& key, const std::string& message) const {
    OriginNode* found = table.entry(key);
    if (!found) refuse(message);
    return *found;
  }

  void stretch(Node& edge, double power) const {
    const double length = edge.kind == Node::Kind::whole ? static_cast<double>(edge.whole) : edge.number;
    edge.number = length * std::pow(factors_.size, power);
    edge.kind = Node::Kind::number;
  }

  void scale(OriginNode& item, double factor, const std::string& what) const {
    Node& node = item.node;
    if (node.kind == Node::Kind::number) node.number *= factor;
    if (node.kind != Node::Kind::whole) return;
    const double wanted = static_cast<double>(node.whole) * factor;
    if (!(wanted > 1 - 1e-9))
      refuse(fmt::format("the factor {} leaves less than one of {} {}", factor, node.whole, what));
    node.whole = std::llround(wanted);
  }

  OriginNode& scene_;
  const Factors& factors_;
  const std::string& file_;
};
}  // namespace

void multiply(OriginNode& scene, const Factors& factors, const std::string& file) {
  Multiplier multiplier(scene, factors, file);
  multiplier.replicas();
  multiplier.duration();
  multiplier.size();
}

}  // namespace sandglass
