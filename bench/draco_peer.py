"""Draco through DracoPy: triangles, EDGEBREAKER, at the better of two levels."""

from peers import Peer

draco = Peer("DracoPy")
LEVELS = 7, 10


def encode(mesh, bits, level):
    points, faces = mesh
    return draco.encode(points, faces, quantization_bits=bits, compression_level=level)


def decode(data):
    return draco.decode(data)
