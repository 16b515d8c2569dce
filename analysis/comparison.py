"""Pictures that set the methods of one case beside each other, drawn from the kept records of a report."""

from dataclasses import dataclass
from functools import partial

from analysis import clustering_figures, heap_figures, pipe_figures
from analysis.errors import InputError
from analysis.record import REMEDY
from analysis.words import slug


@dataclass(frozen=True)
class Comparison:
    """One picture of a case page."""

    name: str       # inside figures/, without ending
    caption: str
    point: str
    wide: bool


PICTURES = {   # case -> its pictures
    "clustering": clustering_figures.PICTURES,
    "heap": heap_figures.PICTURES,
    "pipe-flow": pipe_figures.PICTURES,
}


def _draw(picture, paths, stem):
    picture.draw({variant: picture.load(path) for variant, path in paths.items()}, stem)


def can_show(path, needs):
    """Whether a record holds all of these places. Throws InputError."""
    import h5py
    try:
        with h5py.File(path, "r") as file:
            return all(name in file for name in needs)
    except OSError as error:
        raise InputError(path, "", f"not a Sandglass record: {error}", REMEDY) from error


def plan(case, folder, figures):
    """(comparisons, jobs that draw them): one per picture and point that has what the picture needs.

    A point needs two kept records; a picture shows those that hold its data, if they are as many as it wants.
    """
    comparisons, jobs = [], []
    for point in dict.fromkeys(run.point for run in case.runs):
        kept = {run.variant: folder / run.record for run in case.runs
                if run.point == point and run.record and (folder / run.record).is_file()}
        for picture in PICTURES.get(case.name, []) if len(kept) > 1 else []:
            paths = {variant: path for variant, path in kept.items() if can_show(path, picture.needs)}
            if len(paths) >= picture.runs:
                name = slug("compare", case.name, point, picture.name)
                comparisons.append(Comparison(name, picture.caption, point, picture.wide))
                jobs.append(partial(_draw, picture, paths, figures / name))
    return comparisons, jobs
