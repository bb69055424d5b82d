"""Encodes nets as bytes, and decodes them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._arrays import pointer
from ._call import Progress
from ._exchange import answer, index, sized
from ._handles import create
from ._keywords import options as structs
from ._library import lib
from ._net_handle import NetHandle
from ._options import StreamOptions, Unpack
from ._records import lent
from ._reports import StreamReport
from .errors import error

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["stream_inspect"]


def bytes_of(data: Any) -> NDArray[np.uint8]:
    """Returns bytes as an array, without a copy."""
    array = data if isinstance(data, np.ndarray) else np.frombuffer(data, np.uint8)
    if array.dtype != np.uint8 or array.ndim != 1 or not array.flags.c_contiguous:
        raise ValueError(f"a stream is bytes or a packed array of bytes, not a {type(data).__name__}")
    return array


def stream_bytes(stream: Any) -> NDArray[np.uint8]:
    """Returns the bytes of a stream, which the array keeps alive."""
    view = sized("gusset_stream_view")
    status = lib.gusset_stream_get_view(stream, view)
    if status != 0:
        raise error(status, "")
    return lent(view.data, (view.size,), np.uint8, stream)


def stream_inspect(data: Any) -> StreamReport:
    """Reads the header of a stream from its first 128 bytes or more."""
    array = bytes_of(data)
    return answer(StreamReport, lib.gusset_stream_inspect, pointer(array), array.size)


class NetEncoding(NetHandle):
    """The part of :class:`Net` that encodes and decodes nets."""

    def encode(self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[StreamOptions]) -> NDArray[np.uint8]:
        """Encodes coordinates, gluing and bridges as bytes. ``mode`` chooses quantised, lossless or raw storage.

        >>> import numpy as np, gusset_mesh as gm
        >>> net = gm.Net.primitive(shape="sphere", radius=1)
        >>> bool(np.array_equal(gm.Net.decode(net.encode(mode="lossless")).nodes, net.nodes))
        True
        """
        given = structs("stream_options", options)
        return stream_bytes(create("stream", self._handle, given, name="net_encode", threads=threads, progress=progress))

    @classmethod
    def decode(cls, data: Any, node_limit: int = 0, *, threads: int = 0, progress: Optional[Progress] = None) -> Self:
        """Decodes a whole stream.

        Args:
            data: bytes, an array of bytes, or another buffer.
            node_limit: largest number of nodes, checked before allocation; 0: no limit.

        Raises:
            InputError: the stream is damaged; ``index`` is the byte.
        """
        array = bytes_of(data)
        limit = index(node_limit, "node_limit", 64)
        return cls._of(create("net", pointer(array), array.size, limit, name="net_decode", threads=threads, progress=progress))
