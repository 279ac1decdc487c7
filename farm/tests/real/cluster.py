"""Slurm on this machine, as root and without systemd: a controller and two nodes on loopback.

It is meant for what tools/own_machine.sh makes, which ends whatever is left. Each node has a
process namespace of its own, so that it can die as machines do: with all that it runs.
"""

from __future__ import annotations

import os
import re
import secrets
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

SCRIPT = Path(__file__).parents[2] / "slurm" / "illustrate.sh"
NODES = ("w1", "w2")
UP = ("IDLE", "MIXED", "ALLOCATED")
DOWN_AFTER_S = 6  # without a word from a node
ENDED = {"BOOT_FAIL", "CANCELLED", "COMPLETED", "DEADLINE", "FAILED", "NODE_FAIL", "TIMEOUT"}

_CONFIGURATION = """\
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MailProg=/bin/true
MpiDefault=none
ReturnToService=2
SlurmdTimeout={down_after}
KillWait=2
MessageTimeout=5
SchedulerParameters=bf_interval=1,sched_interval=2,batch_sched_delay=0
NodeName=w[1-2] NodeAddr=127.0.0.1 Port=[17001-17002] CPUs=1 State=UNKNOWN
PartitionName=main Nodes=w[1-2] Default=YES MaxTime=INFINITE State=UP
"""


class Cluster:
    """A controller and the nodes w1 and w2, each of one core where there are two."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._processes: dict[str, subprocess.Popen[bytes]] = {}
        self.variables = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def start(self) -> None:
        """Starts all and waits until both nodes take jobs."""
        for name in ("munge", "state", *(f"spool-{node}" for node in NODES)):
            (self._folder / name).mkdir(mode=0o755, parents=True)
        text = _CONFIGURATION.format(
            folder=self._folder, host=socket.gethostname(), down_after=DOWN_AFTER_S
        )
        (self._folder / "slurm.conf").write_text(text)
        self._start_munge()
        self._start("slurmctld", ["slurmctld", "-D"])
        for node in NODES:
            self.start_node(node)

    def start_node(self, node: str) -> None:
        """Starts a node, on a core of its own, and waits until it takes jobs."""
        core = NODES.index(node) % len(os.sched_getaffinity(0))
        inside = f"taskset --cpu-list {core} slurmd -D -N {node}; exec sleep infinity"
        apart = ["unshare", "--mount", "--propagation", "slave", "--pid", "--fork"]
        apart += ["--kill-child=KILL", "--mount-proc"]
        self._start(node, [*apart, "sh", "-c", inside])
        until(lambda: self.node_state(node) in UP, 60)

    def kill_node(self, node: str) -> None:
        """The machine is gone, and all that ran on it."""
        process = self._processes.pop(node)
        process.kill()
        process.wait()

    def kill_daemon(self, node: str) -> None:
        """Slurm is gone from a node; what it started goes on."""
        [shell] = _children(self._processes[node].pid)
        [daemon] = [pid for pid in _children(shell) if _name(pid) == "slurmd"]
        os.kill(daemon, signal.SIGKILL)

    def processes(self, node: str, name: str) -> list[int]:
        """Processes of that name on a node."""
        return [pid for pid in _below(self._processes[node].pid) if _name(pid) == name]

    def mend_node(self, node: str) -> None:
        """Starts a node that is gone, wholly or in part, and waits for one that is late."""
        process = self._processes.get(node)
        if process is not None and not self.processes(node, "slurmd"):
            self.kill_node(node)
        if node not in self._processes:
            self.start_node(node)
        until(lambda: self.node_state(node) in UP, 60)

    def clear(self) -> None:
        """Cancels all jobs."""
        self.call("scancel", "--user=root")
        until(lambda: not self.call("squeue", "--noheader"), 60)

    def submit(self, *arguments: object, **variables: str) -> tuple[str, str]:
        """The numbers of the jobs that illustrate.sh submits: the array, and what follows it."""
        words = [str(SCRIPT), *map(str, arguments)]
        told = dict(line.split() for line in self.call(*words, **variables).splitlines())
        return told["draw"], told["finish"]

    def requeue_at_once(self) -> None:
        """Lets tasks of a lost node begin again now; Slurm lets two minutes pass."""
        for job in self.call("squeue", "--array", "--noheader", "--format=%i %r").splitlines():
            number, reason = job.split(maxsplit=1)
            if reason == "BeginTime":
                self.call("scontrol", "update", f"JobId={number}", "StartTime=now")

    def stop(self) -> None:
        """Ends all that was started."""
        for process in self._processes.values():
            process.kill()
        for process in self._processes.values():
            process.wait()
        self._processes.clear()

    def call(self, *words: str, **variables: str) -> str:
        """What a command of Slurm prints; variables: of its environment, besides its own."""
        own = {**self.variables, **variables}
        ran = subprocess.run(words, env=own, capture_output=True, text=True, check=False)
        assert ran.returncode == 0, f"{words}: {ran.stdout}{ran.stderr}"
        return ran.stdout

    def node_state(self, node: str) -> str:
        """Such as IDLE, ALLOCATED, DOWN."""
        told = re.search(r"State=([A-Z]+)(\*?)", self.call("scontrol", "-o", "show", "node", node))
        assert told is not None
        return "DOWN" if told[2] else told[1]

    def states(self, job: str) -> list[str]:
        """Of a job, or of all tasks of an array that have begun."""
        return re.findall(r" JobState=([A-Z_]+) ", self.call("scontrol", "-o", "show", "job", job))

    def nodes_of(self, job: str) -> set[str]:
        """The nodes that the tasks of an array ran on last."""
        return set(re.findall(r" NodeList=(\S+) ", self.call("scontrol", "-o", "show", "job", job)))

    def has_ended(self, job: str) -> bool:
        """A job, or all tasks of an array, however they ended."""
        return set(self.states(job)) <= ENDED

    def wait(self, job: str, seconds: float = 300) -> list[str]:
        """The states of a job, or of the tasks of an array, once all have ended."""
        until(lambda: self.has_ended(job), seconds)
        return self.states(job)

    def logs(self) -> str:
        """What the daemons said."""
        return "\n".join(
            f"== {path.name}\n{path.read_text(errors='replace')[-4000:]}"
            for path in sorted(self._folder.glob("*.log"))
        )

    def _start_munge(self) -> None:
        folder = self._folder / "munge"
        (folder / "key").write_bytes(secrets.token_bytes(128))
        (folder / "key").chmod(0o400)
        for path in (folder, folder / "key"):
            shutil.chown(path, "munge", "munge")
        options = {"key-file": "key", "socket": "socket", "pid-file": "pid", "seed-file": "seed",
                   "log-file": "log"}  # fmt: skip
        named = [f"--{option}={folder / name}" for option, name in options.items()]
        user = ["setpriv", "--reuid", "munge", "--regid", "munge", "--clear-groups"]
        self._start("munge", [*user, "munged", "--foreground", *named])
        until(lambda: (folder / "socket").exists(), 30)

    def _start(self, name: str, words: list[str]) -> None:
        with (self._folder / f"{name}.out.log").open("ab") as log:
            self._processes[name] = subprocess.Popen(
                words, env=self.variables, stdout=log, stderr=log, stdin=subprocess.DEVNULL
            )


def until(holds: Callable[[], bool], seconds: float) -> None:
    """Waits until something holds."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, f"not within {seconds} s"
        time.sleep(0.2)


def _read(pid: int, path: str) -> str:
    """A file about a process; empty where it is gone."""
    try:
        return Path(f"/proc/{pid}/{path}").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return ""


def _children(pid: int) -> list[int]:
    return [int(word) for word in _read(pid, f"task/{pid}/children").split()]


def _below(pid: int) -> list[int]:
    """All that a process has started, and what that has started."""
    return [found for child in _children(pid) for found in (child, *_below(child))]


def _name(pid: int) -> str:
    return _read(pid, "comm").strip()
