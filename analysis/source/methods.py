"""The methods that a source compares, in the order of its figures: `methods` of figures.toml."""

import tomllib
from pathlib import Path

FOLDER = Path(__file__).parent.parent.parent / "reference" / "source"
METHODS = tomllib.loads((FOLDER / "MUL" / "figures.toml").read_text(encoding="utf-8"))["methods"]
EXACT, OWN, PLAIN = METHODS[:3]   # finds contacts; the source's own; what that started from
FITTED = "-pb"                    # ends the name of a method with fitted impact parameters
