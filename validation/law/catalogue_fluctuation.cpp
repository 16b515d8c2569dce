#include "validation/law/catalogue.hpp"
#include "validation/law/fluctuation.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

std::vector<Law> fluctuation_laws() {
  Law count{
      .name = "count-variance",
      .summary = "variance of the number of particles in a slice of a closed box of elastic fluid",
      .source = "Hansen & McDonald 2006, eq. 2.6.12; Z of Henderson or Carnahan & Starling",
      .units = "1",
      .validity = "equilibrium; exact for points, else slices much thicker than a diameter, fluid branch",
      .parameters = with_fraction({positive("mean-count", "1", "mean number of particles in the slice"),
                                   {.name = "share",
                                    .units = "1",
                                    .summary = "part of the box in the slice",
                                    .low = 0,
                                    .high = 1,
                                    .fallback = 0}}),
      .evaluate = [](const Arguments& given) {
        return count_variance(gas_from(given), given.at("mean-count"), given.at("share"));
      }};
  Law cells{
      .name = "cell-count-variance",
      .summary = "the same in a Monte Carlo fluid whose pairs and contact values come from cells",
      .source = "derived: docs/theory.md, counts in a slice; Z of Henderson or Carnahan & Starling",
      .units = "1",
      .validity =
          "equilibrium, linear; without displacement, missing pairs and time step: low by 5 to 10 percent",
      .parameters = with_fraction(
          {positive("mean-count", "1", "mean number of particles in the slice"),
           {.name = "share", .units = "1", .summary = "part of the box in the slice", .low = 1e-4, .high = 1},
           positive("length", "length", "of the periodic box along the slices"),
           {.name = "cell-edge",
            .units = "length",
            .summary = "of a cell along the box; 0: no cells",
            .low = 0,
            .high = 1e12,
            .fallback = 0},
           {.name = "window",
            .units = "1",
            .summary = "cells along the box that the contact value reads",
            .low = 1,
            .high = 1e6,
            .fallback = 1,
            .step = 1}}),
      .evaluate = [](const Arguments& given) {
        return cell_count_variance(gas_from(given), given.at("mean-count"), given.at("share"),
                                   given.at("length"), {given.at("cell-edge"), given.at("window")});
      }};
  Law level{.name = "white-spectrum-level",
            .summary = "mean of a line of the power spectrum of samples that are independent",
            .source = "variance of (3.12) in Mueller 2001 (3.11)",
            .units = "square of the sampled quantity",
            .validity = "exact; every line between zero and the Nyquist frequency",
            .parameters = {positive("variance", "square of the sampled quantity", "of one sample"),
                           positive("samples", "1", "number of samples")},
            .evaluate = [](const Arguments& given) {
              return white_spectrum_level(given.at("variance"), given.at("samples"));
            }};
  return {std::move(count), std::move(cells), std::move(level)};
}

}  // namespace sandglass::law
