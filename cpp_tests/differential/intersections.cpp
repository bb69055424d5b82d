// Pairs of triangles that intersect, as stitches and fills report them, against CGAL's.
#include "../cpp/judge.hpp"
#include "rims.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace campaign {
namespace of_intersections {
namespace {
using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

/// Coordinates of a coarse lattice, so that much is in one plane, or touches; each point apart from
/// the others.
void to_lattice(Soup &soup, double step) {
    std::set<Point> taken;
    for (Point &p : soup.points) {
        for (double &x : p) {
            x = step * std::round(x / step);
        }
        while (!taken.insert(p).second) {
            p[2] += step;
        }
    }
}

bool in_one_place(const gusset::MeshView &mesh) {
    std::set<Point> taken;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (!taken.insert(mesh.position(v)).second) {
            return true;
        }
    }
    return false;
}

/// True if all corners of some triangle are in one line; exact for lattices, where CGAL's answer
/// is not defined.
bool has_flat_triangle(const gusset::MeshView &mesh) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        const Point a = mesh.position(face[0]), b = mesh.position(face[1]), c = mesh.position(face[2]);
        double largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            largest = std::max(largest, std::abs((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])));
        }
        if (largest < 1e-14) {
            return true;
        }
    }
    return false;
}

void compare(Case &test, const gusset::MeshView &mesh, std::size_t first, std::size_t count, const std::optional<gusset::Indices> &list) {
    if (!test.check(list.has_value(), "intersections are not reported")) {
        return;
    }
    if (in_one_place(mesh) || has_flat_triangle(mesh)) {
        test.note("points in one place or flat triangles, which are not compared");
        return;
    }
    Pairs ours;
    for (std::size_t k = 0; k + 1 < list->size(); k += 2) {
        test.check((*list)[k] > (*list)[k + 1], "the first face of a pair is not the larger one");
        ours.insert({(*list)[k], (*list)[k + 1]});
    }
    test.check(2 * ours.size() == list->size(), "a pair is reported twice");
    const Pairs theirs = intersecting_pairs(mesh, first, count);
    if (!theirs.empty()) {
        test.note("results that cut themselves");
    }
    test.equal(ours.size(), theirs.size(), "pairs that intersect");
    for (const auto &pair : theirs) {
        test.check(ours.count(pair) == 1, "a pair that CGAL finds is not reported");
    }
    for (const auto &pair : ours) {
        test.check(theirs.count(pair) == 1, "a pair that is reported is none for CGAL");
    }
}

void stitches(Case &test) {
    Random &random = test.random;
    Rims rims = random_rims(random, true);
    if (random.one_in(3)) {
        Soup both = together({rims.a, rims.b});
        to_lattice(both, random.one_in(2) ? 0.25 : 0.125);
        std::copy_n(both.points.begin(), rims.a.points.size(), rims.a.points.begin());
        std::copy(both.points.begin() + static_cast<long>(rims.a.points.size()), both.points.end(), rims.b.points.begin());
    }
    gusset::StitchOptions options = random_stitch_options(random);
    options.intersections = gusset::Intersections::report;
    try {
        const gusset::Stitch stitch = gusset::stitch(rims.a.view(), rims.rim_a, rims.b.view(), rims.rim_b, options);
        const auto [first, count] = stitch.strip_faces();
        compare(test, stitch.mesh(), first, count, stitch.intersections());
    } catch (const gusset::Error &error) {
        test.check(error.status() == GUSSET_ERROR_NO_STRIP, error.what());
        test.note("stitches without a strip");
    }
}

void fills(Case &test) {
    Random &random = test.random;
    Soup soup = cut_to_triangles(random_shape(random, static_cast<Shape>(random.below(4))), random, 1);
    soup = compact(with_holes(soup, random));
    if (!judge(soup.view(), false).is_mesh) {
        test.note("holes that touch, which are not compared");
        return;
    }
    if (random.one_in(3)) {
        to_lattice(soup, random.one_in(2) ? 0.25 : 0.125);
    }
    gusset::FillOptions options = random_fill_options(random);
    options.intersections = gusset::Intersections::report;
    const gusset::Fill fill(soup.view(), options);
    if (!judge(fill.mesh(), false).is_mesh) {
        test.check(false, "a mesh with its holes filled is none for CGAL");
        return;
    }
    compare(test, fill.mesh(), soup.face_count(), fill.mesh().face_count() - soup.face_count(), fill.intersections());
}
} // namespace
} // namespace of_intersections

void intersections(Case &test) { test.random.one_in(2) ? of_intersections::stitches(test) : of_intersections::fills(test); }
} // namespace campaign
