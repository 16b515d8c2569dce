"""Verdicts for other programs: CSV and JUnit XML."""

import csv
import re
from collections import Counter
from dataclasses import fields
from xml.etree import ElementTree

from analysis.model import Budget, Verdict
from analysis.words import GOOD

NOT_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def write_csv(report, path):
    """One line per verdict with every key of verdicts.json; an unknown number is an empty field."""
    plain = [f.name for f in fields(Verdict) if f.name != "budget_parts"]
    parts = [f.name for f in fields(Budget)]
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(plain + [f"budget_{name}" for name in parts])
        for item in report.verdicts:
            writer.writerow([getattr(item, name) for name in plain]
                            + [getattr(item.budget_parts, name) for name in parts])


def _xml(text):
    return NOT_XML.sub("?", text)


def _test(suite, item, checks):
    seconds = (item.cpu_seconds or 0) / checks[item.run]
    test = ElementTree.SubElement(suite, "testcase", classname=_xml(f"{item.case}.{item.variant}"),
                                  name=_xml(f"{item.point} {item.check}"), time=f"{seconds:.6f}")
    if item.verdict not in GOOD:
        ElementTree.SubElement(test, "failure", type=item.verdict, message=_xml(item.reason))


def write_junit(report, path):
    """A suite per case. Known limits that were confirmed count as passed; whatever blocks counts as failed.

    The CPU time of a run is shared evenly by its checks, so that the sum over tests is the time spent.
    """
    checks = Counter(item.run for item in report.verdicts)
    root = ElementTree.Element("testsuites", name="sandglass")
    for case in dict.fromkeys(item.case for item in report.verdicts):
        items = [item for item in report.verdicts if item.case == case]
        failures = sum(item.verdict not in GOOD for item in items)
        suite = ElementTree.SubElement(root, "testsuite", name=_xml(case), tests=str(len(items)),
                                       failures=str(failures))
        for item in items:
            _test(suite, item, checks)
    ElementTree.indent(root)
    ElementTree.ElementTree(root).write(path, encoding="utf-8", xml_declaration=True)
