"""How the library is called: with a context of the thread's own, which tells of progress and hears of cancelling."""

from __future__ import annotations

import atexit
import threading
import time
from collections.abc import Callable
from typing import Any, Optional

from ._library import ffi, lib
from .errors import reported

#: Receives the completed part, 0 to 1, and the current stage. An exception that it raises cancels the call, which raises it again.
Progress = Callable[[float, str], object]


class _Context:
    """A context, and what its callbacks need."""

    def __init__(self) -> None:
        made = ffi.new("struct gusset_context **")
        status = lib.gusset_context_create(made)
        if status != 0:
            raise MemoryError("no memory for a context")
        self.handle = ffi.gc(made[0], lib.gusset_context_destroy)
        self.progress: Optional[Progress] = None
        self.raised: Optional[BaseException] = None
        self.is_cancelled = False
        self.threads = 0
        self._self = ffi.new_handle(self)
        self._callback = ffi.callback("int(void *, double, const char *)", _told, error=1, onerror=_raised)
        self.is_told = False

    def cancel(self) -> None:
        self.is_cancelled = True
        lib.gusset_context_cancel(self.handle)

    def use(self, threads: int, progress: Optional[Progress], is_told: bool) -> None:
        self.progress, self.raised = progress, None
        if is_told != self.is_told:
            callback, user = (self._callback, self._self) if is_told else (ffi.NULL, ffi.NULL)
            status = lib.gusset_context_set_progress(self.handle, callback, user)
            assert status == 0
            self.is_told = is_told
        if threads != self.threads:
            status = lib.gusset_context_set_threads(self.handle, threads)
            if status != 0:
                raise reported(status, self.handle)
            self.threads = threads


def _told(user: Any, fraction: float, stage: Any) -> int:
    """Python looks for signals here: Ctrl-C is raised in this function, and cancels the call."""
    progress = ffi.from_handle(user).progress
    if progress is not None:
        progress(fraction, ffi.string(stage).decode("utf-8"))
    return 0


def _raised(kind: Any, exception: BaseException, traceback: Any) -> int:
    """An exception of _told is raised again by the running call of the thread."""
    _own.busy[-1].raised = exception
    return 1


class _Own(threading.local):
    """Each thread has its own contexts: one, and another for each call from within a callback."""

    def __init__(self) -> None:
        self.free: list[_Context] = []
        self.busy: list[_Context] = []


_own = _Own()

#: Running calls of all threads: each has cancel().
under_way: set[Any] = set()


@atexit.register
def _end() -> None:
    """When the interpreter ends, calls of threads that it does not wait for are cancelled: they must not call back any more."""
    until = time.monotonic() + 10
    while under_way and time.monotonic() < until:
        for one in list(under_way):
            one.cancel()
        time.sleep(0.005)


def call(function: Any, *arguments: Any, threads: int = 0, progress: Optional[Progress] = None, is_short: bool = False) -> None:
    """Calls a function whose first parameter is a context; what it reports is raised.

    Args:
        is_short: it takes a few milliseconds at most: Python need not look for signals meanwhile, which would take longer than the call.
    """
    own = _own
    used = own.free.pop() if own.free else _Context()
    own.busy.append(used)
    under_way.add(used)
    try:
        used.use(threads, progress, progress is not None or not is_short)
        status = function(used.handle, *arguments)
        if status != 0:
            raise used.raised if used.raised is not None else reported(status, used.handle)
        if used.raised is not None:
            # It came too late to cancel anything; it counts all the same.
            raise used.raised
    finally:
        under_way.discard(used)
        own.busy.pop()
        used.progress = used.raised = None
        if used.is_cancelled:
            lib.gusset_context_reset(used.handle)
            used.is_cancelled = False
        own.free.append(used)
