"""Jobs of Flamenco, compiled by Node in place of the Manager (manager.js)."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

JOB_TYPE = Path(__file__).parents[1] / "flamenco" / "illustrate.js"
NODE = shutil.which("node")


def compile_job(
    folder: Path, settings: dict[str, Any], script: Path = JOB_TYPE
) -> subprocess.CompletedProcess[str]:
    """Runs manager.js on a job with these settings; `folder` is to work in."""
    job = folder / "job.json"
    job.write_text(json.dumps(settings))
    words = [str(NODE), str(Path(__file__).with_name("manager.js")), str(script), str(job)]
    return subprocess.run(words, capture_output=True, text=True, check=False)


def tasks_of(folder: Path, settings: dict[str, Any]) -> list[dict[str, Any]]:
    """The tasks of a job."""
    ran = compile_job(folder, settings)
    assert ran.returncode == 0, ran.stderr
    tasks: list[dict[str, Any]] = json.loads(ran.stdout)
    return tasks
