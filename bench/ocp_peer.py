"""Open CASCADE from Python: a program for the virtual environment of one version of cadquery-ocp. It reads the queries that the C++
program wrote, and prints times in milliseconds and accuracies of each case as JSON."""

import json
import math
import statistics
import sys
import time

from OCP.Geom import Geom_BSplineSurface, Geom_Line, Geom_Plane
from OCP.GeomAPI import GeomAPI_IntCS, GeomAPI_IntSS, GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Dir, gp_Pnt

try:
    from OCP.TColgp import TColgp_Array2OfPnt as Poles
    from OCP.TColStd import TColStd_Array1OfInteger as Integers, TColStd_Array1OfReal as Reals
except ImportError:  # Since version 8 arrays have other names.
    from OCP.collections import Array1_double as Reals, Array1_int as Integers, Array2_gp_Pnt as Poles

TOLERANCE = 1e-7
PATIENCE = 3.0  # seconds
FINE = 100


def knots(given):
    """Degree 3, with simple inner knots."""
    values, times = Reals(1, len(given) - 6), Integers(1, len(given) - 6)
    for k, value in enumerate(given[3:-3], 1):
        values.SetValue(k, value)
        times.SetValue(k, 4 if k in (1, len(given) - 6) else 1)
    return values, times


def surface(spline):
    rows, columns = spline["rows"], spline["columns"]
    poles = Poles(1, rows, 1, columns)
    for k, point in enumerate(spline["controls"]):
        poles.SetValue(k // columns + 1, k % columns + 1, gp_Pnt(*point))
    (u, u_times), (v, v_times) = knots(spline["u_knots"]), knots(spline["v_knots"])
    return Geom_BSplineSurface(poles, u, v, u_times, v_times, 3, 3)


def prepared(of, points):
    projection = GeomAPI_ProjectPointOnSurf()
    projection.Init(of, *of.Bounds())
    feet = []
    for point in points:
        projection.Perform(gp_Pnt(*point))
        feet.append(projection.NearestPoint())
    return feet


def anew(of, points):
    return [GeomAPI_ProjectPointOnSurf(gp_Pnt(*point), of).NearestPoint() for point in points]


def hits(of, lines):
    found = [GeomAPI_IntCS(Geom_Line(gp_Pnt(*origin), gp_Dir(*direction)), of) for origin, direction in lines]
    return [one.Point(k) for one in found for k in range(1, one.NbPoints() + 1)]


def curves(a, b):
    found = GeomAPI_IntSS(a, b, TOLERANCE)
    if not found.IsDone():
        raise RuntimeError("GeomAPI_IntSS is not done")
    return [found.Line(k) for k in range(1, found.NbLines() + 1)]


def off(point, centre=(0, 0, 0)):
    """From the torus; negative within."""
    x, y, z = point.X() - centre[0], point.Y() - centre[1], point.Z() - centre[2]
    return math.hypot(math.hypot(x, y) - 1, z) - 0.4


def judge_feet(points, feet):
    errors = [abs(gp_Pnt(*point).Distance(foot) - abs(off(gp_Pnt(*point)))) for point, foot in zip(points, feet)]
    right = [error for error in errors if error <= 2e-3]
    return {"max_error": max(right, default=0.0), "wrong": len(errors) - len(right), "queries": len(errors)}


def judge_curves(found, centres):
    points = [curve.Value(low + (high - low) * i / FINE) for curve in found
              for low, high in [(curve.FirstParameter(), curve.LastParameter())] for i in range(FINE + 1)]
    worst = max((abs(off(point, centre)) for point in points for centre in centres), default=0.0)
    return {"max_error": worst, "curves": len(found), "points": len(points)}


def outcome(work, judge):
    times, start = [], time.perf_counter()
    try:
        while len(times) < 5 and time.perf_counter() - start < PATIENCE:
            began = time.perf_counter()
            result = work()
            times.append(1000 * (time.perf_counter() - began))
        return {"time": statistics.median(times), "runs": len(times), "quality": judge(result)}
    except Exception as error:  # Whatever it throws is its result.
        return {"failed": f"{type(error).__name__}: {error}".splitlines()[0]}


def main():
    with open(sys.argv[1]) as file:
        asked = json.load(file)
    a, b = map(surface, asked["splines"])
    plane = Geom_Plane(gp_Pnt(*asked["plane"][0]), gp_Dir(*asked["plane"][1]))
    cases = {}
    for kind in "near", "far":
        points = asked[kind]
        cases[f"{kind}-spline"] = lambda points=points: prepared(a, points), lambda feet, points=points: judge_feet(points, feet)
        cases[f"{kind}-spline-anew"] = lambda points=points: anew(a, points), lambda feet, points=points: judge_feet(points, feet)
    cases["line-spline"] = lambda: hits(a, asked["lines"]), lambda found: {
        "max_error": max(abs(off(point)) for point in found), "hits": len(found), "queries": len(asked["lines"])}
    cases["plane-spline"] = lambda: curves(a, plane), lambda found: judge_curves(found, [(0, 0, 0)])
    cases["ssi"] = lambda: curves(a, b), lambda found: judge_curves(found, [(0, 0, 0), asked["shift"]])
    wanted = [case for case in cases if sys.argv[2] in f"carcass/{case}"]
    print(json.dumps({case: outcome(*cases[case]) for case in wanted}))


if __name__ == "__main__":
    main()
