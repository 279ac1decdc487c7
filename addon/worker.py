"""Long work in a thread of its own, so that Blender stays awake; the work knows no Blender."""

import threading
from collections.abc import Callable
from typing import Any

Progress = Callable[[float, str], bool]

_running: set["Worker"] = set()


class Worker:
    """Runs work(progress) in a thread and keeps how far it is, what it made or what went wrong."""

    def __init__(self, work: Callable[[Progress], Any]) -> None:
        self.fraction, self.stage = 0.0, ""
        self.result: Any = None
        self.error: BaseException | None = None
        self._work = work
        self._is_cancelled = False
        self._thread = threading.Thread(target=self._run, name="illustrate", daemon=True)
        _running.add(self)
        self._thread.start()

    @property
    def is_done(self) -> bool:
        """True when there is a result or an error."""
        return not self._thread.is_alive()

    def cancel(self) -> None:
        """Asks the work to stop, and does not wait: its result is not wanted any more."""
        self._is_cancelled = True

    def join(self, timeout_s: float) -> None:
        """Waits for the end."""
        self._thread.join(timeout_s)

    def _run(self) -> None:
        try:
            self.result = self._work(self._report)
        except BaseException as error:
            self.error = error
        finally:
            _running.discard(self)

    def _report(self, fraction: float, stage: str) -> bool:
        self.fraction, self.stage = fraction, stage
        return not self._is_cancelled


def stop_all(timeout_s: float = 10.0) -> None:
    """Cancels all work and waits for it: nothing runs on when Blender or the add-on ends."""
    workers = list(_running)
    for worker in workers:
        worker.cancel()
    for worker in workers:
        worker.join(timeout_s)
