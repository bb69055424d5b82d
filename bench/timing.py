"""Times by turns, and work in processes of its own where it may fail badly."""

import gc
import json
import os
import resource
import signal
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, field
from typing import Any, Callable


@dataclass
class Contender:
    """Someone who does the work of a case. `work` takes the result of `prepare`; only `work` is timed."""

    name: str
    work: Callable
    prepare: Callable = lambda: None
    mesh: Callable = None  # from the last result: points, triangles, first new triangle


@dataclass
class Outcome:
    times: list = field(default_factory=list)
    result: Any = None
    failed: str = None

    @property
    def median(self):
        return None if self.failed else statistics.median(self.times)


def describe(error):
    return f"{type(error).__name__}: {error}".strip(": ").splitlines()[0]


def once(contender, outcome):
    """One run. Results are freed outside of the timed part."""
    outcome.result = None
    try:
        state = contender.prepare()
        gc.collect()
        start = time.perf_counter()
        outcome.result = contender.work(state)
        outcome.times.append(1000 * (time.perf_counter() - start))
    except Exception as error:  # Whatever a peer throws is its result.
        outcome.failed, outcome.result = describe(error), None


def by_turns(contenders, runs=7, patience=10.0):
    """All contenders by turns, `runs` times, or as often as takes `patience` seconds, but at least once."""
    outcomes = {contender.name: Outcome() for contender in contenders}
    gc.disable()
    start = time.perf_counter()
    for run in range(1, runs + 1):
        for contender in contenders:
            outcome = outcomes[contender.name]
            if not outcome.failed:
                once(contender, outcome)
        spent = time.perf_counter() - start
        if spent * (run + 1) / run > patience and run % 2:
            break
    gc.enable()
    return outcomes


def bound(bytes_):
    """Bounds the memory of this process, so that the machine survives it."""
    resource.setrlimit(resource.RLIMIT_AS, (bytes_, bytes_))


def apart(case, contender, seconds):
    """A contender in a process of its own with bounds on time and memory. It prints its Outcome."""
    command = [sys.executable, sys.argv[0], *sys.argv[1:], "--apart", f"{case}/{contender}"]
    outcome = Outcome()
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    try:
        printed, complaints = child.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGKILL)  # And whatever it started.
        child.communicate()
        outcome.failed = f"not done in {seconds:.0f} s"
        return outcome, {}
    try:
        said = json.loads(printed.splitlines()[-1])
    except (IndexError, ValueError):
        ending = complaints.strip().splitlines() or [f"exit status {child.returncode}"]
        outcome.failed = f"died: {ending[-1]}"
        return outcome, {}
    outcome.times, outcome.failed = said["times"], said["failed"]
    return outcome, said


class PeakMemory:
    """How far the resident memory of this process rises in a block, in MiB."""

    def __enter__(self):
        with open("/proc/self/clear_refs", "w") as clear:
            clear.write("5")
        self.before = self._status("VmRSS")
        return self

    def __exit__(self, *_):
        self.mebibytes = (self._status("VmHWM") - self.before) / 1024

    @staticmethod
    def _status(name):
        with open("/proc/self/status") as lines:
            return next(int(line.split()[1]) for line in lines if line.startswith(name + ":"))
