"""Figures 5.2 to 5.6 of Kawasaki 1986: streams in a channel, in its units (what comes in; mean free paths)."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from analysis.source.panels import BLACK, finish, panels, shade
from analysis.source.runs import Lacking

MATERIALS = {"granular": "granular material", "gas": "gas", "intermediate": "intermediate material"}
CUTS = (0.6, 1.4, 3.0, 6.2, 11.0, 15.0)   # of the profiles across, along the channel
LEADING_EDGE = (0.2, 0.6, 1.0, 2.2, 3.4)


@dataclass(frozen=True)
class Flow:
    """Means over replicas and the later half of the samples, over the values that come in: [along, across]."""

    x: np.ndarray
    y: np.ndarray
    density: np.ndarray
    velocity: np.ndarray     # along the channel, over the most probable thermal speed
    across: np.ndarray       # the same of the other component
    temperature: np.ndarray  # mean of translation and rotation
    pressure: np.ndarray     # n T of the translation

    def folded(self):
        """Mean of both halves, from the wall to the middle."""
        half = len(self.y) // 2
        fold = {name: (value[:, :half] + sign * value[:, ::-1][:, :half]) / 2
                for name, value, sign in (("density", self.density, 1), ("velocity", self.velocity, 1),
                                          ("across", self.across, -1), ("temperature", self.temperature, 1),
                                          ("pressure", self.pressure, 1))}
        return Flow(self.x, self.y[:half], **fold)


def load_flow(run):
    """Throws Lacking for a record without fields and spin temperatures."""
    inflow, size = run.scene["inflow"][0], run.scene["domain"]["size"]
    fields, spins = run.series("fields"), run.series("spin-temperature")
    late = [item.time >= item.time[-1] / 2 for item in fields]
    mean = np.mean([item.value[keep].mean(axis=0) for item, keep in zip(fields, late)], axis=0)[:, :, 0]
    turning = np.mean([item.value[keep].mean(axis=0) for item, keep in zip(spins, late)], axis=0)[:, :, 0]
    x, y = ((np.arange(count) + 0.5) * edge / count for count, edge in zip(mean.shape[:2], size))
    density, translation = mean[..., 0] / inflow["number-density"], mean[..., 4] / inflow["temperature"]
    unit = np.sqrt(2 * inflow["temperature"])   # the most probable speed, mass one
    return Flow(x, y, density, mean[..., 1] / unit, mean[..., 2] / unit,
                (translation + turning / inflow["spin-temperature"]) / 2, density * translation)


def _of(case, point):
    return load_flow(case.choose(point)[0])


def _map(picture, panel, flow, value, name):
    drawn = panel.contourf(flow.x, flow.y, value.T, levels=12, cmap="viridis")
    panel.contour(flow.x, flow.y, value.T, levels=12, colors="white", linewidths=0.4)
    panel.grid(False)
    panel.set(xlabel="x / λ", ylabel="y / λ", title=name)
    picture.colorbar(drawn, ax=panel, pad=0.02)


def _cuts(panel, flow, value, places, name):
    for index, place in enumerate(places):
        column = np.abs(flow.x - place).argmin()
        panel.plot(value[column], flow.y, color=shade(index, len(places)), label=f"x = {flow.x[column]:.1f}")
    panel.set(xlabel=name, ylim=(0, None))
    panel.legend(fontsize=7.5)


NAMES = {"density": "number density n / n₀", "temperature": "temperature T / T₀", "pressure": "pressure n T / (n₀ T₀)",
         "velocity": "velocity u / c_m"}


def draw_material(number, point, quantity, case, stem):
    flow = _of(case, point).folded()
    value = getattr(flow, quantity)
    picture, [row] = panels(2, width=9.6)
    _map(picture, row[0], flow, value, "half of the channel, wall below")
    _cuts(row[1], flow, value, CUTS, NAMES[quantity])
    finish(picture, number, f"{MATERIALS[point].capitalize()}: {NAMES[quantity]}", stem)


def draw_leading_edge(case, stem):
    picture, [row] = panels(len(LEADING_EDGE), width=11.5)
    flows = {point: _of(case, point).folded() for point in ("gas", "intermediate")}
    for panel, place in zip(row, LEADING_EDGE):
        for index, (point, flow) in enumerate(flows.items()):
            column = np.abs(flow.x - place).argmin()
            panel.plot(flow.velocity[column], flow.y, ("-", "--")[index], color=BLACK, label=MATERIALS[point])
            panel.set(title=f"x = {flow.x[column]:.1f} λ", xlabel="u / c_m", xlim=(0, 2.6), ylim=(0, 4))
    row[0].set_ylabel("y / λ")
    row[0].legend(fontsize=7.5, loc="upper left")
    finish(picture, "5.5", "Velocity near the leading edge: gas and intermediate material", stem)


def draw_gravity(case, stem):
    runs = case.choose("*")
    if not runs:
        raise Lacking("no channel with gravity")
    flow = load_flow(runs[0])
    picture, rows = panels(2, 2, width=10.5)
    for panel, (quantity, name) in zip(rows.flat, NAMES.items()):
        _map(picture, panel, flow, getattr(flow, quantity), name)
    height = (flow.density * flow.y).sum(axis=1) / flow.density.sum(axis=1)
    rows[0, 0].plot(flow.x, height, color="white", linewidth=2, label="mean height")
    rows[0, 0].legend(labelcolor="white", loc="upper right")
    finish(picture, "5.6", "Gas that falls to the floor of a channel between mirrors", stem)


FIGURES = ({f"5.{index + 2}{letter}": partial(draw_material, f"5.{index + 2}({letter})", point, quantity)
            for index, point in enumerate(MATERIALS)
            for letter, quantity in zip("abcd", ("density", "temperature", "pressure", "velocity"))}
           | {"5.5": draw_leading_edge, "5.6": draw_gravity})
