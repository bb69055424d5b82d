"""Writes files so that each is complete or unchanged."""

from __future__ import annotations

import errno
import os
import secrets
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from .documents import Array


def replace_files(files: Mapping[Path, Array]) -> None:
    """Gives files new bytes, in this order. No file changes before all new bytes are on the disk."""
    pending: list[tuple[str, str]] = []
    try:
        for path, data in files.items():
            # A link is followed, so that the file that it leads to is replaced.
            target = os.path.realpath(path)
            try:
                pending.append((_pending(target, data), target))
            except OSError as failure:
                # Says the name of the file, not the name that it has until it is complete.
                raise type(failure)(failure.errno, failure.strerror or str(failure), os.fspath(path)) from None
        while pending:
            os.replace(*pending[0])
            pending.pop(0)
    finally:
        for temporary, _ in pending:
            with suppress(OSError):
                os.unlink(temporary)


def _pending(target: str, data: Array) -> str:
    """Writes a file of another name in the folder of the target, with the target's permissions. Returns its name."""
    old = os.stat(target) if os.path.exists(target) else None
    if old is not None and stat.S_ISDIR(old.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    if old is not None and not stat.S_ISREG(old.st_mode):
        raise OSError(errno.EINVAL, "Not a regular file")
    name = os.path.join(os.path.dirname(target), f".gusset-{secrets.token_hex(8)}")
    handle = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)
    try:
        with open(handle, "wb") as file:
            file.write(data.data)
            if old is not None:
                os.fchmod(handle, stat.S_IMODE(old.st_mode))
            file.flush()
            os.fsync(handle)
    except BaseException:
        with suppress(OSError):
            os.unlink(name)
        raise
    return name
