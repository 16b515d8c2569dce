"""Which figures a source has, what it says of them, and what draws ours: reference/source/<SOURCE>/figures.toml."""

from dataclasses import dataclass

from analysis.checked import read_toml
from analysis.errors import InputError
from analysis.source import bed, channel, clustering, cooling, correlations, heap, mixing, pipe, rest, shear
from analysis.source.methods import FOLDER

DRAWINGS = {"MUL": cooling.FIGURES | clustering.FIGURES | shear.FIGURES | pipe.FIGURES | heap.FIGURES
            | correlations.FIGURES | bed.FIGURES,
            "GRE": mixing.FIGURES,
            "KAW": rest.FIGURES | channel.FIGURES}


@dataclass(frozen=True)
class SourceFigure:
    """`case` is empty where the source's figure is not covered, for the reason in `missing`."""

    number: str
    shows: str
    says: str
    case: str
    missing: str
    claim: str    # of the ledger, that the figure shows; or empty


@dataclass(frozen=True)
class Catalogue:
    name: str
    source: str
    figures: list[SourceFigure]


def _figure(node):
    text = {name: node.text(name) if node.has(name) else "" for name in ("says", "case", "missing", "claim")}
    if bool(text["case"]) == bool(text["missing"]):
        node.fail("needs either 'case' or 'missing'", "say which case draws it, or why none does")
    return SourceFigure(node.text("number"), node.text("shows"), **text)


def catalogue(name):
    """The figures of a source. Throws InputError for a source that has none."""
    path = FOLDER / name / "figures.toml"
    if name not in DRAWINGS or not path.is_file():
        raise InputError("source-figures", "", f"no figures of a source '{name}'", f"give one of {', '.join(DRAWINGS)}")
    root = read_toml(path)
    return Catalogue(name, root.text("source"), [_figure(node) for node in root["figure"]])
