#include "validation/law/catalogue.hpp"
#include "validation/law/heap.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kKinks = "Alonso & Herrmann 1996; Mueller 2001, (3.14)-(3.17)";
constexpr const char* kPlane =
    "two dimensions, grown slowly on a wide plane, many layers high; not at the head, where the poured "
    "particles land";

Parameter height() { return positive("heap-height", "length", "of the heap at its middle"); }

std::vector<Parameter> with_shape(std::vector<Parameter> parameters) {
  parameters.push_back(positive("slope", "1", "of an ideal side without kinks"));
  parameters.push_back(
      elapsed("kink-length", "length",
              "length of a kink over the probability to stop at one, l/r; 0 for a triangle"));
  return parameters;
}

Heap heap_from(const Arguments& given) {
  return {given.at("heap-height"), given.at("slope"), given.at("kink-length")};
}

Law heap_law(std::string name, std::string summary, std::string source, std::string units,
             std::vector<Parameter> first, std::function<double(const Arguments&)> evaluate) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = std::move(units),
          .validity = kPlane,
          .parameters = with_shape(std::move(first)),
          .evaluate = std::move(evaluate)};
}
}  // namespace

std::vector<Law> heap_laws() {
  return {
      heap_law("heap-distance", "distance from the middle of a heap at which its surface has a height",
               kKinks, "length", {positive("height", "length", "of the surface"), height()},
               [](const Arguments& given) { return heap_distance(heap_from(given), given.at("height")); }),
      heap_law("heap-surface", "height of the surface of a heap at a distance from its middle", kKinks,
               "length", {any_real("distance", "length", "from the middle"), height()},
               [](const Arguments& given) { return heap_surface(heap_from(given), given.at("distance")); }),
      heap_law("heap-area", "area of a heap of given height", "integral of heap-surface", "length^2",
               {height()}, [](const Arguments& given) { return heap_area(heap_from(given)); }),
      heap_law("heap-height", "height of a heap of given area, its growth law", "inverse of heap-area",
               "length",
               {positive("area", "length^2", "of the heap: particles times their area over the packing")},
               [](const Arguments& given) {
                 return heap_height(given.at("area"), given.at("slope"), given.at("kink-length"));
               })};
}

}  // namespace sandglass::law
