#pragma once

namespace sandglass::event_driven {

/// Faults that the mutant suite plants in the engine.
struct Faults {
  double momentum_leak = 0;     ///< the second partner's kick is this part short
  bool stale_partner = false;   ///< a predicted contact is carried out whatever its partner did meanwhile
  bool blind_crossing = false;  ///< who enters a cell does not look ahead
  bool lost_newcomers = false;  ///< one in twenty of those who come in is not there
  bool maxwellian_backflow =
      false;  ///< who is turned back is drawn from Maxwell's distribution instead of its flux
  bool staying_piston = false;  ///< the piston of a dispenser does not jump back

  bool any() const { return momentum_leak != 0 || stale_partner || blind_crossing; }
};

}  // namespace sandglass::event_driven
