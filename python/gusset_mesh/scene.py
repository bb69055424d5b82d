"""Scenes: nets in nested groups."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer
from ._call import Progress, call
from ._exchange import handle_of, index, listed, sized
from ._exclusive import Exclusive
from ._handles import Handle, create
from ._keywords import options as structs
from ._library import ffi, lib, number_of
from ._options import ConcatenateOptions, StreamOptions, Unpack
from ._reports import SceneEntryReport, SceneInstanceArray, SceneReport
from .choices import Direction
from .encoding import bytes_of, stream_bytes
from .fields import affine_rows
from .net import Net

__all__ = ["Scene"]


class Scene(Exclusive, Handle):
    """Nets in nested groups. An entry may be in several groups; indices of entries are never reused.

    >>> import gusset_mesh as gm
    >>> scene, wheel = Scene(), gm.Net.primitive(shape="torus", radius=2, minor_radius=0.5)
    >>> axle = scene.add_group()
    >>> for side in (-3, 3):
    ...     one = scene.add(wheel)
    ...     scene.set_entry(one, transform=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, side]])
    ...     scene.add_child(axle, one)
    >>> scene.report.net_instances, scene.flatten().shape
    (2, (66, 65))
    """

    def __init__(self) -> None:
        self._start(create("scene"))

    def _start(self, handle: Any) -> None:
        Exclusive.__init__(self)
        Handle.__init__(self, handle)

    @classmethod
    def unflatten(cls, net: Net, direction: Direction = "down", *, threads: int = 0, progress: Optional[Progress] = None) -> Scene:
        """Splits a net at the last-made bridges of a direction. The parts form one group, entry 0."""
        made = cls.__new__(cls)
        made._start(create("scene", handle_of("net", net), number_of("gusset_direction", "direction", direction), name="scene_unflatten",
                           threads=threads, progress=progress))
        return made

    @classmethod
    def decode(cls, data: Any, node_limit: int = 0, *, threads: int = 0, progress: Optional[Progress] = None) -> Scene:
        """Decodes the stream of a scene. Entries keep their indices, and shared nets stay shared.

        Args:
            data: bytes, an array of bytes, or another buffer.
            node_limit: largest number of nodes of all nets together; 0: no limit.

        Raises:
            InputError: the stream is damaged; ``index`` is the byte.
        """
        array, made = bytes_of(data), cls.__new__(cls)
        limit = index(node_limit, "node_limit", 64)
        made._start(create("scene", pointer(array), array.size, limit, name="scene_decode", threads=threads, progress=progress))
        return made

    def encode(self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[StreamOptions]) -> NDArray[np.uint8]:
        """Encodes entries, groups, maps, visibility and nets as bytes. A net that entries share is stored once.

        >>> import gusset_mesh as gm
        >>> scene = Scene()
        >>> entries = [scene.add(gm.Net.primitive(shape="sphere", radius=1)), scene.add_group()]
        >>> Scene.decode(scene.encode(mode="lossless")).report.nets
        1
        """
        given = structs("stream_options", options)
        with self._alone():
            return stream_bytes(create("stream", self._handle, given, name="scene_encode", threads=threads, progress=progress))

    def add(self, net: Net) -> int:
        """Adds a net as a top-level entry, and returns the index of the entry."""
        return self._added(handle_of("net", net))

    def add_group(self) -> int:
        """Adds an empty group as a top-level entry, and returns the index of the entry."""
        return self._added(ffi.NULL)

    def _added(self, net: Any) -> int:
        entry = ffi.new("uint32_t *")
        with self._alone():
            call(lib.gusset_scene_add, self._handle, net, entry, is_short=True)
        return int(entry[0])

    def add_child(self, group: int, child: int) -> None:
        """Appends an entry to a group. An entry may occur in it repeatedly."""
        self._of_entries(lib.gusset_scene_add_child, group, child)

    def remove_child(self, group: int, child: int) -> None:
        """Removes the first occurrence of an entry from a group."""
        self._of_entries(lib.gusset_scene_remove_child, group, child)

    def remove(self, entry: int) -> None:
        """Removes an entry from the scene and from all groups; its children stay."""
        self._of_entries(lib.gusset_scene_remove, entry)

    def _of_entries(self, function: Any, *entries: int) -> None:
        given = [index(one, "entry") for one in entries]
        with self._alone():
            call(function, self._handle, *given, is_short=True)

    def set_entry(
        self, entry: int, *, net: Optional[Net] = None, transform: Optional[ArrayLike] = None, visible: Optional[bool] = None
    ) -> None:
        """Changes the net, the map (3, 4) or (4, 4), or the visibility of an entry. After an error nothing has changed."""
        changes = sized("gusset_scene_changes")
        if net is not None:
            changes.net = handle_of("net", net)
        if transform is not None:
            rows = ffi.new("struct gusset_transform *", {"rows": affine_rows(transform)})
            changes.transform = rows
        if visible is not None:
            changes.visibility = lib.GUSSET_VISIBILITY_SHOW if visible else lib.GUSSET_VISIBILITY_HIDE
        place = index(entry, "entry")
        with self._alone():
            call(lib.gusset_scene_set_entry, self._handle, place, changes, is_short=True)

    def entry(self, entry: int) -> SceneEntryReport:
        """Describes an entry: kind, map, visibility, number of children."""
        place = index(entry, "entry")
        with self._alone():
            return SceneEntryReport.read(self._handle, place)

    def net(self, entry: int) -> Net:
        """Returns the net of an entry."""
        place = index(entry, "entry")
        with self._alone():
            return Net._of(create("net", self._handle, place, name="scene_net"))

    def children(self, group: int) -> NDArray[np.uint32]:
        """Lists the entries of a group, in order."""
        place, written = index(group, "group"), ffi.new("size_t *")
        with self._alone():
            call(lib.gusset_scene_get_children, self._handle, place, ffi.NULL, 0, written, is_short=True)
            out = np.zeros(written[0], np.uint32)
            if out.size:
                call(lib.gusset_scene_get_children, self._handle, place, ffi.cast("uint32_t *", pointer(out)), out.size, written, is_short=True)
        return out

    def world_transforms(self) -> SceneInstanceArray:
        """Lists all instances, each a path from a top-level entry to an entry. ``world`` is the map into the space of the scene."""
        with self._alone():
            return listed(SceneInstanceArray, lib.gusset_scene_world_transforms, self._handle)

    @property
    def report(self) -> SceneReport:
        """The numbers of nets, groups, instances and levels."""
        with self._alone():
            return SceneReport.read(self._handle)

    def flatten(self, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[ConcatenateOptions]) -> Net:
        """Joins all visible nets into one, in the space of the scene. Without options: from top to bottom, with hidden bridges."""
        given = structs("concatenate_options", options)
        with self._alone():
            return Net._of(create("net", self._handle, given, name="scene_flatten", threads=threads, progress=progress))
