"""A report folder or a record, read strictly: what is wrong is said with file, key and remedy."""

from dataclasses import fields
from pathlib import Path

from analysis import model
from analysis.checked import Node, read_json, read_toml
from analysis.record import load_record
from analysis.words import CLAIM_STATES, EXPECTATIONS, VERDICTS

__all__ = ["load_record", "load_report", "load_verdicts"]

READERS = {str: Node.text, float: Node.number, model.Number: Node.number, int: Node.whole, bool: Node.flag}


def _plain(kind, node, /, **given):
    """A dataclass of plain values, each read from the key of the same name; `given` holds the others."""
    rest = {f.name: READERS[f.type](node, f.name) for f in fields(kind) if f.name not in given}
    return kind(**given, **rest)


def _verdict(node):
    parts = _plain(model.Budget, node["budget_parts"])
    return _plain(model.Verdict, node, verdict=node.one_of("verdict", VERDICTS), budget_parts=parts,
                  kind=node.one_of("kind", EXPECTATIONS) if node.has("kind") else "equal",
                  upper=node.number("upper") if node.has("upper") else None,
                  known_limit=node.text("known_limit") if node.has("known_limit") else "")


def _verdicts(node):
    found = {}
    for item in node:
        verdict = _verdict(item)
        if verdict.key in found:
            item.fail(f"{' / '.join(verdict.key)} appears twice", "give each check of a run its own name")
        found[verdict.key] = verdict
    return found


def _array(node, name, length, optional=False):
    numbers = node.numbers(name)
    if len(numbers) != length and not (optional and not numbers):
        node[name].fail(f"has {len(numbers)} values where x has {length}",
                        "give all arrays of a set the same length" + (", or none" if optional else ""))
    return numbers


def _points(node):
    x = node.numbers("x")
    return model.Points(node.text("name"), x, _array(node, "y", len(x)),
                        _array(node, "error", len(x), True), _array(node, "expected", len(x), True))


def _line(node):
    x = node.numbers("x")
    return model.Line(node.text("name"), x, _array(node, "y", len(x)))


def _figure(node):
    return model.Figure(node.text("title"), _plain(model.Axis, node["x"]), _plain(model.Axis, node["y"]),
                        [_points(item) for item in node["points"]], [_line(item) for item in node["lines"]])


def _evidence(node, case, verdicts):
    key = (case, node.text("variant"), node.text("point"), node.text("check"))
    said = node.one_of("verdict", VERDICTS)
    if key not in verdicts or verdicts[key].verdict != said:
        judged = verdicts[key].verdict if key in verdicts else "absent"
        node.fail(f"{' / '.join(key)} is '{said}' here and '{judged}' in verdicts.json")
    return model.Evidence(verdicts[key], node.text("law"), [_figure(item) for item in node["figures"]])


def _run(node):
    counters = {name: node["counters"].number(name) for name in node["counters"].expect(dict)}
    provenance = {name: node["provenance"].text(name) for name in node["provenance"].expect(dict)}
    return _plain(model.Run, node, counters=counters, provenance=provenance)


def _case(node, verdicts):
    name = node.text("case")
    evidence = [_evidence(item, name, verdicts) for item in node["evidence"]]
    shown = {item.verdict.key for item in evidence}
    for key in verdicts:
        if key[0] == name and key not in shown:
            node["evidence"].fail(f"{' / '.join(key)} stands in verdicts.json but not here")
    return model.Case(name, node.text("topic"), node.text("summary"), node.text("question"),
                      [item.expect(str) for item in node["claims"]],
                      [_plain(model.Equation, item) for item in node["equations"]], node.text("readme"),
                      [_run(item) for item in node["runs"]], evidence)


def _sweep(node):
    return _plain(model.Sweep, node, points=[_plain(model.SweepPoint, item) for item in node["points"]])


def _claims(path):
    if path is None or not path.is_file():
        return []
    return [_plain(model.Claim, item, status=item.one_of("status", CLAIM_STATES),
                   evidence=tuple(case.expect(str) for case in item["evidence"]) if item.has("evidence") else (),
                   note=item.text("note") if item.has("note") else "")
            for item in read_toml(path)["claim"]]


def _optional(folder, name):
    return read_json(folder, name) if (folder / name).exists() else []


def load_verdicts(folder):
    """The verdicts of a report folder by their key, with nothing else of it. Throws InputError."""
    return _verdicts(read_json(Path(folder), "verdicts.json"))


def load_report(folder, claims=None):
    """Everything in a report folder.

    `claims` is the ledger of claims (reference/claims.toml), when there is one. Throws InputError.
    """
    folder = Path(folder)
    verdicts = load_verdicts(folder)
    names = dict.fromkeys(key[0] for key in verdicts)
    cases = [_case(read_json(folder, f"evidence/{name}.json"), verdicts) for name in names]
    mutants = [_plain(model.Mutant, item, verdict=item.one_of("verdict", VERDICTS))
               for item in _optional(folder, "mutants.json")]
    sweeps = [_sweep(item) for item in _optional(folder, "sweeps.json")]
    keys = [_plain(model.Key, item, trials=[_plain(model.KeyTrial, trial) for trial in item["trials"]])
            for item in _optional(folder, "keys.json")]
    return model.Report(list(verdicts.values()), cases, sweeps, mutants, keys, _claims(claims))
