"""Figures and pages from verdicts, evidence and records. Decides nothing: verdicts come from the judge."""

from analysis.load import load_record, load_report

__all__ = ["load_record", "load_report"]
