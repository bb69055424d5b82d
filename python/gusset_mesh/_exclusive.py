"""Locks objects that calls change."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Exclusive:
    """An object that one call at a time uses. Other threads wait; a callback of the call gets a RuntimeError."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._is_used = False

    @contextmanager
    def _alone(self) -> Iterator[None]:
        with self._lock:
            if self._is_used:
                raise RuntimeError(f"the {type(self).__name__} is in use by the call that this callback belongs to")
            self._is_used = True
            try:
                yield
            finally:
                self._is_used = False
