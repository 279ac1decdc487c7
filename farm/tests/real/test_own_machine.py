"""What tools/own_machine.sh starts and mounts is gone at its end, however that comes."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest
from cluster import until
from shots import ROOT

MARK = "86399.5"  # seconds that nothing else sleeps
# A process that another one left, and a mount.
LEFT = f"(setsid sleep {MARK} >/dev/null &); mkdir -p $0 && mount -t tmpfs x $0 && echo ready; "


def sleepers() -> int:
    """Processes that sleep so long."""
    ran = subprocess.run(["pgrep", "--full", f"^sleep {MARK}"], capture_output=True, check=False)
    return len(ran.stdout.splitlines())


def start(folder: Path, then: str) -> subprocess.Popen[bytes]:
    as_in_a_terminal = ["env", "--default-signal=INT"]  # which is ignored in the background
    script = str(ROOT / "tools" / "own_machine.sh")
    words = [*as_in_a_terminal, script, "bash", "-c", LEFT + then, str(folder)]
    started = subprocess.Popen(words, stdout=subprocess.PIPE)
    assert started.stdout is not None and started.stdout.readline() == b"ready\n"
    return started


@pytest.mark.parametrize("code", [0, 7])
def test_the_exit_code_is_that_of_the_command(tmp_path: Path, code: int) -> None:
    with start(tmp_path, f"exit {code}") as script:
        assert script.wait(30) == code
    until(lambda: not sleepers(), 5)
    assert str(tmp_path) not in Path("/proc/mounts").read_text()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_a_signal_ends_all(tmp_path: Path, number: signal.Signals) -> None:
    with start(tmp_path, f"sleep {MARK}; exit 0") as script:
        until(lambda: sleepers() == 2, 5)
        script.send_signal(number)
        assert script.wait(5) in (128 + number, -number)
    until(lambda: not sleepers(), 5)
    assert str(tmp_path) not in Path("/proc/mounts").read_text()
