"""JSON and TOML values that know their file and key, so that an error can name both."""

import json
import math
import tomllib
from pathlib import Path

from analysis.errors import InputError

REMEDY = "write the folder again with 'sandglass validate' (format: docs/file-formats.md)"
WORDS = {dict: "an object", list: "an array", str: "a text", bool: "true or false", int: "a whole number"}


class Node:
    """One value of a document with the way to it."""

    def __init__(self, value, file, key=""):
        self.value, self.file, self.key = value, file, key

    def fail(self, problem, remedy=REMEDY):
        raise InputError(self.file, self.key, problem, remedy)

    def expect(self, kind):
        """The plain value, when it is of this kind."""
        wrong = not isinstance(self.value, kind) or (kind is int and isinstance(self.value, bool))
        if wrong:
            self.fail(f"must be {WORDS[kind]}, found {json.dumps(self.value)[:40]}")
        return self.value

    def __getitem__(self, name):
        if name not in self.expect(dict):
            self.fail(f"key '{name}' is missing")
        return Node(self.value[name], self.file, f"{self.key}.{name}" if self.key else name)

    def __iter__(self):
        for index, value in enumerate(self.expect(list)):
            yield Node(value, self.file, f"{self.key}[{index}]")

    def has(self, name):
        return name in self.expect(dict)

    def text(self, name):
        return self[name].expect(str)

    def flag(self, name):
        return self[name].expect(bool)

    def whole(self, name):
        return self[name].expect(int)

    def number(self, name):
        """A finite float, or None where the writer had none (null)."""
        return self[name].as_number()

    def as_number(self):
        if self.value is None:
            return None
        if isinstance(self.value, bool) or not isinstance(self.value, (int, float)):
            self.fail(f"must be a number or null, found {json.dumps(self.value)[:40]}")
        return float(self.value)

    def numbers(self, name):
        """An array of floats; null becomes NaN, which no figure draws."""
        numbers = [item.as_number() for item in self[name]]
        return [math.nan if number is None else number for number in numbers]

    def one_of(self, name, allowed):
        word = self.text(name)
        if word not in allowed:
            self[name].fail(f"'{word}' is not one of {', '.join(allowed)}")
        return word


def _not_finite(word):
    raise ValueError(f"{word} is not a JSON number (null stands for it)")


def read_json(folder, name):
    """The document `name` of a report folder; the errors show `name` alone."""
    try:
        text = (Path(folder) / name).read_text(encoding="utf-8")
        return Node(json.loads(text, parse_constant=_not_finite), name)
    except OSError as error:
        raise InputError(Path(folder) / name, "", error.strerror or "cannot be read", REMEDY) from error
    except ValueError as error:
        raise InputError(name, "", f"not valid JSON: {error}", REMEDY) from error


def read_toml(path):
    try:
        return Node(tomllib.loads(path.read_text(encoding="utf-8")), path.name)
    except (OSError, ValueError) as error:
        raise InputError(path, "", f"not valid TOML: {error}", "correct the file") from error
