#include "validation/law/catalogue.hpp"
#include "validation/law/impact.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
Parameter coefficient() {
  return {
      .name = "impact-coefficient",
      .units = "1",
      .summary =
          "c of the density a/(1 - c b^2); 0 is molecular chaos, above 0 there are more grazing collisions",
      .low = -1000,
      .high = 0.999999};
}

Law impact_law(std::string name, std::string summary, std::vector<Parameter> more,
               std::function<double(int, const Arguments&)> result) {
  std::vector<Parameter> parameters{coefficient(), dimension()};
  parameters.insert(parameters.end(), more.begin(), more.end());
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "Mueller 2001 (3.18) on a line (disks); the same density by area on a disk (spheres)",
          .units = "1",
          .validity = "the form is a fit; given it, exact, with speeds that do not depend on b",
          .parameters = std::move(parameters),
          .evaluate = [result = std::move(result)](const Arguments& given) {
            return result(static_cast<int>(given.at("dimension")), given);
          }};
}
}  // namespace

std::vector<Law> impact_laws() {
  return {impact_law("impact-normalisation", "a of the impact distribution a/(1 - c b^2)", {},
                     [](int dimension, const Arguments& given) {
                       return impact_normalisation(dimension, given.at("impact-coefficient"));
                     }),
          impact_law("impact-dissipation-ratio",
                     "mean dissipation of a collision over that of evenly spread impacts", {},
                     [](int dimension, const Arguments& given) {
                       return impact_dissipation_ratio(dimension, given.at("impact-coefficient"));
                     }),
          impact_law("impact-cumulative", "share of collisions with a smaller impact parameter",
                     {{"impact-parameter", "1", "in diameters; its size alone counts for spheres", -1, 1}},
                     [](int dimension, const Arguments& given) {
                       const double b = given.at("impact-parameter");
                       return impact_cumulative(dimension, given.at("impact-coefficient"),
                                                dimension == 2 ? b : std::abs(b));
                     })};
}

}  // namespace sandglass::law
