"""Deformation fields for :meth:`Net.deform`. Each function makes one.

An axis is ``"x"``, ``"y"`` or ``"z"``: w is the coordinate on it, and u and v are the next two in the cycle x, y, z.

>>> import gusset_mesh as gm
>>> plane = gm.Net.primitive(shape="plane", size=(2, 1, 1), rows=9, columns=17)
>>> half = gm.fields.twist("x", rate=1.5).with_strength(0.5)
>>> turned = plane.deform(half, gm.fields.shear("z", "x", rate=0.2))
>>> turned.shape
(9, 17)
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer, real, reals_of
from ._exchange import index, numbers, vector
from ._library import ffi, holding, number_of
from .choices import Axis, Easing, FieldKind

__all__ = ["Field", "affine", "bend", "lattice", "parallel", "perspective", "projection", "shear", "spherify", "taper", "twist",
           "wrap_cone", "wrap_cylinder", "wrap_sphere", "wrap_torus"]


@dataclass(frozen=True, eq=False)
class Field:
    """A deformation field, made by a function of :mod:`gusset_mesh.fields`."""

    kind: FieldKind
    #: Its numbers, as C takes them.
    values: tuple[float, ...]
    axis: Optional[Axis] = None
    other_axis: Optional[Axis] = None
    #: 0 changes nothing, 1 applies the whole field.
    strength: float = 1.0
    #: (n, 2): times and strengths, which multiply ``strength``; None: it does not depend on time.
    keys: Optional[NDArray[np.float64]] = None
    easing: Easing = "linear"
    #: For a lattice: the displacement of each control point.
    offsets: Optional[NDArray[np.float64]] = None
    counts: tuple[int, ...] = (0, 0, 0)

    def with_strength(self, strength: float) -> Field:
        """Returns the field with another strength: 0 changes nothing, 1 applies the whole field."""
        return replace(self, strength=real(strength))

    def with_keys(self, times: ArrayLike, strengths: ArrayLike, easing: Easing = "linear") -> Field:
        """Returns the field with a strength that depends on time: given at rising times, and interpolated by ``easing``."""
        pairs = np.stack([numbers(times, (-1,), "times"), numbers(strengths, (len(np.atleast_1d(np.asarray(times))),), "strengths")], axis=1)
        number_of("gusset_easing", "easing", easing)
        return replace(self, keys=np.ascontiguousarray(pairs), easing=easing)


def fields_of(given: Iterable[Field]) -> tuple[Any, int]:
    """Makes an array of fields for C, and returns it with its length."""
    chain = list(given)
    structs = ffi.new("struct gusset_field[]", max(len(chain), 1))
    for struct, field in zip(structs, chain):
        if not isinstance(field, Field):
            raise TypeError(f"{field!r} is not a Field")
        struct.struct_size = ffi.sizeof("struct gusset_field")
        struct.kind = number_of("gusset_field_kind", "kind", field.kind)
        struct.axis = 0 if field.axis is None else number_of("gusset_axis", "axis", field.axis)
        struct.other_axis = 0 if field.other_axis is None else number_of("gusset_axis", "other axis", field.other_axis)
        struct.easing, struct.strength = number_of("gusset_easing", "easing", field.easing), field.strength
        struct.values = list(field.values)
        if field.keys is not None:
            struct.keys, struct.key_count = pointer(field.keys), len(field.keys)
        if field.offsets is not None:
            struct.offsets, struct.counts = pointer(field.offsets), list(field.counts)
    return holding(structs, chain), len(chain)


def _about(kind: FieldKind, axis: Axis, *values: float, other_axis: Optional[Axis] = None) -> Field:
    number_of("gusset_axis", "axis", axis)
    return Field(kind, tuple(real(one) for one in values), axis, other_axis)


def affine(matrix: ArrayLike) -> Field:
    """Applies an affine map: (3, 4), the last column the translation, or (4, 4) with the last row 0, 0, 0, 1."""
    return Field("affine", tuple(affine_rows(matrix)))


def affine_rows(matrix: ArrayLike) -> list[float]:
    """Returns the three rows of four numbers of a matrix (3, 4) or (4, 4)."""
    array = reals_of(matrix)
    if array.shape == (4, 4) and np.array_equal(array[3], [0, 0, 0, 1]):
        array = array[:3]
    if array.shape != (3, 4):
        raise ValueError(f"the matrix has the shape {array.shape}, not (3, 4), nor is it (4, 4) with the last row 0, 0, 0, 1")
    rows: list[float] = array.reshape(-1).tolist()
    return rows


def twist(axis: Axis, rate: float, start: float = 0.0) -> Field:
    """Turns about an axis, by ``rate`` radians for each unit along it from ``start`` on."""
    return _about("twist", axis, rate, start)


def taper(axis: Axis, rate: float, start: float = 0.0) -> Field:
    """Scales u and v by 1 + rate (w - start)."""
    return _about("taper", axis, rate, start)


def bend(axis: Axis, curvature: float, start: float = 0.0, end: float = np.inf) -> Field:
    """Bends an axis from ``start`` to ``end`` into an arc towards u; it continues straight beyond."""
    return _about("bend", axis, curvature, start, end)


def shear(axis: Axis, other_axis: Axis, rate: float) -> Field:
    """Adds ``rate`` times the coordinate on another axis to w."""
    number_of("gusset_axis", "other axis", other_axis)
    return _about("shear", axis, rate, other_axis=other_axis)


def spherify(centre: ArrayLike, radius: float) -> Field:
    """Projects onto a sphere from its centre, where the field is not defined."""
    return Field("spherify", (*vector(centre, "centre"), real(radius)))


def wrap_cylinder(axis: Axis, radius: float) -> Field:
    """Rolls space round a cylinder: u becomes the arc, v the height above it."""
    return _about("cylinder_wrap", axis, radius)


def wrap_torus(axis: Axis, radius: float, minor_radius: float) -> Field:
    """Rolls space into a torus: u becomes the arc round the axis, v the arc round the tube, w the height above it.

    Up to a strength of 1/2 a sheet rolls into a straight tube, which bends beyond that.
    """
    return _about("torus_wrap", axis, radius, minor_radius)


def wrap_cone(axis: Axis, radius: float, angle: float) -> Field:
    """Rolls space into a cone whose generators lean towards the axis by an angle: w becomes the length along them."""
    return _about("cone_wrap", axis, radius, angle)


def wrap_sphere(axis: Axis, radius: float) -> Field:
    """Rolls space into a sphere: u becomes the arc of the equator, v of the meridian, w the height above it."""
    return _about("sphere_wrap", axis, radius)


def lattice(low: ArrayLike, high: ArrayLike, offsets: ArrayLike) -> Field:
    """Deforms a box by a grid of control points (free-form deformation). Points outside stay.

    Args:
        low, high: the corners of the box.
        offsets: (nx, ny, nz, 3): the displacement of each control point, 2 to 32 along each axis.
    """
    array = numbers(offsets, (-1, -1, -1, 3), "offsets")
    counts = tuple(index(count, "counts") for count in array.shape[:3])
    if not all(2 <= count <= 32 for count in counts):
        raise ValueError(f"the lattice has {counts} control points, not 2 to 32 along each axis")
    packed = np.ascontiguousarray(array.transpose(2, 1, 0, 3))  # x varies fastest
    return Field("lattice", (*vector(low, "low"), *vector(high, "high")), offsets=packed, counts=counts)


def projection(matrix: ArrayLike) -> Field:
    """Applies a projective map (4, 4). It is not defined where the fourth homogeneous coordinate becomes 0."""
    return Field("projection", tuple(numbers(matrix, (4, 4), "rows of the matrix").reshape(-1).tolist()))


def parallel(point: ArrayLike, normal: ArrayLike, direction: ArrayLike) -> Field:
    """Projects along a direction onto the plane through a point with a normal."""
    return _projected("parallel", point, normal, direction)


def perspective(eye: ArrayLike, point: ArrayLike, normal: ArrayLike) -> Field:
    """Projects from the eye onto the plane through a point with a normal."""
    return _projected("perspective", eye, point, normal)


def _projected(kind: FieldKind, *vectors: ArrayLike) -> Field:
    parts: Sequence[list[float]] = [vector(one) for one in vectors]
    return Field(kind, tuple(number for part in parts for number in part))
