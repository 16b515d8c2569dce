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
                          "its source says that the method misses this, and the run shows it; does not block"),
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


def _shared(value, error):
    """(power of ten taken out, decimals) that show `value` to the second digit of `error`."""
    size = math.floor(math.log10(max(abs(value), error)))
    places = 1 - math.floor(math.log10(error))
    power = size if size >= 6 or size <= -4 or (size < 0 and places > 6) else 0
    return power, max(0, places + power)


def _fixed(value, power, places):
    return f"{value / 10.0 ** power:.{places}f}".replace("-", "−")


def _scaled(text, power):
    return f"{text}×10{str(power).translate(SUPERSCRIPT)}" if power else text


def _has_digits(value, error):
    known = value is not None and error is not None and math.isfinite(value) and math.isfinite(error)
    return known and error > 0


def with_error(value, error):
    """Value ± standard error, both to the second digit of the error: '(1.4922 ± 0.0013)×10⁶'."""
    if not _has_digits(value, error):
        return number(value, 2 if value is not None and abs(value) < 1e-9 else 6)
    power, places = _shared(value, error)
    text = f"{_fixed(value, power, places)} ± {_fixed(error, power, places)}"
    return _scaled(f"({text})", power) if power else text


def expectation(item):
    """What a check expects of its value, to the digits of that: '1.0010', '≤ 0.30' where only one side is wrong."""
    def shown(bound):
        if bound is None or not _has_digits(item.value, item.stderr):
            return number(bound, 6)
        power, places = _shared(item.value, item.stderr)
        exact = number(bound, 6)
        rounded = _scaled(_fixed(bound, power, places), power if bound else 0)
        return exact if len(exact) < len(rounded) and power == 0 else rounded
    return EXPECTATIONS[item.kind].format(shown(item.expected), shown(item.upper))


def said(text):
    """A sentence of the judge in the notation of the page: 5.5e-13 becomes 5.5×10⁻¹³, +- becomes ±."""
    def power(match):
        return "×10" + (match[1].replace("+", "") + match[2]).translate(SUPERSCRIPT)
    raised = re.sub(r"(?<=\d)e([-+]?)0*(\d+)", power, text.replace("+-", "±"))
    return re.sub(r"(?<![\w.])-(?=\d)", "−", raised)


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


def brief(value):
    """Seconds for a narrow cell: '20 s', '0.6 s', '3 ms', '2 min'."""
    if value is None:
        return UNKNOWN
    if value < 0.1:
        return f"{1000 * value:.0f} ms" if value >= 0.001 else "<1 ms"
    if value < 9.95:
        return f"{value:.1f} s"
    return f"{value:.0f} s" if value < 99.5 else f"{value / 60:.0f} min" if value < 5970 else f"{value / 3600:.0f} h"


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
