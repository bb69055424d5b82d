"""The gluing of nets: sides, the characteristic matrix, seams, and the 18 local gluings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer, real
from ._call import Progress, call
from ._exchange import index, listed, sized
from ._handles import Reported, create
from ._library import bits_of, ffi, holding, lib, number_of, one_of
from ._net_handle import NetHandle
from ._records import flags, word
from ._reports import GluingOccurrenceArray, NetGluingReport, NetGroupsView, Seam, SeamArray
from .choices import NUMBERS, GluingKind, GluingPlace, GluingType, Sides

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["Gluing", "LocalGluing", "NetGroups", "seam"]

_LINKS = {"east": 1, "south": 2, "west": 4, "north": 8}
_CELL_SIDES = {"top": 1, "right": 2, "bottom": 4, "left": 8}


def seam(a: tuple[int, int], step_a: tuple[int, int], b: tuple[int, int], step_b: tuple[int, int], count: int) -> Seam:
    """Makes a seam, which glues ``count`` nodes of run A to run B. A run begins at (row, column), and steps by (rows, columns).

    >>> seam((0, 0), (1, 0), (4, 6), (-1, 0), 5).row_b
    4
    """
    made = SeamArray.zeros(1)
    try:
        for name, value in zip(_names(made), (*a, *step_a, *b, *step_b, count), strict=True):
            made.array[name] = value
    except OverflowError as error:
        raise ValueError(f"seam: {error}") from None
    return made[0]


def _names(seams: SeamArray) -> tuple[str, ...]:
    return seams.array.dtype.names or ()


def _packed(given: Union[SeamArray, Iterable[Seam]]) -> SeamArray:
    """Returns seams, packed."""
    if isinstance(given, SeamArray):
        return SeamArray(np.ascontiguousarray(given.array).reshape(-1))
    runs = list(given)
    made = SeamArray.zeros(len(runs))
    for place, one in enumerate(runs):
        if not isinstance(one, Seam):
            raise TypeError(f"{one!r} is not a Seam: seam() makes them")
        made.array[place] = tuple(getattr(one, name) for name in _names(made))
    return made


@dataclass(frozen=True, eq=False)
class Gluing:
    """The gluing of a net: its sides or its matrix, and its seams."""

    #: The sides that are glued; None if only the matrix describes them.
    sides: Optional[frozenset[Sides]]
    #: (2 * rows, columns): 1 for a contracted link. Row 2 i has the horizontal links of row i, row 2 i + 1 the vertical ones.
    matrix: NDArray[np.uint8]
    seams: SeamArray
    #: Faces have the opposite orientation.
    reversed: bool
    bridge_count: int


class LocalGluing(NamedTuple):
    """Names one place to glue or to unglue: a link, a node, a cell or a seam.

    Link 2 * node is horizontal, 2 * node + 1 vertical; cell (i, j) is i * (columns - 1) + j."""

    kind: GluingKind
    element: int = 0
    mask: int = 0
    seam: Optional[Seam] = None

    @classmethod
    def link(cls, link: int) -> LocalGluing:
        """Glues the two ends of a link."""
        return cls("link", index(link, "link"))

    @classmethod
    def star(cls, node: int, *links: Literal["east", "south", "west", "north"]) -> LocalGluing:
        """Glues a node to its neighbours in some directions."""
        return cls("star", index(node, "node"), sum(one_of(_LINKS, "link", word) for word in set(links)))

    @classmethod
    def cell(cls, cell: int, *sides: Literal["top", "right", "bottom", "left"]) -> LocalGluing:
        """Glues the ends of some sides of a cell."""
        return cls("cell", index(cell, "cell"), sum(one_of(_CELL_SIDES, "side", word) for word in set(sides)))

    @classmethod
    def diagonal(cls, cell: int, corners: Literal["falling", "rising"]) -> LocalGluing:
        """Glues opposite corners of a cell: the first and third (falling), or the second and fourth."""
        return cls("diagonal", index(cell, "cell"), one_of({"falling": 1, "rising": 2}, "corners", corners))

    @classmethod
    def along(cls, seam: Seam) -> LocalGluing:
        """Glues the two runs of a seam."""
        return cls("seam", seam=seam)

    @classmethod
    def of_type(cls, kind: GluingType, element: int) -> LocalGluing:
        """Glues a node, or from ``"top_bottom"`` on a cell, by one of the 18 local gluings."""
        return cls("type", index(element, "element"), number_of("gusset_gluing_type", "type", kind))


def _gluings(given: Sequence[LocalGluing]) -> Any:
    structs = ffi.new("struct gusset_gluing[]", max(len(given), 1))
    for struct, one in zip(structs, given):
        if not isinstance(one, LocalGluing):
            raise TypeError(f"{one!r} is not a LocalGluing")
        struct.kind = number_of("gusset_gluing_kind", "kind", one.kind)
        struct.element, struct.mask = index(one.element, "element"), index(one.mask, "mask")
        if one.seam is not None:
            ffi.memmove(ffi.addressof(struct, "seam"), _packed([one.seam]).pointer(), ffi.sizeof("struct gusset_seam"))
    return structs


class NetGroups(Reported[NetGroupsView], Sequence[NDArray[np.uint32]]):
    """Points of several glued nodes: an array of nodes for each. Node (row, column) is row * columns + column."""

    REPORT = NetGroupsView

    def __len__(self) -> int:
        return len(self.report.offsets) - 1

    @overload
    def __getitem__(self, place: int) -> NDArray[np.uint32]: ...

    @overload
    def __getitem__(self, place: slice) -> list[NDArray[np.uint32]]: ...

    def __getitem__(self, place: Union[int, slice]) -> Union[NDArray[np.uint32], list[NDArray[np.uint32]]]:
        places = range(len(self))[place]
        if isinstance(places, range):
            return [self[k] for k in places]
        start, end = self.report.offsets[places:places + 2]
        return self.report.members[start:end]

    def __iter__(self) -> Iterator[NDArray[np.uint32]]:
        return (self[k] for k in range(len(self)))


class NetGluing(NetHandle):
    """The part of :class:`Net` that describes and changes the gluing. Changes make another net."""

    @property
    def gluing(self) -> Gluing:
        """The gluing in normal form: sides replace links, and links replace seams, where possible."""
        report = NetGluingReport.read(self._handle, ffi.NULL, 0, ffi.NULL, 0)._struct
        rows, columns = self.shape
        matrix, seams = np.zeros((2 * rows, columns), np.uint8), SeamArray.zeros(report.seam_count)
        runs = seams.pointer() if len(seams) else ffi.NULL
        NetGluingReport.read(self._handle, ffi.cast("uint8_t *", pointer(matrix)), matrix.size, runs, len(seams))
        # A tube is rows that are closed.
        sides = None if report.sides == 2**32 - 1 else flags(report.sides, "gusset_sides") - {"tube"}
        return Gluing(sides, matrix, seams, bool(report.reversed), report.bridge_count)

    def set_gluing(
        self, sides: Union[Sides, Sequence[Sides]] = "sheet", *, matrix: Optional[ArrayLike] = None,
        seams: Union[SeamArray, Iterable[Seam]] = (), reversed: bool = False
    ) -> Self:
        """Replaces the gluing; positions stay.

        Args:
            sides: the sides that are glued, such as ``"torus"`` or ``["rows_closed", "pole_top"]``; not with a matrix.
            matrix: (2 * rows, columns), see :class:`Gluing`.
            seams: additional seams.
            reversed: faces have the opposite orientation.

        >>> import numpy as np, gusset_mesh as gm
        >>> sheet = gm.Net.primitive(shape="plane", size=(1, 1, 1), rows=5, columns=5)
        >>> sheet.set_gluing("torus").complex().report.euler
        0
        """
        rows, columns = self.shape
        given = sized("gusset_net_gluing", sides=bits_of(NUMBERS["gusset_sides"], "sides", sides), reversed=int(bool(reversed)))
        bytes_ = None
        if matrix is not None:
            bytes_ = np.ascontiguousarray(matrix, np.uint8)
            if bytes_.shape != (2 * rows, columns):
                raise ValueError(f"the matrix has the shape {bytes_.shape}, not {(2 * rows, columns)}")
            given.matrix = pointer(bytes_)
        runs = _packed(seams)
        given.seams, given.seam_count = runs.pointer(), len(runs)
        return self._changed(lib.gusset_net_set_gluing, holding(given, bytes_, runs))

    def glue(
        self, *gluings: LocalGluing, links: ArrayLike = (), detect: Optional[float] = None, saturate: bool = False, snap: bool = False,
        threads: int = 0, progress: Optional[Progress] = None,
    ) -> Self:
        """Glues nodes. The steps follow the order detect, gluings, links, saturate, snap.

        Args:
            gluings: nodes to glue.
            links: links to contract, such as ``contracted`` of :meth:`Net.analysis`.
            detect: replaces the gluing by the one of nodes that coincide within this distance; None: no detection.
            saturate: contracts every link whose ends are one point.
            snap: moves all nodes of a point to its first node, bit for bit.
        """
        contracted = indices_of(np.asarray(links, np.uint32) if np.size(links) == 0 else links, "links").reshape(-1)
        structs = _gluings(gluings)
        given = sized("gusset_glue_options", gluings=structs, gluing_count=len(gluings), links=ffi.cast("uint32_t *", pointer(contracted)),
                      link_count=len(contracted), saturate=int(bool(saturate)), snap=int(bool(snap)))
        if detect is not None:
            given.tolerance, given.detect = real(detect), 1
        return self._changed(lib.gusset_net_glue, holding(given, structs, contracted), ffi.NULL, threads=threads, progress=progress)

    def unglue(
        self, *gluings: LocalGluing, separation: float = 0.0, threads: int = 0, progress: Optional[Progress] = None
    ) -> Self:
        """Unglues pairs of nodes. With a separation, the pieces of a point move apart."""
        return self._changed(lib.gusset_net_unglue, _gluings(gluings), len(gluings), real(separation), ffi.NULL,
                             threads=threads, progress=progress)

    def classes(self) -> NDArray[np.uint32]:
        """Returns (rows, columns) numbers: for each node, the first node of its point."""
        rows, columns = self.shape
        out, written = np.zeros((rows, columns), np.uint32), ffi.new("size_t *")
        call(lib.gusset_net_classes, self._handle, ffi.cast("uint32_t *", pointer(out)), out.size, written)
        return out

    def groups(self) -> NetGroups:
        """Finds the points of several glued nodes."""
        return NetGroups(create("net_groups", self._handle))

    def classify(self, place: GluingPlace, element: int, *, cyclic: bool = False) -> GluingType:
        """Finds the local gluing at a node or a cell; ``"none"`` for a node without glued links and for a quad.

        Args:
            cyclic: links back to the first row or column count.
        """
        found = ffi.new("uint32_t *")
        where = number_of("gusset_gluing_place", "place", place)
        call(lib.gusset_net_classify, self._handle, where, index(element, "element"), int(bool(cyclic)), found)
        kind: GluingType = word(found[0], "gusset_gluing_type")
        return kind

    def histogram(self) -> tuple[dict[GluingType, int], dict[GluingType, int]]:
        """Counts the nodes, and the cells, with each local gluing. Words without nodes or cells are missing."""
        counts = np.zeros((2, 18), np.uint64)
        nodes, cells = (ffi.cast("uint64_t *", pointer(one)) for one in counts)
        call(lib.gusset_net_histogram, self._handle, nodes, cells)
        first, second = ({word(k, "gusset_gluing_type"): int(n) for k, n in enumerate(one) if n} for one in counts)
        return first, second

    def gluing_occurrences(self, *, cyclic: bool = False) -> GluingOccurrenceArray:
        """Lists all local gluings, at nodes and then at cells, with the numbers of Deryagin's Fig. 4."""
        return listed(GluingOccurrenceArray, lib.gusset_net_gluing_occurrences, self._handle, int(bool(cyclic)))
