#include "sim/scene/read_sections.hpp"
#include "sim/scene/words.hpp"

namespace sandglass {

namespace {
/// A key that one way to enter uses and the other does not.
template <class Value>
void read_of(Table& table, const char* key, const char* kind, Value& target, const Words<Value>& words,
             InflowEntry entry, InflowEntry user) {
  if (!table.clean("entry"))
    table.skip(key);
  else if (entry == user)
    table.read_word(key, kind, target, words);
  else
    table.refuse(key, "is used with entry = \"" + word_of(entry_words(), user) +
                          "\" only; the entry here is \"" + word_of(entry_words(), entry) + '"');
}
}  // namespace

void read_inflow(Table& table, const std::vector<Species>* species, Inflow& inflow) {
  read_side(table, inflow.axis, inflow.high);
  read_species_name(table, species, inflow.species);
  table.require("number-density", inflow.number_density,
                "real particles per area or volume of the gas beyond the side");
  table.read("velocity", inflow.velocity);
  table.require("temperature", inflow.temperature, "granular temperature of the stream; 0 is a beam");
  table.read("spin-temperature", inflow.spin_temperature);
  table.read_word("entry", "way to enter", inflow.entry, entry_words());
  read_of(table, "arrivals", "way to arrive", inflow.arrivals, arrivals_words(), inflow.entry,
          InflowEntry::flux);
  read_of(table, "piston", "kind of piston", inflow.piston, piston_words(), inflow.entry,
          InflowEntry::dispenser);
  table.finish();
}

}  // namespace sandglass
