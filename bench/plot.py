"""Time against size, for boundary loops and joins."""

import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end comes first)

SIZES = {"k": 1e3, "M": 1e6}


def faces(name):
    found = re.fullmatch(r"coherent-(\d+)([kM])", name)
    return found and int(found[1]) * SIZES[found[2]]


def rims(name):
    """The strips between collars: everything else there is small."""
    found = re.fullmatch(r"(\d+)x(\d+)", name)
    return found and name != "3888x3408" and int(found[1]) + int(found[2])


def curves(entries, module, size):
    """Per contender, times by size."""
    found = {}
    for entry in entries:
        where, name, peer = entry["id"].split("/")
        at = size(name)
        if where != module or not at:
            continue
        for who, value in (("gusset", entry["ours"]), (peer, entry["peer"])):
            if value:
                found.setdefault(who, {})[at] = value
    return found


def draw(axes, found, title, label, only=None):
    for who, values in sorted(found.items(), key=lambda item: item[0] != "gusset"):
        if only is None or who in only:
            at = sorted(values)
            ours = who.startswith("gusset")
            axes.loglog(at, [values[x] for x in at], marker="o", markersize=4, linewidth=2.5 if ours else 1.2, label=who)
    axes.set(title=title, xlabel=label, ylabel="ms")
    axes.grid(True, which="major", linewidth=0.3)
    axes.legend(fontsize=8)


def write_plot(entries, path):
    # Ids from a fixed salt and no date: the same figures give the same file.
    plt.rcParams["svg.hashsalt"] = "gusset"
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(15, 4.8))
    draw(left, curves(entries, "boundary", faces), "Boundary loops, from arrays", "triangles")
    wholes = {"gusset", "gusset-index", "gusset-smooth", "gusset-quad", "meshlib-complex", "blender"}
    draw(middle, curves(entries, "join", rims), "Joins, from arrays to arrays", "vertices of both rims", wholes)
    draw(right, curves(entries, "join-strip", rims), "Joins, the strip alone", "vertices of both rims")
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
