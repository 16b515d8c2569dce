#include "validation/law/catalogue.hpp"
#include "validation/law/mixing.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kGreenspan = "repulsion: Greenspan 1972, 2.11; ";

Parameter number(std::string name, std::string units, std::string summary, double fallback) {
  Parameter parameter =
      with_fallback(any_real(std::move(name), std::move(units), std::move(summary)), fallback);
  parameter.low = 0;
  return parameter;
}

std::vector<Parameter> with_repulsion(std::vector<Parameter> others) {
  std::vector<Parameter> all = {number("coefficient", "length^p time^-2 mass^-1", "alpha", 1),
                                number("exponent", "1", "p", 2),
                                number("core-exponent", "1", "beta", 0),
                                number("softening-length", "length", "xi", 0),
                                positive("diameter", "length", "below which the core acts"),
                                positive("cutoff", "length", "no repulsion from there on")};
  for (Parameter& other : others) all.push_back(std::move(other));
  return all;
}

PairRepulsion repulsion_from(const Arguments& given) {
  return {given.at("coefficient"),      given.at("exponent"), given.at("core-exponent"),
          given.at("softening-length"), given.at("diameter"), given.at("cutoff")};
}

Parameter both() { return positive("mass", "mass", "of both particles together"); }

Law deflection_law() {
  return {.name = "repulsion-deflection",
          .summary = "angle by which the relative velocity of two particles of a mixing fluid turns",
          .source = std::string(kGreenspan) + "orbit: Landau & Lifshitz, Mechanics, sec. 18",
          .units = "1",
          .validity = "exact for two particles alone",
          .parameters = with_repulsion({both(), positive("speed", "length/time", "relative, far away"),
                                        positive("impact", "length", "impact parameter")}),
          .evaluate = [](const Arguments& given) {
            return deflection_angle(repulsion_from(given), given.at("mass"), given.at("speed"),
                                    given.at("impact"));
          }};
}

Law step_law() {
  return {
      .name = "repulsion-stable-step",
      .summary = "longest stable step of the leapfrog where two particles of a mixing fluid turn head-on",
      .source = std::string(kGreenspan) + "2/omega: Hockney & Eastwood 1981, 4-4-2",
      .units = "time",
      .validity = "head-on; linear about the turning point; faster than the barrier of a softened core: none",
      .parameters = with_repulsion({both(), positive("speed", "length/time", "relative, far away")}),
      .evaluate = [](const Arguments& given) {
        return stable_step(repulsion_from(given), given.at("mass"), given.at("speed"));
      }};
}

Law cage_law() {
  return {.name = "repulsion-cage-frequency",
          .summary = "angular frequency of a light particle between two heavy ones of a mixing fluid",
          .source = std::string(kGreenspan) + "linear about the middle",
          .units = "time^-1",
          .validity = "small amplitude; distance below the diameter, no softening",
          .parameters = with_repulsion({positive("mass", "mass", "of a heavy particle"),
                                        positive("distance", "length", "from the middle to each")}),
          .evaluate = [](const Arguments& given) {
            return cage_frequency(repulsion_from(given), given.at("mass"), given.at("distance"));
          }};
}

Law leapfrog_law() {
  return {
      .name = "leapfrog-place",
      .summary = "place of an oscillator after so many steps of the leapfrog, over that at the start at rest",
      .source =
          "solution of the difference equation; stable for omega dt < 2: Hockney & Eastwood 1981, 4-4-2",
      .units = "1",
      .validity = "exact",
      .parameters = {positive("angle", "1", "omega dt"), number("steps", "1", "since the start", 1)},
      .evaluate = [](const Arguments& given) {
        return leapfrog_place(given.at("angle"), given.at("steps"));
      }};
}

Law wall_law() {
  return {.name = "listed-wall-factor",
          .summary = "mean share of the speed that a wall of the listing leaves where its factor is 1",
          .source = "WALCOL of the listing in Greenspan 1972: s/(s + EPS) over even overshoots s",
          .units = "1",
          .validity = "normal incidence",
          .parameters = {positive("path", "length", "flown in a step"),
                         positive("smallest-length", "length", "EPS of the listing")},
          .evaluate = [](const Arguments& given) {
            return listed_wall_factor(given.at("path"), given.at("smallest-length"));
          }};
}
}  // namespace

std::vector<Law> mixing_laws() {
  return {deflection_law(), step_law(), cage_law(), leapfrog_law(), wall_law()};
}

}  // namespace sandglass::law
