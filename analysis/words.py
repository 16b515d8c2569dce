"""Verdicts, numbers, units and times as a reader sees them."""

import math
import re
import zlib
from dataclasses import dataclass

SUPERSCRIPT = str.maketrans("-+0123456789", "⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹")
UNKNOWN = "–"


@dataclass(frozen=True)
class Look:
    """How a verdict is shown: never by colour alone. Colours: Okabe and Ito's palette; red: Tol's."""

    symbol: str
    word: str
    colour: str
    meaning: str


# From good to bad: of several verdicts in one cell the last one shows.
VERDICTS = {
    "pass": Look("✓", "pass", "#009e73", "the deviation lies inside the error budget"),
    "expected-fail": Look("◇", "known limit", "#0072b2",
                          "the method is known to miss this, and does; counts as fine"),
    "inconclusive": Look("?", "inconclusive", "#e69f00", "the error bar is too wide to tell; blocks"),
    "unexpected-pass": Look("!", "unexpected pass", "#cc79a7", "a known limit was not seen; blocks"),
    "fail": Look("✗", "fail", "#cc3311", "the deviation exceeds the error budget; blocks"),
}

GOOD = ("pass", "expected-fail")   # every other verdict blocks
ABSENT = "the case does not run this method"
EXPECTATIONS = {"equal": "{}", "at-least": "≥ {}", "at-most": "≤ {}", "between": "{} to {}"}
CLAIM_STATES = {"reproduced": ("✓", "pass"), "not reproduced": ("✗", "fail"),
                "not yet tested": ("·", "plain")}


def worst(verdicts):
    return max(verdicts, key=list(VERDICTS).index)


def number(value, digits=4):
    """1234.5 -> '1234', 1.2e-7 -> '1.2×10⁻⁷'."""
    if value is None or not math.isfinite(value):
        return UNKNOWN
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    power = f"×10{str(int(exponent)).translate(SUPERSCRIPT)}" if exponent else ""
    return (mantissa + power).replace("-", "−")


def ratio(share):
    """A deviation in units of its budget, short enough for a cell: '0.85', '<0.01', '12', '∞'."""
    if share is None:
        return UNKNOWN
    if math.isinf(share):
        return "∞"
    if 0 < share < 0.005:
        return "<0.01"
    return number(share, 2) if share >= 10 else f"{share:.2f}" if share else "0"


def factor(ratio):
    """How many times as much: '×1.3', '×0.042', '×12'."""
    return f"×{number(ratio, 2)}"


def expectation(item):
    """What a check expects of its value: '1.001', '≤ 0.3' where only one side is wrong, or '0.5 to 2'."""
    return EXPECTATIONS[item.kind].format(number(item.expected, 6), number(item.upper, 6))


def with_error(value, error):
    """Value ± standard error, both to the second digit of the error."""
    if value is None or error is None:
        return number(value, 6)
    if error <= 0 or not 1e-6 <= error <= 1e6 or abs(value) >= 1e7:
        return f"{number(value, 6)} ± {number(error, 2)}"
    places = max(0, 1 - math.floor(math.log10(error)))
    return f"{value:.{places}f} ± {error:.{places}f}".replace("-", "−")


def units(text):
    """'mass length^2 time^-2' -> 'mass length² time⁻²'; '' for a pure number."""
    if text in ("", "1"):
        return ""
    return re.sub(r"\^([-+]?\d+)", lambda match: match[1].translate(SUPERSCRIPT), text)


def labelled(label, unit):
    return f"{label} [{units(unit)}]" if units(unit) else label


def seconds(value):
    if value is None:
        return UNKNOWN
    if value < 0.9995:
        return f"{1000 * value:.3g} ms"
    if value < 59.95:
        return f"{value:.3g} s"
    minutes, rest = divmod(round(value), 60)
    return f"{minutes} min {rest} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"


def size(value):
    """Bytes with a decimal prefix."""
    if value is None:
        return UNKNOWN
    for unit in ("B", "kB", "MB"):
        if value < 999.5:
            return f"{value:.3g} {unit}"
        value /= 1000
    return f"{value:.3g} GB"


def slug(*parts):
    """A file name or anchor for these names; names that need rewriting keep apart by a checksum."""
    plain = "--".join(parts)
    safe = re.sub(r"[^A-Za-z0-9.-]+", "-", plain)[:100].strip("-.")
    return safe if safe == plain else f"{safe}-{zlib.crc32(plain.encode()):08x}"
