// Results of stitching, filling and assembling: valid by CGAL, with the
// characteristic that Euler's formula asks for, and with all that was there as it was.
#include "../cpp/judge.hpp"
#include "repairs.hpp"
#include "rims.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace campaign {
namespace of_validity {
namespace {
using Lengths = std::vector<std::size_t>;

/// The length of each boundary cycle of `before` except the rims, in CGAL's order.
Lengths without_rims(Lengths before, const std::vector<std::size_t> &rims) {
    for (std::size_t rim : rims) {
        const auto at = std::find(before.begin(), before.end(), rim);
        if (at != before.end()) {
            before.erase(at);
        }
    }
    std::sort(before.begin(), before.end(), std::greater<>());
    return before;
}

void stitched(Case &test) {
    Random &random = test.random;
    Rims rims = random_rims(random, false);
    gusset::StitchOptions options = random_stitch_options(random);
    options.intersections = static_cast<gusset::Intersections>(random.below(3));
    options.cells = random.one_in(2) ? gusset::StripCells::quads : gusset::StripCells::triangles;
    options.outward = random.one_in(2) ? gusset::Outward::closed : gusset::Outward::keep;
    const bool against = random.one_in(4);
    if (against) {
        rims.b = inside_out(rims.b);
    }
    const Verdict a = judge(rims.a.view(), false), b = judge(rims.b.view(), false);
    std::optional<gusset::Stitch> made;
    try {
        made.emplace(gusset::stitch(rims.a.view(), rims.rim_a, rims.b.view(), rims.rim_b, options));
    } catch (const gusset::Error &error) {
        test.check(error.status() == GUSSET_ERROR_NO_STRIP, error.what());
        test.note("stitches without a strip");
        return;
    }
    const gusset::MeshView mesh = made->mesh();
    const Verdict verdict = judge(mesh, false);
    if (!test.check(verdict.is_mesh, "a stitched mesh is none for CGAL")) {
        return;
    }
    test.equal(verdict.euler, a.euler + b.euler, "Euler's characteristic of a stitch");
    test.equal(verdict.components, 1u, "components of a stitch");
    Lengths ends = a.boundary;
    ends.insert(ends.end(), b.boundary.begin(), b.boundary.end());
    test.check(verdict.boundary == without_rims(ends, {rims.rim_a.size(), rims.rim_b.size()}), "the loops of a stitch are not the other ends of its pieces");
    const auto quality = made->quality();
    test.equal(quality.loops_left, verdict.boundary.size(), "loops left by a stitch");
    test.check(quality.non_manifold_edges == 0 && quality.orientation_conflicts == 0, "a stitch reports a bad edge");
    const gusset::Indices outwards = made->turned_outwards();
    const std::set<uint32_t> over(outwards.begin(), outwards.end());
    bool bits = true, faces = true;
    for (int side = 0; side < 2; ++side) {
        const Soup &soup = side == 0 ? rims.a : rims.b;
        const gusset::Indices vertices = made->vertex_map(side), map = made->face_map(side);
        for (std::size_t v = 0; v < soup.points.size(); ++v) {
            bits = bits && mesh.position(vertices[v]) == soup.points[v];
        }
        for (std::size_t f = 0; f < soup.face_count(); ++f) {
            std::vector<uint32_t> face;
            for (uint32_t v : soup.view().face(f)) {
                face.push_back(vertices[v]);
            }
            faces = faces && same_face(face, face_of(mesh, map[f]), (side == 1 && made->turned()) != (over.count(map[f]) != 0));
        }
    }
    test.check(bits, "an old vertex of a stitch has other bits");
    test.check(faces, "an old face of a stitch is another");
    if (options.outward == gusset::Outward::closed) {
        check_outward(test, mesh, verdict);
    }
}

void filled(Case &test) {
    Random &random = test.random;
    Soup soup = cut_to_triangles(random_shape(random, static_cast<Shape>(random.below(4))), random, random.below(3) / 2.0);
    soup = with_holes(soup, random);
    if (random.one_in(4)) {
        soup = together({soup, with_holes(random_shape(random, Shape::tube), random)});
    }
    const Verdict before = judge(soup.view(), false);
    gusset::FillOptions options = random_fill_options(random);
    options.intersections = static_cast<gusset::Intersections>(random.below(3));
    options.keep = static_cast<gusset::FillKeep>(random.below(3));
    options.outward = random.one_in(2) ? gusset::Outward::closed : gusset::Outward::keep;
    options.max_edges = random.one_in(4) ? random.between(3, 12) : 0;
    const gusset::Fill fill(soup.view(), options);
    const gusset::MeshView mesh = fill.mesh();
    const gusset::Indices outwards = fill.turned_outwards();
    const std::set<uint32_t> over(outwards.begin(), outwards.end());
    bool bits = true, faces = true;
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        bits = bits && mesh.position(v) == soup.points[v];
    }
    std::set<std::pair<uint32_t, uint32_t>> near, old;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const std::vector<uint32_t> face = face_of(soup.view(), f);
        faces = faces && same_face(face, face_of(mesh, f), over.count(static_cast<uint32_t>(f)) != 0);
        for (std::size_t i = 0; i < face.size(); ++i) {
            old.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
            for (uint32_t v : face) {
                near.insert(std::minmax(face[i], v));
            }
        }
    }
    test.check(bits, "an old vertex of a filled mesh has other bits");
    test.check(faces, "an old face of a filled mesh is another");
    bool diagonal = false;
    for (std::size_t f = soup.face_count(); f < mesh.face_count(); ++f) {
        const std::vector<uint32_t> face = face_of(mesh, f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::pair<uint32_t, uint32_t> edge = std::minmax(face[i], face[(i + 1) % face.size()]);
            diagonal = diagonal || (near.count(edge) != 0 && old.count(edge) == 0);
        }
    }
    test.check(!diagonal, "a new edge joins two vertices of one old face");
    // A patch of k rims is a sphere with k holes: its characteristic is 2 - k.
    std::map<uint32_t, std::pair<long, std::size_t>> patches;
    std::map<uint32_t, const gusset_hole *> of_patch;
    for (const gusset_hole &hole : fill.holes()) {
        if (hole.status == GUSSET_HOLE_FILLED) {
            patches[hole.patch].first += 1;
            patches[hole.patch].second += hole.rim_count;
            of_patch[hole.patch] = &hole;
        } else {
            test.check(hole.face_count == 0, "a hole that is left has faces");
        }
    }
    long gained = 0;
    std::size_t made = 0;
    for (const auto &[patch, rims] : patches) {
        const long euler = 2 - rims.first;
        gained += euler;
        made += of_patch[patch]->face_count;
        test.equal(static_cast<long>(of_patch[patch]->face_count),
                   2 * static_cast<long>(of_patch[patch]->vertex_count) + static_cast<long>(rims.second) - 2 * euler, "faces of a patch");
    }
    test.equal(mesh.face_count(), soup.face_count() + made, "faces of a filled mesh");
    const Counts was = count(soup.view()), is = count(mesh);
    test.equal(is.euler(), was.euler() + gained, "Euler's characteristic of a filled mesh");
    test.equal(is.branches, was.branches, "edges of three faces and more");
    if (!before.is_mesh) {
        test.note("holes that touch");
        return;
    }
    const Verdict after = judge(mesh, false);
    if (test.check(after.is_mesh, "a mesh with its holes filled is none for CGAL")) {
        test.equal(fill.quality().loops_left, after.boundary.size(), "loops left by filling");
        const auto left = std::count_if(fill.holes().begin(), fill.holes().end(), [](const gusset_hole &hole) { return hole.status != GUSSET_HOLE_FILLED; });
        test.equal(after.boundary.size(), static_cast<std::size_t>(left), "loops, and holes that are left");
        test.equal(fill.holes().size(), before.boundary.size(), "holes");
        if (options.outward == gusset::Outward::closed) {
            check_outward(test, mesh, after);
        }
    }
}

/// Pieces of a shape by random planes, each with vertices of its own, drawn a little towards its
/// middle.
std::vector<Soup> cut_by_planes(const Soup &whole, Random &random, double shrink) {
    const auto faces = faces_of(whole);
    std::vector<uint32_t> colours(faces.size());
    for (uint32_t plane = 0, planes = random.between(1, 2); plane < planes; ++plane) {
        const Point normal{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
        const double height = random.real(-0.2, 0.2);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            double sum = 0;
            for (uint32_t v : faces[f]) {
                sum += (whole.points[v][0] * normal[0] + whole.points[v][1] * normal[1] + whole.points[v][2] * normal[2]) / double(faces[f].size());
            }
            colours[f] |= (sum > height ? 1u : 0u) << plane;
        }
    }
    std::vector<Soup> pieces;
    for (uint32_t colour = 0; colour < 4; ++colour) {
        Soup piece = compact(without(whole, [&](std::size_t f) { return colours[f] != colour; }));
        if (piece.face_count() == 0) {
            continue;
        }
        Point middle{};
        for (const Point &p : piece.points) {
            for (std::size_t k = 0; k < 3; ++k) {
                middle[k] += p[k] / double(piece.points.size());
            }
        }
        for (Point &p : piece.points) {
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] += shrink * (middle[k] - p[k]);
            }
        }
        pieces.push_back(piece);
    }
    return pieces;
}

void assembled(Case &test) {
    Random &random = test.random;
    const Soup whole = cut_to_triangles(random_shape(random, static_cast<Shape>(random.below(4))), random, random.below(3) / 2.0);
    std::vector<Soup> pieces = cut_by_planes(whole, random, random.one_in(3) ? 0.0 : random.real(0.005, 0.08));
    for (Soup &piece : pieces) {
        if (random.one_in(3)) {
            piece = inside_out(piece);
        }
    }
    gusset::JoinOptions options;
    options.strip_options = random_stitch_options(random);
    options.strip_options.twist = 0;
    options.strip_options.cells = random.one_in(2) ? gusset::StripCells::quads : gusset::StripCells::triangles;
    options.weld = random.one_in(3) ? gusset::Welding::edge_to_edge : gusset::Welding::sew;
    const gusset::JoinExtent extents[] = {gusset::JoinExtent::loops_and_parts, gusset::JoinExtent::whole_loops,
                                          gusset::JoinExtent::parts};
    options.extent = extents[random.below(3)];
    options.within_components = random.one_in(3);
    options.outward = random.one_in(3) ? gusset::Outward::keep : gusset::Outward::closed;
    if (random.one_in(2)) {
        options.fill = true;
        options.fill_options = random_fill_options(random);
    }
    std::vector<gusset::MeshView> views;
    bool manifold = true;
    for (const Soup &piece : pieces) {
        views.push_back(piece.view());
        manifold = manifold && judge(piece.view(), false).is_mesh;
    }
    const gusset::Join done(views, options);
    const gusset::MeshView mesh = done.mesh();
    const gusset_join_report parts = done.report();
    std::vector<int> faces(mesh.face_count()), vertices(mesh.vertex_count());
    bool bits = true;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const gusset_piece_map map = done.pieces()[k];
        test.equal(map.faces.count, pieces[k].face_count(), "faces of a piece");
        for (std::size_t v = 0; v < map.vertices.count; ++v) {
            vertices[map.vertices.data[v]] = 1;
            // Sewing keeps the bits of one of those that it joins.
            bits = bits && (parts.welded_vertices > 0 || mesh.position(map.vertices.data[v]) == pieces[k].points[v]);
        }
        for (std::size_t f = 0; f < map.faces.count; ++f) {
            faces[map.faces.data[f]] += 1;
        }
    }
    test.check(bits, "an old vertex of an assembly has other bits");
    const auto made = [&](std::size_t first_v, std::size_t count_v, std::size_t first_f, std::size_t count_f) {
        std::for_each_n(vertices.begin() + static_cast<long>(first_v), count_v, [](int &n) { ++n; });
        std::for_each_n(faces.begin() + static_cast<long>(first_f), count_f, [](int &n) { ++n; });
    };
    for (const gusset_joint &joint : done.joints()) {
        made(joint.vertex_first, joint.vertex_count, joint.face_first, joint.face_count);
        test.check((joint.outcome == GUSSET_JOINT_JOINED) == (joint.face_count > 0), "a joint has faces and is not joined, or the other way round");
    }
    std::set<uint32_t> patches;
    for (const gusset_hole &hole : done.holes()) {
        if (hole.status == GUSSET_HOLE_FILLED && patches.insert(hole.patch).second) {
            made(hole.vertex_first, hole.vertex_count, hole.face_first, hole.face_count);
        }
    }
    const auto once = [](int n) { return n == 1; };
    test.check(std::all_of(faces.begin(), faces.end(), once), "a face of an assembly is of no part, or of two");
    test.check(std::all_of(vertices.begin(), vertices.end(), once), "a vertex of an assembly is of no part, or of two");
    test.check(parts.non_manifold_edges == 0, "an assembly has an edge of three faces");
    if (!manifold) {
        test.note("pieces that touch themselves");
        return;
    }
    const Verdict verdict = judge(mesh, false);
    if (test.check(verdict.is_mesh, "an assembly is no mesh for CGAL")) {
        test.equal(parts.loops_left, verdict.boundary.size(), "loops left by an assembly");
        if (options.outward == gusset::Outward::closed) {
            check_outward(test, mesh, verdict);
        }
    }
}
} // namespace
} // namespace of_validity

void validity(Case &test) {
    using namespace of_validity;
    switch (test.random.below(6)) {
    case 0: return stitched(test);
    case 1: return filled(test);
    case 2: return assembled(test);
    case 3: return welded(test);
    case 4: return sewn(test);
    default: return oriented(test);
    }
}
} // namespace campaign
