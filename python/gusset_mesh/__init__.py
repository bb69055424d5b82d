"""Surfaces that come in pieces: stitching and mending of polygon meshes, nets of quads, smooth surfaces, outlines.

Meshes are numpy arrays, which the library reads where they are; results are arrays that it lends. Every call lets other threads run, and Ctrl-C
stops it. What cannot be used raises :class:`InputError` with the element at fault.
"""

from . import filters
from ._handles import Handle, MeshResult, Origins
from ._library import lib as _lib
from ._library import text as _text
from ._options import *  # noqa: F403
from ._options import __all__ as _options
from ._plugin import Curves
from ._records import Record
from .errors import Cancelled, Error, InputError, OutOfMemory
from .joining import *  # noqa: F403
from .joining import __all__ as _joining
from .mesh import Mesh, MeshLike, as_mesh
from .net import Net, NetMesh
from .outline import Curve, Outline, Places
from .surface import Hits, Paths, Sheet, SheetMesh, Surface

__version__ = _text(_lib.gusset_version())

__all__ = ["Cancelled", "Curve", "Curves", "Error", "Handle", "Hits", "InputError", "Mesh", "MeshLike", "MeshResult", "Net", "NetMesh", "Origins",
           "OutOfMemory", "Outline", "Paths", "Places", "Record", "Sheet", "SheetMesh", "Surface", "as_mesh", "filters",
           *_joining, *(name for name in _options if name.endswith("Options"))]
