#pragma once

#include "validation/law/gas.hpp"
#include "validation/law/law.hpp"

/// The arguments that laws share, so that one name means one thing everywhere.
namespace sandglass::law::parameter {

Parameter dimension();
Parameter diameter();
Parameter mass();
Parameter temperature();
Parameter area_fraction();
Parameter volume_fraction();
Parameter restitution();
/// Restitution that must be given: laws of cooling mean nothing without it.
Parameter dissipation();
Parameter positive(std::string name, std::string units, std::string summary);
Parameter any_real(std::string name, std::string units, std::string summary);
/// Zero or positive.
Parameter elapsed(std::string name, std::string units, std::string summary);
/// Acceleration downwards, 1 unless given.
Parameter gravity();
/// One restitution more, of a wall say; elastic unless given.
Parameter further_restitution(std::string name, std::string summary);
Parameter shear_rate();
Parameter with_fallback(Parameter parameter, double fallback);
Parameter order();
Parameter sonine_a2();

/// The list of `parameters` followed by the contact fractions and the dimension.
std::vector<Parameter> with_fraction(std::vector<Parameter> parameters);

/// The gas that the arguments describe; what a law does not ask for keeps Gas's default.
Gas gas_from(const Arguments& arguments);

/// A law's evaluation from a function of the gas.
std::function<double(const Arguments&)> of_gas(double (*result)(const Gas&));

}  // namespace sandglass::law::parameter
