"""A small report folder that looks like a real one and holds what is awkward: every verdict, unknown numbers,
a set with one point, hostile and long names, a record that was not kept. The numbers are made up."""

import json
import sys
from pathlib import Path

import numpy as np

TOP = Path(__file__).parent.parent   # the room 'analysis'
VARIANTS = ["dsmc", "dsmc-enskog", "cba", "cba-corrected", "cuba"]
HOSTILE = '<script>alert("x")</script> & $\\frac{1}{0$ </style>'
LONG = "3d-a-point-with-a-name-so-long-that-no-column-of-any-table-could-hold-it-without-breaking-the-line"
PROVENANCE = {"program_version": "0.1.0", "commit": "0123456789abcdef+changes",
              "build": "Release g++ 12.2 -O3",              "created": "2024-05-01T12:00:00Z"}
SCENE = '[domain]\nsize = [100.0, 100.0]\n\n[species]\narea-fraction = 0.25\nname = "<b>disks</b>"\n'
README = """# Equilibrium gas
Elastic disks in a *periodic* box; **nothing** may drift, see `scene.toml` and
[Enskog](https://example.org/enskog).

- collision rate
- pressure with the
  contact value

| quantity | source |
|---|---|
| rate | Enskog |

```toml
restitution = 1.0  # <elastic>
```
<img src=x onerror=alert(1)> and [a file](../../law/haff.hpp) and [bad](javascript:alert(1))
"""


def verdict(case, variant, point, check, word="pass", value=1.0, stderr=0.001, expected=1.001, **more):
    """A verdict whose numbers agree with each other."""
    known = value is not None and stderr is not None
    budget = 4 * stderr + 0.001 if known else None
    deviation = abs(value - expected) if known else None
    row = {"case": case, "variant": variant, "point": point, "check": check, "claim": "BAR-2",
           "summary": f"{check.replace('-', ' ')} against theory", "units": "time^-1", "verdict": word,
           "reason": f"deviation {deviation:.3g}, budget {budget:.3g}" if known else "no error bar",
           "value": value, "stderr": stderr, "expected": expected, "deviation": deviation, "budget": budget,
           "budget_parts": {"statistical": 4 * stderr if known else None, "reference": 0.0,
                            "systematic": 0.001, "reason": "finite N: 1/N of the rate", "resolution": 0.01},
           "cpu_seconds": 1.53, "work": 1.0e7, "work_units": "particle-moves", "peak_bytes": 1.2e6, "seed": 1,
           "tier": "standard"}
    return row | more


def axis(label, units, logarithmic=False):
    return {"label": label, "units": units, "logarithmic": logarithmic}


def decay_figure(seed):
    draw = np.random.default_rng(seed)
    x = np.geomspace(0.1, 1000, 25)
    theory = (1 + x) ** -2
    y = theory * (1 + 0.02 * draw.standard_normal(x.size))
    points = {"name": "ten replicas", "x": x.tolist(), "y": y.tolist(), "error": (0.02 * theory).tolist(),
              "expected": theory.tolist()}
    points["y"][5] = None
    return {"title": "granular temperature against time", "x": axis("time / t0", "1", True),
            "y": axis("granular temperature", "mass length^2 time^-2", True), "points": [points],
            "lines": [{"name": "Haff's law", "x": x.tolist(), "y": theory.tolist()}]}


def histogram_figure(seed, title="velocity distribution"):
    draw = np.random.default_rng(seed)
    x = np.linspace(-3, 3, 31)
    theory = np.exp(-x * x / 2) / np.sqrt(2 * np.pi)
    sets = [{"name": f"component {name}", "x": x.tolist(), "error": [0.004] * 31, "expected": theory.tolist(),
             "y": (theory + 0.004 * draw.standard_normal(31)).tolist()} for name in "xy"]
    return {"title": title, "x": axis("velocity", "length time^-1"), "y": axis("density", "time length^-1"),
            "points": sets, "lines": [{"name": "Maxwell", "x": x.tolist(), "y": theory.tolist()}]}


def single_figure():
    return {"title": "one sample", "x": axis("time", "time"), "y": axis("collision rate", "time^-1"),
            "lines": [],
            "points": [{"name": "a single point", "x": [1.0], "y": [1.02], "error": [], "expected": [1.0]},
                       {"name": "nothing at all", "x": [], "y": [], "error": [], "expected": []}]}


def empty_figure():
    return {"title": "unknown " + HOSTILE, "x": axis("x $", "1"), "y": axis("y", "1"), "lines": [],
            "points": [{"name": HOSTILE, "x": [1.0, 2.0], "y": [None, None], "error": [None, None],
                        "expected": []}]}


def equilibrium():
    rows = []
    for index, point in enumerate(["2d-dilute", "2d-nu-0.05", "2d-nu-0.25", "3d-nu-0.20"]):
        for column, variant in enumerate(VARIANTS):
            limit = variant == "dsmc" and index > 1
            value = 0.74 if limit else 1 + 0.0006 * np.sin(3 * index + column)
            rows += [(verdict("equilibrium-gas", variant, point, "collision-rate",
                              "expected-fail" if limit else "pass", float(value)), [histogram_figure(index)]),
                     (verdict("equilibrium-gas", variant, point, "momentum-conservation", "pass", 1e-15, 0.0,
                              0.0, units="mass length time^-1", claim=""), [])]
    return rows


def awkward():
    case = 'awkward <b> & "case"'
    return [
        (verdict(case, "cba", "2d", "fails", "fail", 1.3, reason=HOSTILE),
         [single_figure(), decay_figure(1)]),
        (verdict(case, "cba", LONG, "unknown", "inconclusive", None, None, None, cpu_seconds=None),
         [empty_figure()]),
        (verdict(case, HOSTILE, "2d", "surprise", "unexpected-pass", summary=HOSTILE, claim="MUL-4"), []),
    ]


def cooling():
    return [(verdict("homogeneous-cooling", variant, f"2d-restitution-{r}", "haff", value=1.0004, units="1",
                     claim="MUL-1, MUL-3"), [decay_figure(3)])
            for r in (0.9, 0.5) for variant in ("dsmc", "cba")]


def evidence(rows):
    """evidence/<case>.json of these verdicts."""
    runs = {}
    for row, _ in rows:
        runs[row["variant"], row["point"]] = {
            "variant": row["variant"], "point": row["point"], "seed": 1, "scene": SCENE,
            "record": "records/not-kept.h5", "cpu_seconds": row["cpu_seconds"], "wall_seconds": 1.6,
            "peak_bytes": 1.2e6, "work": 1e7, "work_units": "particle-moves",
            "counters": {"collisions": 1000000, "bound-exceeded": 0}, "provenance": PROVENANCE}
    equations = [{"tex": "\\omega = 2\\sqrt{\\pi}\\, n d\\, g(\\nu)\\sqrt{T/m}",
                  "text": "omega = 2 sqrt(pi) n d g sqrt(T/m)", "citation": "Enskog collision rate of disks"},
                 {"tex": "\\nosuchcommand{", "text": "p = n T < unreadable >", "citation": HOSTILE}]
    return {"case": rows[0][0]["case"], "topic": "kinetic-theory",
            "summary": "Elastic gas against Enskog theory",
            "question": "Does each method give the Enskog collision rate?", "claims": ["BAR-2"],
            "equations": equations, "readme": README, "runs": list(runs.values()),
            "evidence": [row | {"law": "enskog-collision-rate", "figures": figures} for row, figures in rows]}


def sweep(knob="time-step", variant="dsmc", order=2.0, knobs=(0.125, 0.25, 0.5, 1.0, 2.0)):
    points = [{"knob": k, "value": 0.5 + 0.01 * k**order, "stderr": 0.001, "error": 0.01 * k**order,
               "cpu_seconds": 4 / k, "work": 1e7 / k} for k in knobs]
    return {"case": "shear-wave", "variant": variant, "knob": knob, "knob_label": f"{knob} [mean free times]",
            "quantity": "kinematic viscosity", "units": "length^2 time^-1", "reference": 0.5,
            "reference_error": 0.002, "reference_source": "Enskog theory, first order", "expected_order": 2,
            "points": points, "order": 0.98 * order, "order_stderr": 0.1,
            "order_reason": "weighted fit over clear points"}


def unfitted_sweep():
    broken = sweep("replicas", "cba", -0.5, (1, 4))
    unknown = dict.fromkeys(("value", "stderr", "error", "cpu_seconds", "work"))
    broken["points"].append({"knob": 8} | unknown)
    fit = {"order": None, "order_stderr": None, "order_reason": "too few points", "expected_order": None}
    return broken | fit


def mutant(mutation, check, caught):
    return {"mutation": mutation, "summary": mutation.replace("-", " "), "case": "equilibrium-gas",
            "variant": "dsmc", "point": "2d-dilute", "check": check,
            "verdict": "fail" if caught else "pass", "caught": caught,
            "value": 1.05, "expected": 1.0, "budget": 0.004}


def key(name, family, *trials):
    made = [{"case": "equilibrium-gas", "variant": family, "point": "2d-dilute", "how": how, "check": check}
            for how, check in trials]
    return {"key": name, "family": family, "used": bool(trials), "seen": bool(trials) and bool(trials[-1][1]), "trials": made}


def documents():
    """{file name: content} of the whole folder."""
    groups = [equilibrium(), cooling(), awkward()]
    files = {f"evidence/{rows[0][0]['case']}.json": evidence(rows) for rows in groups}
    files["verdicts.json"] = [row for rows in groups for row, _ in rows]
    files["sweeps.json"] = [sweep(), sweep("cell-size", order=1.0), unfitted_sweep()]
    files["mutants.json"] = [mutant("cross-section-plus-5-percent", "collision-rate", True),
                             mutant("cross-section-plus-5-percent", "momentum-conservation", False),
                             mutant("acceptance-inverted", "collision-rate", True),
                             mutant("offset-dropped", "haff", False)]
    files["keys.json"] = [key("species.restitution", "dsmc", ("5% less", "haff")),
                          key("method.random-offset", "dsmc", ("5% more", ""), ("left out", "")),
                          key("wall.temperature", "")]
    return files


def wide():
    """A case as large as the largest of the suite: 26 points, eight methods, four checks and an identity."""
    methods = VARIANTS + ["hsmc", "esmc", "event-driven"]
    rows = []
    for index in range(26):
        for column, method in enumerate(methods):
            for number, check in enumerate(["haff-cooling", "cooling-per-collision", "sonine-coefficient", "compressibility"]):
                value = 10.0 ** (index % 7) * (1 + 0.0006 * np.sin(3 * index + column + number))
                expected = 10.0 ** (index % 7)
                rows.append((verdict("large-case", method, f"hard-3d-nu-0.{index:02}-r-0.9", check, "pass", float(value),
                                     0.001 * expected, expected), []))
            rows.append((verdict("large-case", method, f"hard-3d-nu-0.{index:02}-r-0.9", "momentum-conservation", "pass",
                                 1e-15, 0.0, 0.0), []))
    return rows


def many_methods():
    """More methods than columns of their natural width have room for."""
    return [(verdict("many-methods", f"a-method-of-a-long-name-{index}", "2d", f"check-{number}"), [])
            for index in range(18) for number in range(12)]


def write(folder, files):
    for name, content in files.items():
        path = Path(folder) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(content), encoding="utf-8")
    return Path(folder)


def ledger(folder):
    """Writes a small ledger of claims; returns its path."""
    path = Path(folder) / "claims.toml"
    states = {"BAR-2": "reproduced", "MUL-1": "not reproduced", "GRE-1": "not yet tested"}
    rows = [f'[[claim]]\nid = "{name}"\nsource = "a source"\ntext = "a claim"\nstatus = "{status}"\n'
            for name, status in states.items()]
    path.write_text("".join(rows), encoding="utf-8")
    return path


if __name__ == "__main__":
    write(sys.argv[1], documents())
