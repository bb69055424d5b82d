"""Decodes streams that arrive in pieces."""

from __future__ import annotations

from typing import Any, Optional

from ._arrays import pointer
from ._call import Progress, call
from ._exchange import index
from ._exclusive import Exclusive
from ._handles import Handle, create
from ._library import ffi, lib
from .encoding import bytes_of
from .net import Net

__all__ = ["StreamDecoder"]


class StreamDecoder(Exclusive, Handle):
    """A decoder of a stream that arrives in pieces. :meth:`Net.encode` makes streams.

    Args:
        node_limit: largest number of nodes; 0: no limit. Memory is allocated before the stream is complete.

    >>> import gusset_mesh as gm
    >>> data, decoder = gm.Net.primitive(shape="sphere", radius=1).encode(rows_per_block=8), StreamDecoder()
    >>> rows = [decoder.push(data[k:k + 500]) for k in range(0, len(data), 500)]
    >>> rows[-1], decoder.finish().shape
    (33, (33, 65))
    """

    def __init__(self, node_limit: int = 0):
        Exclusive.__init__(self)
        Handle.__init__(self, create("stream_decoder", index(node_limit, "node_limit", 64)))

    def push(self, data: Any, *, threads: int = 0) -> int:
        """Decodes the next bytes. Returns the number of complete rows so far."""
        array, done = bytes_of(data), ffi.new("size_t *")
        with self._alone():
            call(lib.gusset_stream_decoder_push, self._handle, pointer(array), array.size, done, threads=threads)
        return int(done[0])

    def preview(self, *, threads: int = 0, progress: Optional[Progress] = None) -> Net:
        """Makes a net of the complete rows, without gluing and bridges."""
        with self._alone():
            return Net._of(create("net", self._handle, name="stream_decoder_preview", threads=threads, progress=progress))

    def finish(self, *, threads: int = 0, progress: Optional[Progress] = None) -> Net:
        """Makes the net of a complete stream, and resets the decoder."""
        with self._alone():
            return Net._of(create("net", self._handle, name="stream_decoder_finish", threads=threads, progress=progress))
