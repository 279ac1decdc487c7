"""Which lines of the add-on the tests run, for tools/coverage.sh.

Other processes that a test starts are not measured.
"""

import os
import pathlib
import sys
from typing import Any

import pytest

OMITTED = ["*/illustrate_native/*", "*/presets/*"]


def plugins() -> list[Any]:
    """A plugin that writes to the file $ILLUSTRATE_COVERAGE names; none where that is not set."""
    data = os.environ.get("ILLUSTRATE_COVERAGE")
    return [_Measure(data)] if data else []


class _Measure:
    """Begins when it is made, ends with the last test.

    Nothing may have imported the add-on before: lines that ran before would count as never run.
    """

    def __init__(self, data: str) -> None:
        sys.path.append(os.environ["ILLUSTRATE_COVERAGE_SITE"])
        import coverage  # type: ignore[import-not-found]

        addon = next(path for path in sys.path if pathlib.Path(path, "illustrate").is_dir())
        folder = str(pathlib.Path(addon, "illustrate"))
        self._coverage = coverage.Coverage(
            data_file=data, branch=True, source=[folder], omit=OMITTED
        )
        self._coverage.start()

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self) -> None:
        """Before conftest.py ends the process."""
        self._coverage.stop()
        self._coverage.save()
