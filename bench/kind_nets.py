"""Random nets of the kinds that people compress and take apart. See kinds.py."""

import numpy as np

import gusset_mesh as gm
from kind_judge import Case, Place


def compressed_tiles(random):
    """Tiles of one surface, each compressed by itself to levels given by a box and a step: shared rows and columns stay equal.

    Every point stays within half a step of its place, along each axis of the box."""
    rows, columns = (int(n) for n in random.integers(5, 40, 2))
    place, waves = Place(random), 1 + 2 * random.random(2)
    x, y = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    height = 0.3 * np.sin(waves[0] * x) * np.cos(waves[1] * y) + 0.1 * random.random(x.shape)
    nodes = place.points(np.stack([x, y, height], axis=-1))
    cuts = [np.unique(np.r_[0, random.integers(1, n - 1, 2), n - 1]) for n in (rows, columns)]
    low, high = nodes.min(axis=(0, 1)), nodes.max(axis=(0, 1))
    # A box may be wider than the tiles, and the step any part of it.
    low, high = low - random.random(3) * place.size, high + random.random(3) * place.size
    step, bits = float((high - low).max()) * 10 ** random.uniform(-5, -2.5), int(random.integers(10, 20))
    levels = {"step": step} if random.random() < 0.5 else {"bits": bits}
    if "bits" in levels:
        step = float((high - low).max()) / (2**bits - 1)

    def run():
        whole, apart, off = np.full((rows, columns, 3), np.nan), 0, 0.0
        for i, k in zip(cuts[0], cuts[0][1:]):
            for j, m in zip(cuts[1], cuts[1][1:]):
                tile = np.s_[i:k + 1, j:m + 1]
                stream = gm.Net(nodes[tile]).encode(levels="given", low=low, high=high, **levels)
                back = np.asarray(gm.Net.decode(bytes(stream)).nodes).reshape(nodes[tile].shape)
                known = ~np.isnan(whole[tile])
                apart += int((back[known] != whole[tile][known]).sum())
                off = max(off, float(np.abs(back - nodes[tile]).max()) / step)
                whole[tile] = back
        return (apart, off), ""
    return Case(run, lambda found: found[0] == 0 and found[1] < 0.5 + 1e-6, raw=True)


NETS = (compressed_tiles,)
