"""c(tau) of the impact distribution a/(1 - c b^2) (Müller 2001, 3.18) from an event-driven record, as TOML."""

import tomllib

import numpy as np

from analysis.errors import InputError
from analysis.record import load_record

LOWEST, HIGHEST = -10.0, 0.999   # of c, as a scene allows it


def share_below(c, b):
    """Share of the disks' collisions with |b| below b, in diameters."""
    if abs(c) < 1e-6:
        return b * (1 + c * b**2 / 3) / (1 + c / 3)
    root = np.sqrt(abs(c))
    curve = np.arctanh if c > 0 else np.arctan
    return curve(root * b) / curve(root)


def fitted(edges, counts):
    """(c, its standard error): the likeliest c of independent collisions counted in bins of |b|."""
    def likelihood(s):   # in s = -ln(1 - c) it is smooth and has one maximum
        shares = np.diff(share_below(-np.expm1(-s), edges))
        return np.sum(counts * np.log(shares))
    low, high = -np.log1p(-LOWEST), -np.log1p(-HIGHEST)
    golden = (np.sqrt(5) - 1) / 2
    while high - low > 1e-6:
        left, right = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, right) if likelihood(left) > likelihood(right) else (left, high)
    s, h = (low + high) / 2, 1e-2
    bend = (likelihood(s + h) - 2 * likelihood(s) + likelihood(s - h)) / h**2
    return -np.expm1(-s), np.exp(-s) / np.sqrt(-bend)


def _counts(record, path):
    if "impact-parameter" not in record.series:
        raise InputError(path, "", "has no series 'impact-parameter'",
                         "run an event-driven scene with the observer 'impact-parameter'")
    scene = tomllib.loads(record.scene)
    if scene["domain"]["dimension"] != 2:
        raise InputError(path, "", "is of spheres; (3.18) is fitted to disks", "give a record in two dimensions")
    return record.series["impact-parameter"], sum(each["count"] for each in scene["species"])


def windows(path, width):
    """[(tau, c, error)] in windows of that many collisions per particle, all replicas together.

    The error takes collisions as independent; replicas of a gas that clusters differ by more.
    """
    impacts, particles = _counts(load_record(path), path)
    edges = np.asarray(impacts[0].quantity.axis)
    ends = [2 * np.cumsum(each.value.sum(axis=1)) / particles for each in impacts]   # of the samples, in tau
    last = min(each[-1] for each in ends)
    if last < width:
        raise InputError(path, "", f"ends at {last:.3g} collisions per particle, before the first window of {width:g}",
                         "run longer, or give a smaller --window")
    rows = []
    for begin in np.arange(0, last - width * (1 - 1e-2), width):
        inside = [(end > begin + 1e-9) & (end <= begin + width * (1 + 1e-2)) for end in ends]
        counts = sum(each.value[chosen].sum(axis=0) for each, chosen in zip(impacts, inside))
        if not counts.all():
            raise InputError(path, "", f"has an empty bin between tau = {begin:g} and {begin + width:g}",
                             "run more replicas, or give a larger --window or fewer bins")
        rows.append((begin + width / 2, *fitted(edges, counts)))
    return rows


def print_coefficient(path, width):
    rows = windows(path, width)
    print(f"# c of p(b) = a/(1 - c b^2), windows of {width:g} collisions per particle; standard errors "
          + ", ".join(f"{error:.2g}" for *_, error in rows))
    listed = [", ".join(f"{row[column]:.4g}" for row in rows) for column in (0, 1)]
    print(f"impact-coefficient = {{ collisions-per-particle = [{listed[0]}], value = [{listed[1]}] }}")
