"""The add-on registered in an empty file for every test."""

import os
import sys
from collections.abc import Iterator
from typing import Any

import bpy
import illustrate
import installed
import pytest

import tools

_status = [0]


@pytest.fixture(scope="session", autouse=True)
def _addon() -> None:
    if not installed.is_enabled(illustrate):
        illustrate.register()


@pytest.fixture(autouse=True)
def scene() -> Iterator[Any]:
    """The only scene of an empty file; its surfaces are coarse, which is enough of any cube."""
    tools.new_file()
    bpy.context.scene.illustrate.triangle_budget = 15_000
    yield bpy.context.scene


def pytest_sessionfinish(exitstatus: int) -> None:
    _status[0] = int(exitstatus)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure() -> None:
    """Ends the process: what is still registered at its own end would spoil the exit code."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(_status[0])
