"""What method variants and points are, in words: from validation/case/variants.toml and from the scenes."""

import tomllib
from pathlib import Path

from analysis.words import number

VARIANTS = Path(__file__).parent.parent / "validation" / "case" / "variants.toml"
SAME = "the same"
AMOUNTS = {"count": "N = {}", "number-density": "number density {}", "area-fraction": "area fraction {}",
           "volume-fraction": "volume fraction {}"}


def method_summaries(path=VARIANTS):
    """{variant: what it is}; a summary that goes on from the one above it names that one."""
    if not path.is_file():
        return {}
    found, last = {}, ""
    for item in tomllib.loads(path.read_text(encoding="utf-8"))["variant"]:
        summary = item.get("summary", "")
        if summary.startswith(SAME):
            summary = f"like {last}{summary[len(SAME):]}"
        else:
            last = item["name"]
        found[item["name"]] = summary
    return found


def _species(scene):
    found = scene.get("species", [])
    return found if isinstance(found, list) else [found]


def _box(scene):
    domain = scene.get("domain", {})
    size = domain.get("size", [])
    return [f"{len(size)}D", "box " + " × ".join(number(edge, 3) for edge in size)] if size else []


def _particles(scene):
    species = _species(scene)
    if len(species) > 1:
        return [f"{len(species)} species"]
    parts = [text.format(number(item[key], 6)) for item in species for key, text in AMOUNTS.items() if item.get(key)]
    return parts + [f"restitution {item['restitution']:.6g}" for item in species if "restitution" in item]


def _drive(scene):
    gravity, replicas = scene.get("forces", {}).get("gravity"), scene.get("run", {}).get("replicas", 1)
    parts = [f"gravity {number(max(map(abs, gravity)), 3)}"] if gravity else []
    return parts + ([f"replicas {replicas}"] if replicas > 1 else [])


def describe(text):
    """The setting of a scene in a line; '' where it cannot be read."""
    try:
        scene = tomllib.loads(text)
        return ", ".join(_box(scene) + _particles(scene) + _drive(scene))
    except (tomllib.TOMLDecodeError, TypeError, ValueError, KeyError):
        return ""


def points(case):
    """{point: its setting}, from the first run of each."""
    found = {}
    for run in case.runs:
        found.setdefault(run.point, describe(run.scene))
    return found
