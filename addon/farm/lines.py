"""What the headless command prints, for people and for the programs that run it."""

import sys

from ..running.tasks import STAGES

PROGRESS = ("plain", "openjd", "none")
OPENJD_STEP = 0.1  # percent between lines


def say(line: str) -> None:
    """A line on stdout, at once."""
    print(line, flush=True)


def complain(line: str) -> None:
    """A line on stderr, at once."""
    print(f"illustrate: {line}", file=sys.stderr, flush=True)


def time_text(seconds: float) -> str:
    """As Blender's renders print it: minutes, seconds and hundredths, and hours where there are."""
    minutes, rest = divmod(round(100 * seconds), 6000)
    hours, minutes = divmod(minutes, 60)
    clock = f"{minutes:02}:{rest // 100:02}.{rest % 100:02}"
    return f"{hours}:{clock}" if hours else clock


class Progress:
    """How far a command is, printed in one of the kinds of PROGRESS."""

    def __init__(self, kind: str, frames: int) -> None:
        self._kind, self._frames = kind, max(frames, 1)
        self._done, self._name, self._stage, self._percent = 0, "", "", -OPENJD_STEP

    def begin(self, name: str) -> None:
        """From now on it is about the file or frame of this name."""
        self._name, self._stage = name, ""

    def end(self) -> None:
        """A frame is done with."""
        self._done += 1
        self._overall(0.0)

    def fail(self, line: str) -> None:
        """The command ends with an error."""
        complain(line)
        if self._kind == "openjd":
            say(f"openjd_fail: {line}")

    def __call__(self, fraction: float, stage: str) -> bool:
        """Progress of the drawing of one frame; never stops it."""
        if stage and stage != self._stage:
            self._stage = stage
            self._new_stage(fraction)
        self._overall(fraction)
        return True

    def _new_stage(self, fraction: float) -> None:
        if self._kind == "plain":
            say(f"{self._name}: {100 * fraction:3.0f} % {self._stage}")
        elif self._kind == "openjd":
            words = STAGES.get(self._stage, self._stage.capitalize())
            say(f"openjd_status: {self._name}: {words}")

    def _overall(self, fraction: float) -> None:
        percent = 100 * min((self._done + fraction) / self._frames, 1.0)
        # The end is told even if it is less than a step away.
        if self._kind == "openjd" and percent >= min(self._percent + OPENJD_STEP, 100.0):
            self._percent = percent
            say(f"openjd_progress: {percent:.1f}")
