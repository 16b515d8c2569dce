#pragma once

#include "sim/scene/text/table.hpp"
#include "validation/suite/case.hpp"
#include "validation/suite/pattern.hpp"

// The parts of read_case(), one file for each kind of entry.

namespace sandglass {

/// What the selections of a case choose from, and where a pattern that matches nothing is reported.
struct Choices {
  std::vector<Choice> points, variants;
  Diagnostics* diagnostics;

  /// The keys 'points' and 'variants'.
  void read(Table& table, Selection& where) const;
  /// One of them: the names that its patterns choose; nothing when the key is absent.
  std::vector<std::string> read_points(Table& table) const;
  std::vector<std::string> read_variants(Table& table) const;
};

/// Names and tags of the tables [[key]].
std::vector<Choice> choices_of(const Node& document, const std::string& key);
/// By name alone.
template <class Entries>
std::vector<Choice> choices_of(const Entries& entries) {
  std::vector<Choice> choices;
  for (const auto& entry : entries) choices.push_back({entry.name, {}});
  return choices;
}

/// The variants of all cases, and what they cannot do.
/// Numbers that each of the checks takes.
void read_numbers(Table& table, const Node& node, const std::string& key,
                  const std::vector<std::string>& checks, Diagnostics& diagnostics, law::Arguments& numbers);

struct SharedLimit {
  std::vector<std::string> checks, variants,
      points;  ///< patterns; points that a case does not have match nothing
  std::string reason;
  law::Arguments instead;
};
struct SharedVariant {
  struct Addition {
    std::vector<std::string>
        checks;  ///< patterns: added to cases that make one of these checks of the variant
    AddedObservers observers;
  };
  Variant variant;
  std::vector<Addition> additions;
};
struct VariantLibrary {
  std::vector<SharedVariant> variants;
  std::vector<SharedLimit> limits;
};
/// Empty when there is no such file.
VariantLibrary read_variant_library(const std::string& file);

/// The variants of a case: those of the library that its 'variants' and 'needs' choose, and its own.
std::vector<SharedVariant> read_variants(Table& root, const Node& document, const VariantLibrary& library,
                                         Diagnostics& diagnostics);
/// [[variant]]: the case's own, and what the case changes of shared ones.
void read_own_variants(Table& root, const Node& document, const std::string& file, const Choices& choices,
                       Case& result);
void read_checks(Table& root, const Node& document, const VariantLibrary& library, const Choices& choices,
                 Case& result);
void read_tiers(Table& root, const Node& document, const std::string& file, const Choices& choices,
                Case& result);
void read_sweeps(Table& root, const Node& document, const std::string& file, const Choices& choices,
                 Case& result);
void read_mutants(Table& root, const Node& document, const std::string& file, const Choices& choices,
                  Case& result);

/// A whole file; throws InputError when it cannot be read.
std::string read_text(const std::string& path);
/// A text or a list of texts.
std::vector<std::string> read_words(Table& table, const std::string& key);
/// Reports each pattern that matches none of the choices.
void report_idle(const std::vector<std::string>& patterns, const std::string& kind,
                 const std::vector<Choice>& choices, const std::string& path, Diagnostics& diagnostics);
/// Those that the patterns under the key choose, after a report of what matches nothing.
std::vector<std::string> read_choice(Table& table, const std::string& key, const std::string& kind,
                                     const std::vector<Choice>& choices, Diagnostics& diagnostics);
/// The table `key`: its keys are those of a scene, judged when it is laid over one.
Override read_set(Table& table, const Node& node, const std::string& key, const std::string& file);
const Node* entry_of(const Node& table, const std::string& key);

/// Reads the entries of one kind of [[table]]: what the Table sees, and the Node with its overrides.
template <class Read>
void read_each(Table& parent, const Node& node, const std::string& key, Read read) {
  std::vector<Table> tables = parent.tables(key);
  const Node* list = entry_of(node, key);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    read(tables[i], list->items[i]);
    tables[i].finish();
  }
}

}  // namespace sandglass
