"""Bridges between joined nets: their properties, their equilibrium, and how to split them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np

from ._arrays import real
from ._call import Progress, call
from ._exchange import answer, handle_of, index
from ._keywords import options as structs
from ._library import ffi, lib, number_of
from ._net_handle import NetHandle
from ._options import SettleOptions, Unpack
from ._reports import Bridge, NetGluingReport, SettleReport
from .choices import BridgeMode

if TYPE_CHECKING:
    from typing_extensions import Self


class NetBridges(NetHandle):
    """The part of :class:`Net` that deals with bridges, which :meth:`Net.concatenate` makes."""

    def bridges(self) -> list[Bridge]:
        """Lists the bridges: place, mode and properties of each."""
        count = NetGluingReport.read(self._handle, ffi.NULL, 0, ffi.NULL, 0)._struct.bridge_count
        return [Bridge.read(self._handle, k) for k in range(count)]

    def set_bridge(
        self, bridge: int, mode: BridgeMode = "keep", *, tolerance: float = 0.0, tension: Optional[float] = None,
        elasticity: Optional[float] = None, stiffness: Optional[float] = None, user: Optional[int] = None
    ) -> Self:
        """Changes the mode and the properties of a bridge.

        Args:
            bridge: index of the bridge.
            mode: the cells are ordinary (keep) or absent (hide), or both sides become one (weld).
            tolerance: for welding: largest distance of coincident nodes.
            tension, elasticity, stiffness, user: new properties; None: unchanged.
        """
        given = {"tension": tension, "elasticity": elasticity, "stiffness": stiffness, "user": user}
        properties = ffi.NULL
        if any(value is not None for value in given.values()):
            present = self.bridges()
            if not 0 <= bridge < len(present):
                raise IndexError(f"there is no bridge {bridge}: the net has {len(present)}")
            old = present[bridge].properties
            properties = ffi.new("struct gusset_bridge_properties *")
            for name, value in given.items():
                setattr(properties, name, getattr(old, name) if value is None else value)
        return self._changed(lib.gusset_net_set_bridge, index(bridge, "bridge", 64), number_of("gusset_bridge_mode", "mode", mode),
                             real(tolerance), properties)

    def split(self, bridge: int) -> tuple[Self, Self]:
        """Splits the net at a bridge that runs from side to side: the inverse of :meth:`Net.concatenate`.

        >>> import gusset_mesh as gm
        >>> sheet = gm.Net.primitive(shape="plane", size=(1, 1, 1), rows=3, columns=4)
        >>> first, second = gm.Net.concatenate([sheet, sheet.translate([2, 0, 0])], rows=2).split(0)
        >>> first.shape, second.shape
        ((3, 4), (3, 4))
        """
        first, second = (ffi.new("struct gusset_net **") for _ in range(2))
        call(lib.gusset_net_split_create, self._handle, index(bridge, "bridge", 64), first, second)
        made = [self._of(ffi.gc(one[0], lib.gusset_net_destroy)) for one in (first, second)]
        return made[0], made[1]

    def settle(
        self, reference: Optional[Self] = None, *, threads: int = 0, progress: Optional[Progress] = None, **options: Unpack[SettleOptions]
    ) -> tuple[Self, SettleReport]:
        """Moves inner nodes of bridges, and free parts, to the equilibrium of the bridges' properties.

        Args:
            reference: net of equal size that gives the rest lengths; None: this net.
            options: ``free`` has one flag for each part between bridges: True moves it as a rigid body.

        Returns:
            the net, and a report: ``converged``, energies, ``residual_force`` and more.
        """
        if options.get("free") is not None:
            options = {**options, "free": np.asarray(options["free"]).reshape(-1).astype(bool)}
        # An option of None leaves the default, in a struct that can take the reference.
        given = structs("settle_options", {"tolerance": None, **options})
        if reference is not None:
            given.reference = handle_of("net", reference)
        copy = self._copied()
        return copy, answer(SettleReport, lib.gusset_net_settle, copy._handle, given, threads=threads, progress=progress)
