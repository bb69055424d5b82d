"""The outlines of the benchmarks, closed and plane, made at run time.

feet      sections like those of a foot, by formula, with 16 or 32 points each
glyphs    the contours of letters and digits of the Debian package fonts-dejavu-core: the points that lie on them
smooth    random outlines without corners, with 60 to 400 points each, unevenly spaced
"""

import os
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from peers import Peer

FONT = Path("/usr/share/fonts/truetype/dejavu/DejaVuSerif-Bold.ttf")
DATA = Path(os.environ.get("GUSSET_DATA", "../shared/data"))
ttfont = Peer("fontTools.ttLib", after="fontTools")


@dataclass(frozen=True)
class Outlines:
    """All points in one, and where each outline begins and the last one ends."""

    points: np.ndarray  # n x 2 float64
    offsets: np.ndarray  # uint32

    def __iter__(self):
        return (self.points[a:b] for a, b in zip(self.offsets[:-1].tolist(), self.offsets[1:].tolist()))


def together(parts):
    ends = np.cumsum([0, *(len(part) for part in parts)])
    return Outlines(np.ascontiguousarray(np.concatenate(parts), dtype=np.float64), ends.astype(np.uint32))


def foot(k, angles):
    """Section `k` at some angles: a superellipse, its sole flatter than its back and its inside fuller than its outside."""
    random = np.random.default_rng(1000 + k)
    width, height = random.uniform(35, 55), random.uniform(25, 45)
    power = random.uniform(2.1, 2.8)
    cosine, sine = np.cos(angles), np.sin(angles)
    radius = (np.abs(cosine / width) ** power + np.abs(sine / height) ** power) ** (-1 / power)
    waves = random.uniform(-0.05, 0.05, 3)
    phases = random.uniform(0, 2 * np.pi, 3)
    radius = radius * (1 + sum(wave * np.cos((m + 2) * angles + phase) for m, (wave, phase) in enumerate(zip(waves, phases))))
    return np.stack([radius * cosine, radius * sine * np.where(sine < 0, 1 - 0.3 * sine**2, 1)], axis=1)


def round_angles(count):
    return np.arange(count) * (2 * np.pi / count)


@cache
def feet():
    """Twenty sections, and each one's truth: 2048 points."""
    given = [foot(k, round_angles(32 if k % 2 else 16)) for k in range(20)]
    return together(given), [foot(k, round_angles(2048)) for k in range(20)]


def read_csv(path):
    return np.loadtxt(path, delimiter=",", skiprows=1)


@cache
def feet_of_data():
    """The same from the folder of data, or nothing if it is not there."""
    dense = sorted((DATA / "outlines").glob("footlike_*_dense.csv"))
    given = [path.with_name(path.name.replace("_dense", "")) for path in dense]
    return (together([read_csv(path) for path in given]), [read_csv(path) for path in dense]) if dense else None


def glyphs():
    font = ttfont.TTFont(FONT)
    shapes, names = font["glyf"], font.getBestCmap()
    found = []
    for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789":
        points, ends, flags = shapes[names[ord(letter)]].getCoordinates(shapes)
        points, on = np.array(points, dtype=np.float64), np.array(flags) & 1 == 1
        for first, last in zip([0, *(end + 1 for end in ends)], ends):
            contour = points[first:last + 1][on[first:last + 1]]
            if len(contour) >= 4:
                found.append(contour)
    return found


def smooth(count):
    random = np.random.default_rng(7)
    found = []
    for _ in range(count):
        length = int(random.integers(60, 400))
        steps = random.uniform(0.3, 1.7, length).cumsum()
        angles = 2 * np.pi * steps / steps[-1]
        radius = 1 + sum(random.uniform(-0.25, 0.25) / m * np.cos(m * angles + random.uniform(0, 6.3)) for m in range(2, 9))
        centre, scale = random.uniform(-1000, 1000, 2), random.uniform(1, 100)
        found.append(np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1) * scale + centre)
    return found


@cache
def everything():
    """About 240 outlines and 36,000 points."""
    return together([*feet()[0], *glyphs(), *smooth(145)])


def write(outlines, path):
    """For the program in C++: two counts, the offsets, the points."""
    with open(path, "wb") as out:
        np.array([len(outlines.offsets) - 1, len(outlines.points)], dtype=np.uint64).tofile(out)
        outlines.offsets.tofile(out)
        outlines.points.tofile(out)


def deviation(truth, polygon):
    """The farthest that a point of the truth is from a closed polygon, by the longest side of the truth's box. Each point's nearest
    corner is found first, and then the nearest place on its two sides."""
    farthest = 0.0
    for some in np.array_split(truth, 16):
        nearest = ((some[:, None, :] - polygon[None, :, :]) ** 2).sum(axis=2).argmin(axis=1)
        least = np.full(len(some), np.inf)
        for shift in (-1, 0):
            a, b = polygon[(nearest + shift) % len(polygon)], polygon[(nearest + shift + 1) % len(polygon)]
            along = ((some - a) * (b - a)).sum(axis=1) / np.maximum(((b - a) ** 2).sum(axis=1), 1e-300)
            on = a + (b - a) * np.clip(along, 0, 1)[:, None]
            least = np.minimum(least, np.linalg.norm(some - on, axis=1))
        farthest = max(farthest, least.max())
    return farthest / np.ptp(truth, axis=0).max()
