"""What the headless command does to the machine: the files that it writes, the memory it takes."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from shots import ROOT, Shot, command, contents, make_shot, run

Shots = Callable[[str], Shot]

# Runs words in a root whose changes go to FOLDER/changed. /run, which holds the shots, is as
# outside, and the checkout cannot be written.
_RECORDED = """
set -e
folder=$1 checkout=$2
shift 2
mkdir "$folder/changed" "$folder/work" "$folder/root"
root=$folder/root
mount -t overlay overlay -o "lowerdir=/,upperdir=$folder/changed,workdir=$folder/work" "$root"
for path in /run /proc /dev "$checkout"; do mount --rbind "$path" "$root$path"; done
mount -o remount,ro,bind "$root$checkout"
exec chroot "$root" "$@"
"""


def recorded(folder: Path, words: list[str]) -> list[Path]:
    """Runs words; what they changed on this machine outside of /run and of the checkout."""
    unshare = ["unshare", "--mount", "sh", "-c", _RECORDED, "sh", str(folder), str(ROOT)]
    run([*unshare, *words])
    changed = folder / "changed"
    return [path.relative_to(changed) for path in changed.rglob("*") if not path.is_dir()]


def test_changes_are_recorded(tmp_path: Path) -> None:
    assert recorded(tmp_path, ["touch", "/srv/a", "/etc/hostname"]) == [
        Path("etc/hostname"),
        Path("srv/a"),
    ]


def test_nothing_is_written_outside_of_the_folder(shot: Shots, tmp_path: Path) -> None:
    chosen, out, machine = shot("apart"), tmp_path / "out", tmp_path / "machine"
    machine.mkdir()
    beside = set(Path("/run").rglob("*"))
    options = ("--frames", "1-2", "--format", "svg,png,json,blend")
    assert recorded(machine, command(chosen.blend, "--out", out, *options)) == []
    assert sorted(contents(out)) == Shot(chosen.blend, 2).names("blend", "json", "png", "svg")
    new = set(Path("/run").rglob("*")) - beside
    assert all(path.is_relative_to(out) or path.is_relative_to(machine) for path in new)


def resident_mb(pid: int) -> float:
    """The memory of a process."""
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    raise AssertionError("the process is gone")


def test_memory_is_flat(tmp_path: Path) -> None:
    frames = 200
    chosen = make_shot(tmp_path, "following", frames)
    words = command(chosen.blend, "--out", tmp_path, "--frames", f"1-{frames}", "--progress=none")
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as worker:
        assert worker.stdout is not None
        drawn = (line for line in worker.stdout if line.startswith("Time: "))
        taken = [resident_mb(worker.pid) for _ in drawn]
    assert worker.returncode == 0 and len(taken) == frames
    print("MB after frames 1, 50, 100, 200:", *(round(taken[i - 1]) for i in (1, 50, 100, 200)))
    assert max(taken[100:]) - max(taken[20:100]) < 10
