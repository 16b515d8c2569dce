#pragma once

namespace sandglass::law {

/// <v^order> of one Maxwellian component with variance T/m: (order-1)!! variance^(order/2), zero when odd.
double maxwell_component_moment(int order, double variance);

/// <|v|^order> of a Maxwellian whose components have the given variance:
/// (2 variance)^(order/2) Gamma((D+order)/2)/Gamma(D/2).
double maxwell_speed_moment(int dimension, int order, double variance);

/// Even moment of f = phi (1 + a2 S2) over that of phi, for one component and for the speed alike:
/// 1 + a2 k(k-1)/2 with k = order/2. First Sonine order: the a3 term, -a3 k(k-1)(k-2)/6, is left out.
double sonine_moment_factor(int order, double a2);

}  // namespace sandglass::law
