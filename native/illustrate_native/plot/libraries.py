"""Libraries that only some formats need."""

from __future__ import annotations

import importlib
import sys
from types import ModuleType

from .errors import PlotError


def load(name: str, purpose: str) -> ModuleType:
    """A Python package. Raises PlotError that says how to get it where it is missing."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise PlotError(
            f"{purpose} needs the Python package {name}, which is not there: install it with "
            f'"{sys.executable}" -m pip install {name}'
        ) from error
