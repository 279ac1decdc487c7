"""Drawings on paper: settings of pages and pens, and Export Drawing (docs/plot.md)."""
