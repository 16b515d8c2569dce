#include "validation/law/catalogue.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/vibrated_bed.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
VibratedBed bed_from(const Arguments& given) {
  return {static_cast<int>(given.at("dimension")),
          given.at("layers"),
          given.at("width"),
          given.at("restitution"),
          given.at("bottom-restitution"),
          given.at("side-restitution"),
          given.at("gravity"),
          given.at("bottom-speed")};
}

Law bed_law(std::string name, std::string summary, std::string units, double (*result)(const VibratedBed&)) {
  return {
      .name = std::move(name),
      .summary = std::move(summary),
      .source = "balance of energy to first order in m<U^2>/T; elastic walls: Kumaran 1998",
      .units = std::move(units),
      .validity =
          "too high by about vibrated-bed-expansion of itself; dilute, one temperature in height and "
          "direction, amplitude far below T/(m g), nine periods or more in sqrt(T/m)/gravity",
      .parameters = {positive("bottom-speed", "length/time", "largest speed of the bottom, 2 pi A f"),
                     positive("layers", "1",
                              "particles per width times diameter, or per area times its square"),
                     positive("width", "length", "between side walls; a square box with dimension=3"),
                     dissipation(), further_restitution("bottom-restitution", "of the bottom"),
                     further_restitution("side-restitution", "of the side walls"), gravity(), dimension()},
      .evaluate = [result](const Arguments& given) { return result(bed_from(given)); }};
}
}  // namespace

std::vector<Law> vibrated_bed_laws() {
  return {
      bed_law("vibrated-bed-temperature", "granular temperature over mass of a vibrated bed",
              "length^2 time^-2", vibrated_bed_temperature_over_mass),
      bed_law("vibrated-bed-rise", "rise of the centre of mass of a vibrated bed above its height at rest",
              "length", vibrated_bed_rise),
      bed_law("vibrated-bed-exponent", "slope of ln(rise) against ln(speed of the bottom)", "1",
              vibrated_bed_exponent),
      bed_law("vibrated-bed-expansion", "mean square velocity of the bottom over T/m", "1",
              vibrated_bed_expansion)};
}

}  // namespace sandglass::law
