// Random curves of Bézier segments against dense samples: sign changes, bisection, Newton's method
// from crossings of polylines, and bounds by subdivision.
#include "pieces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace campaign {
namespace of_curves {
namespace {
using gusset::Curve;
using gusset::Place;
/// Samples of each segment.
constexpr uint32_t samples = 200;
constexpr double rounding = 1e-9;

double dot(const Point &a, const Point &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point plus(const Point &a, const Point &b, double t) { return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]}; }
Point minus(const Point &a, const Point &b) { return plus(a, b, -1); }
double size(const Point &a) { return std::sqrt(dot(a, a)); }

/// Control points of each segment.
using Segments = std::vector<std::vector<Point>>;

Point at(std::vector<Point> controls, double t) {
    for (std::size_t n = controls.size(); n > 1; --n) {
        for (std::size_t k = 0; k + 1 < n; ++k) {
            controls[k] = plus(controls[k], minus(controls[k + 1], controls[k]), t);
        }
    }
    return controls[0];
}
Point derivative(const std::vector<Point> &controls, double t) {
    std::vector<Point> differences;
    for (std::size_t k = 1; k < controls.size(); ++k) {
        differences.push_back(plus({0, 0, 0}, minus(controls[k], controls[k - 1]), double(controls.size() - 1)));
    }
    return at(differences, t);
}

struct Tested {
    Segments segments;
    Curve curve;
    bool closed, lattice;
};

Tested random_curve(Random &random, bool plane, bool lattice) {
    const bool closed = random.one_in(3);
    const uint32_t count = random.between(closed ? 2 : 1, 4);
    const auto coordinate = [&] { return lattice ? double(random.below(9)) - 4 : random.real(-1, 1); };
    const auto point = [&] { return Point{coordinate(), coordinate(), plane ? 0.0 : coordinate()}; };
    Segments segments;
    std::vector<Point> points{point()};
    std::vector<uint32_t> ends{0};
    for (uint32_t s = 0; s < count; ++s) {
        const uint32_t degree = random.between(1, 5);
        std::vector<Point> controls{points.back()};
        for (uint32_t k = 1; k <= degree; ++k) {
            controls.push_back(closed && s + 1 == count && k == degree ? points[0] : point());
        }
        points.insert(points.end(), controls.begin() + 1, controls.end());
        ends.push_back(static_cast<uint32_t>(points.size() - 1));
        segments.push_back(controls);
    }
    if (plane) {
        std::vector<std::array<double, 2>> flat;
        for (const Point &p : points) {
            flat.push_back({p[0], p[1]});
        }
        return {segments, Curve::from_controls(flat, ends, closed), closed, lattice};
    }
    return {segments, Curve::from_controls(points, ends, closed), closed, lattice};
}

double global(const Place &place) { return place.segment + place.t; }

/// Whether a place is near a parameter, also across the joint of a closed curve.
bool near(const Tested &tested, const Place &place, double low, double high) {
    const double n = double(tested.segments.size()), t = global(place);
    return (low <= t && t <= high) || (tested.closed && ((low <= t + n && t + n <= high) || (low <= t - n && t - n <= high)));
}

/// A function that changes its sign without a root: the tangents at a cusp.
bool is_jump(const std::function<double(std::size_t, double)> &value, std::size_t s, double low, double high) {
    const bool falling = value(s, high) < 0;
    for (int step = 0; step < 12; ++step) {
        const double middle = (low + high) / 2;
        ((value(s, middle) < 0) == falling ? high : low) = middle;
    }
    // Within 1e-6: a change without a jump would need a slope of 1e4.
    return std::abs(value(s, high) - value(s, low)) > 1e-2;
}

/// Each sign change of a function along the curve is found, and the function is 0 at each place.
/// `residual`: of what a place may have, for rounding.
void check_roots(Case &test, const Tested &tested, const std::function<double(std::size_t, double)> &value, const gusset::Places &found, double residual,
                 bool once) {
    for (const Place &place : found.places()) {
        test.at_most(std::abs(value(place.segment, place.t)), residual, "what a place is off");
    }
    for (std::size_t s = 0; s < tested.segments.size(); ++s) {
        double before = value(s, 0);
        for (uint32_t k = 1; k <= samples; ++k) {
            const double low = double(k - 1) / samples, high = double(k) / samples, after = value(s, high);
            const double noise = 10 * residual;
            if (std::abs(before) > noise && std::abs(after) > noise) {
                const auto inside = std::count_if(found.places().begin(), found.places().end(), [&](const Place &place) {
                    return place.segment == s && low < place.t && place.t < high;
                });
                if ((before < 0) != (after < 0) && is_jump(value, s, low, high)) {
                    test.note("sign changes by a jump, at cusps");
                } else if ((before < 0) != (after < 0)) {
                    test.check(inside >= 1 || !found.overlaps().empty(), "a sign change has no place");
                    test.check(!once || inside % 2 == 1, "a sign change has an even number of places");
                } else if (once && inside % 2 != 0) {
                    test.note("places where there is no sign change: touches");
                }
            }
            before = after;
        }
    }
}

void check_values(Case &test, const Tested &tested) {
    std::vector<Place> places;
    for (std::size_t s = 0; s < tested.segments.size(); ++s) {
        for (uint32_t k = 0; k <= 20; ++k) {
            places.push_back(gusset::place(static_cast<uint32_t>(s), k / 20.0));
        }
    }
    const auto own = tested.curve.derivatives(places, 1);
    const gusset_curve_measures bounds = tested.curve.measure(GUSSET_CURVE_MEASURE_BOUNDS);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto &controls = tested.segments[places[k].segment];
        const Point p = at(controls, places[k].t);
        test.at_most(size(minus(own[2 * k], p)), 1e-13, "the error of a point");
        test.at_most(size(minus(own[2 * k + 1], derivative(controls, places[k].t))), 1e-11, "the error of a derivative");
        for (std::size_t i = 0; i < 3; ++i) {
            test.check(bounds.low[i] <= p[i] + 1e-13 && p[i] <= bounds.high[i] + 1e-13, "a point outside the bounds");
        }
    }
    // The bounds are reached, within what samples miss.
    for (std::size_t i = 0; i < 3; ++i) {
        double low = 1e9, high = -1e9, bend = 0;
        for (const auto &controls : tested.segments) {
            for (uint32_t k = 0; k <= samples; ++k) {
                const double x = at(controls, double(k) / samples)[i];
                low = std::min(low, x);
                high = std::max(high, x);
            }
            for (const Point &p : controls) {
                bend = std::max(bend, std::abs(p[i]));
            }
        }
        // The second derivative is at most 4 n (n - 1) max|p|.
        const double missed = 80 * bend / 8 / samples / samples + 1e-12;
        test.at_most(low - bounds.low[i], missed, "what the lower bound is below all points");
        test.at_most(bounds.high[i] - high, missed, "what the upper bound is above all points");
    }
}

/// Chords and control polygons of subdivided segments enclose the length.
void check_lengths(Case &test, const Tested &tested) {
    double least = 0, most = 0;
    const std::function<void(const std::vector<Point> &, int)> add = [&](const std::vector<Point> &controls, int depth) {
        if (depth == 0) {
            least += size(minus(controls.back(), controls.front()));
            for (std::size_t k = 1; k < controls.size(); ++k) {
                most += size(minus(controls[k], controls[k - 1]));
            }
            return;
        }
        std::vector<Point> left, right, row = controls;
        for (std::size_t n = controls.size(); n > 0; --n) {
            left.push_back(row[0]);
            right.push_back(row[n - 1]);
            for (std::size_t k = 0; k + 1 < n; ++k) {
                row[k] = plus(row[k], minus(row[k + 1], row[k]), 0.5);
            }
        }
        std::reverse(right.begin(), right.end());
        add(left, depth - 1);
        add(right, depth - 1);
    };
    for (const auto &controls : tested.segments) {
        add(controls, 9);
    }
    const double length = tested.curve.length();
    test.at_most(least - 1e-11, length, "the length of chords, beside the curve's");
    test.at_most(length, most + 1e-11, "the length, beside the control polygon's");
    std::vector<double> sought;
    for (int k = 0; k < 9; ++k) {
        sought.push_back(length * test.random.unit());
    }
    const auto places = tested.curve.places_at(sought);
    const auto again = tested.curve.lengths_at(places);
    for (std::size_t k = 0; k < sought.size(); ++k) {
        test.at_most(std::abs(again[k] - sought[k]), 1e-10 * (1 + length), "the error of an arc length");
    }
}

void check_nearest(Case &test, const Tested &tested) {
    std::vector<Point> queries;
    for (int k = 0; k < 12; ++k) {
        const double half = tested.lattice ? 5 : 1.3;
        Point p{test.random.real(-half, half), test.random.real(-half, half), test.random.real(-half, half)};
        if (tested.lattice && test.random.one_in(2)) {
            p = {std::round(p[0]), std::round(p[1]), std::round(p[2])};
        }
        queries.push_back(p);
    }
    const auto found = tested.curve.nearest(queries);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const auto distance = [&](std::size_t s, double t) { return size(minus(at(tested.segments[s], t), queries[k])); };
        test.at_most(std::abs(distance(found[k].place.segment, found[k].place.t) - found[k].distance), 1e-12, "the error of a distance");
        for (std::size_t s = 0; s < tested.segments.size(); ++s) {
            double best = 1e9, where = 0;
            for (uint32_t i = 0; i <= samples; ++i) {
                const double d = distance(s, double(i) / samples);
                if (d < best) {
                    best = d;
                    where = double(i) / samples;
                }
            }
            // And about the best sample.
            double low = std::max(0.0, where - 1.0 / samples), high = std::min(1.0, where + 1.0 / samples);
            for (int step = 0; step < 60; ++step) {
                const double a = low + (high - low) / 3, b = high - (high - low) / 3;
                (distance(s, a) < distance(s, b) ? high : low) = distance(s, a) < distance(s, b) ? b : a;
            }
            test.at_most(found[k].distance, std::min(best, distance(s, low)) + 1e-12, "a distance, beside that of a sample");
        }
    }
}

void check_crossings(Case &test, const Tested &tested, bool plane) {
    Random &random = test.random;
    for (int k = 0; k < 4; ++k) {
        Point origin{random.real(-0.7, 0.7), random.real(-0.7, 0.7), plane ? 0.0 : random.real(-0.7, 0.7)};
        Point normal{random.real(-1, 1), random.real(-1, 1), plane ? 0.0 : random.real(-1, 1)};
        if (tested.lattice) {
            // Through control points, along lattice directions.
            origin = random.any(random.any(tested.segments));
            normal = {double(random.below(5)) - 2, double(random.below(5)) - 2, plane ? 0.0 : double(random.below(5)) - 2};
        }
        if (size(normal) < 0.1) {
            normal = {1, 0, 0};
        }
        const double unit = size(normal);
        const auto height = [&](std::size_t s, double t) { return dot(minus(at(tested.segments[s], t), origin), normal) / unit; };
        const double noise = 1e-10;
        const gusset::Places by_plane = tested.curve.intersect_plane(origin, normal);
        check_roots(test, tested, height, by_plane, noise, !tested.lattice);
        if (plane) {
            const gusset::Line line = gusset::Line::line(origin, {-normal[1], normal[0], 0});
            const gusset::Places by_line = tested.curve.intersect_line(line);
            check_roots(test, tested, height, by_line, noise, !tested.lattice);
            if (by_plane.inside().empty()) {
                test.equal(by_line.size(), by_plane.size(), "places by a line and by its plane");
            } else {
                // One that is a point is a place.
                test.check(!by_line.overlaps().empty() || by_line.size() > by_plane.size(), "a segment in a line is not found");
            }
        }
        const double angle = tested.lattice && random.one_in(2) ? random.below(5) * M_PI / 4 : random.real(0.2, 2.9);
        const gusset::Places tangents = tested.curve.tangents_at_angle(normal, angle);
        const auto turn = [&](std::size_t s, double t) {
            const Point d = derivative(tested.segments[s], t);
            const double cosine = dot(d, normal) / unit / std::max(size(d), 1e-300);
            return size(d) < 1e-7 ? 0.0 : cosine - std::cos(angle);
        };
        check_roots(test, tested, turn, tangents, 1e-6, false);
    }
}

/// Crossings of two plane segments by Newton's method from where their polylines cross; pairs of
/// global parameters.
struct Crossing {
    double s, t;
};
std::vector<Crossing> crossings(const std::vector<Point> &a, std::size_t number_a, const std::vector<Point> &b, std::size_t number_b) {
    constexpr int parts = 64;
    std::vector<Point> p, q;
    for (int k = 0; k <= parts; ++k) {
        p.push_back(at(a, double(k) / parts));
        q.push_back(at(b, double(k) / parts));
    }
    const auto side = [](const Point &u, const Point &v, const Point &w) { return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]); };
    std::vector<Crossing> found;
    for (int i = 0; i < parts; ++i) {
        for (int j = 0; j < parts; ++j) {
            if ((side(p[i], p[i + 1], q[j]) < 0) == (side(p[i], p[i + 1], q[j + 1]) < 0) || (side(q[j], q[j + 1], p[i]) < 0) == (side(q[j], q[j + 1], p[i + 1]) < 0)) {
                continue;
            }
            double s = (i + 0.5) / parts, t = (j + 0.5) / parts, off = 1, slope = 0;
            for (int step = 0; step < 30; ++step) {
                const Point gap = minus(at(b, t), at(a, s)), da = derivative(a, s), db = derivative(b, t);
                const double area = da[0] * db[1] - da[1] * db[0];
                off = size(gap);
                slope = std::abs(area) / std::max(size(da) * size(db), 1e-300);
                if (slope < 1e-3) {
                    break; // Nearly along each other: not well defined by samples.
                }
                s += (gap[0] * db[1] - gap[1] * db[0]) / area;
                t += (gap[0] * da[1] - gap[1] * da[0]) / area;
            }
            const bool inside = s > 1e-6 && s < 1 - 1e-6 && t > 1e-6 && t < 1 - 1e-6;
            if (inside && slope >= 1e-3 && off < 1e-12) {
                found.push_back({double(number_a) + s, double(number_b) + t});
            }
        }
    }
    return found;
}

void check_pairs(Case &test, const Tested &a, const Tested &b, const gusset::Places &found, bool own) {
    const auto places = found.places(), others = found.others();
    test.equal(others.size(), places.size(), "places on the other curve");
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Point p = at(a.segments[places[k].segment], places[k].t), q = at(b.segments[others[k].segment], others[k].t);
        test.at_most(size(minus(p, q)), 1e-9, "the distance of the two places of an intersection");
        test.at_most(size(minus(p, found.points()[k])), 1e-9, "the distance of the point of an intersection from its place");
        for (std::size_t i = 0; i < k && !a.lattice; ++i) {
            test.check(std::abs(global(places[k]) - global(places[i])) > 1e-9 || std::abs(global(others[k]) - global(others[i])) > 1e-9,
                       "an intersection is found twice");
        }
    }
    if (found.undecided() || !found.overlaps().empty()) {
        test.note("curves that run along each other, or are undecided");
        return;
    }
    for (std::size_t s = 0; s < a.segments.size(); ++s) {
        for (std::size_t t = own ? s : 0; t < b.segments.size(); ++t) {
            for (const Crossing &crossing : crossings(a.segments[s], s, b.segments[t], t)) {
                if (own && std::abs(crossing.s - crossing.t) < 1e-4) {
                    continue;
                }
                const auto here = [&](const Place &first, const Place &second, double u, double v) {
                    return near(a, first, u - 1e-6, u + 1e-6) && near(b, second, v - 1e-6, v + 1e-6);
                };
                bool listed = false;
                for (std::size_t k = 0; k < places.size(); ++k) {
                    listed = listed || here(places[k], others[k], crossing.s, crossing.t) || (own && here(places[k], others[k], crossing.t, crossing.s));
                }
                test.check(listed, own ? "a crossing of a curve with itself is not found" : "a crossing of two curves is not found");
            }
        }
    }
}

/// Places where the distance of two curves is least, by samples and descent.
void check_near_misses(Case &test, const Tested &a, const Tested &b) {
    const double within = test.random.real(0.05, 0.4);
    const gusset::Places found = a.curve.intersect(b.curve, within);
    const auto places = found.places(), others = found.others();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Point p = at(a.segments[places[k].segment], places[k].t), q = at(b.segments[others[k].segment], others[k].t);
        test.at_most(size(minus(p, q)), within + rounding, "the distance at a near miss");
    }
    if (found.undecided() || !found.overlaps().empty()) {
        test.note("curves in space that run along each other, or are undecided");
        return;
    }
    // The nearest pair of each two segments, as an interior minimum, is one of those found.
    for (std::size_t s = 0; s < a.segments.size(); ++s) {
        for (std::size_t t = 0; t < b.segments.size(); ++t) {
            double best = 1e9, u = 0, v = 0;
            constexpr int parts = 40;
            std::vector<Point> p, q;
            for (int i = 0; i <= parts; ++i) {
                p.push_back(at(a.segments[s], double(i) / parts));
                q.push_back(at(b.segments[t], double(i) / parts));
            }
            for (int i = 0; i <= parts; ++i) {
                for (int j = 0; j <= parts; ++j) {
                    if (size(minus(p[i], q[j])) < best) {
                        best = size(minus(p[i], q[j]));
                        u = double(i) / parts, v = double(j) / parts;
                    }
                }
            }
            // By turns: each step is shorter.
            for (double step = 1.0 / parts; step > 1e-9;) {
                bool better = false;
                for (const auto &[du, dv] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}, {1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}}) {
                    const double x = u + du * step, y = v + dv * step;
                    if (x >= 0 && x <= 1 && y >= 0 && y <= 1) {
                        const double d = size(minus(at(a.segments[s], x), at(b.segments[t], y)));
                        if (d < best) {
                            best = d, u = x, v = y, better = true;
                        }
                    }
                }
                step *= better ? 1 : 0.5;
            }
            const bool inside = u > 1e-3 && u < 1 - 1e-3 && v > 1e-3 && v < 1 - 1e-3;
            if (!inside || best > within * (1 - 1e-6)) {
                continue;
            }
            bool listed = false;
            for (std::size_t k = 0; k < places.size(); ++k) {
                listed = listed || (std::abs(global(places[k]) - double(s) - u) < 1e-2 && std::abs(global(others[k]) - double(t) - v) < 1e-2);
            }
            test.note("near misses compared");
            test.check(listed, "a least distance of two curves is not found");
        }
    }
}

void check_parts(Case &test, const Tested &tested) {
    Random &random = test.random;
    const Place place = gusset::place(random.below(tested.segments.size()), random.unit());
    const auto n = static_cast<uint32_t>(tested.segments.size());
    const Curve before = tested.curve.part(gusset::place(0, 0), place), after = tested.curve.part(place, gusset::place(n - 1, 1));
    test.at_most(std::abs(before.length() + after.length() - tested.curve.length()), 1e-10 * (1 + tested.curve.length()), "the error of the lengths of parts");
    const Curve back = tested.curve.reversed(), raised = tested.curve.with_degrees(7, 64).curve;
    const Point p = at(tested.segments[place.segment], place.t);
    test.at_most(size(minus(back.point(gusset::place(n - 1 - place.segment, 1 - place.t)), p)), 1e-12, "the error of a point of the reversed curve");
    test.at_most(size(minus(raised.point(place), p)), 1e-12, "the error of a point of the elevated curve");
    const Point end = before.controls()[before.controls().size() - 1], start = after.controls()[0];
    test.at_most(std::max(size(minus(end, p)), size(minus(start, p))), 1e-12, "the error of the ends of parts");
}
} // namespace
} // namespace of_curves

void curves(Case &test) {
    using namespace of_curves;
    const bool plane = test.random.one_in(2), lattice = test.random.one_in(4);
    const Tested a = random_curve(test.random, plane, lattice), b = random_curve(test.random, plane, lattice);
    check_values(test, a);
    check_lengths(test, a);
    check_nearest(test, a);
    check_crossings(test, a, plane);
    check_parts(test, a);
    if (plane) {
        check_pairs(test, a, b, a.curve.intersect(b.curve), false);
        check_pairs(test, a, a, a.curve.self_intersections(), true);
    } else {
        check_near_misses(test, a, b);
    }
}
} // namespace campaign
