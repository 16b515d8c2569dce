#include "validation/law/catalogue.hpp"
#include "validation/law/guarded.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kValidity =
    "homogeneous; no correlation of speeds, no recollisions; contact time short against the time of cooling";

Parameter covered() {
  return elapsed("collisions-in-contact-time", "1", "collision rate times contact time of the guard");
}

Law share_law(std::string name, std::string summary, std::string source, double (*share)(int, double)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = "1",
          .validity = kValidity,
          .parameters = {covered(), dimension()},
          .evaluate = [share](const Arguments& arguments) {
            return share(static_cast<int>(arguments.at("dimension")),
                         arguments.at("collisions-in-contact-time"));
          }};
}

Law polynomial_law() {
  return {
      .name = "guarded-share-polynomial",
      .summary = "the same of spheres, to third order in omega t_c",
      .source = "Luding & Goldshtein 2003; docs/theory.md",
      .units = "1",
      .validity =
          "spheres; as guarded-share, which it agrees with to 0.1% up to two collisions in the contact time",
      .parameters = {covered()},
      .evaluate = [](const Arguments& arguments) {
        return guarded_share_polynomial(arguments.at("collisions-in-contact-time"));
      }};
}

Law rate_law() {
  return {.name = "guarded-cooling-rate",
          .summary = "cooling rate under the TC model: Haff's times guarded-share",
          .source = "Luding & McNamara 1998 (model); docs/theory.md",
          .units = "1/time",
          .validity = kValidity,
          .parameters = with_fraction(
              {dissipation(), temperature(), mass(), diameter(),
               elapsed("contact-time", "time", "collisions that follow another within it are elastic")}),
          .evaluate = [](const Arguments& arguments) {
            return guarded_cooling_rate(gas_from(arguments), arguments.at("contact-time"));
          }};
}
}  // namespace

std::vector<Law> guarded_laws() {
  return {share_law("guarded-share", "share of the energy loss that the TC model leaves", "docs/theory.md",
                    guarded_share),
          polynomial_law(), rate_law()};
}

}  // namespace sandglass::law
