"""Figures of a source, drawn from the records of a report and set beside its words."""
