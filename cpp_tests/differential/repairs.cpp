// Results of welding, sewing and orienting: valid by CGAL, and as few changes as union-find with
// parity says.
#include "repairs.hpp"
#include "pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace campaign::of_validity {
std::vector<uint32_t> face_of(const gusset::MeshView &mesh, std::size_t f) { return {mesh.face(f).begin(), mesh.face(f).end()}; }

bool same_face(const std::vector<uint32_t> &was, std::vector<uint32_t> is, bool turned) {
    if (turned) {
        std::reverse(is.begin() + 1, is.end());
    }
    return was == is;
}

void check_outward(Case &test, const gusset::MeshView &mesh, const Verdict &verdict) {
    if (verdict.closed && verdict.components == 1) {
        const Verdict whole = judge(mesh);
        if (whole.self_intersections == 0) {
            test.note("closed results, outwards");
            test.check(whole.bounds_a_volume, "a closed result that does not cut itself does not face outwards");
        }
    }
}

namespace {
using Lengths = std::vector<std::size_t>;

/// Every face with vertices of its own, in another order, some turned over.
Soup shattered(const Soup &soup, Random &random, bool turn) {
    Soup pieces;
    for (std::vector<uint32_t> face : faces_of(soup)) {
        for (uint32_t &v : face) {
            pieces.points.push_back(soup.points[v]);
            v = static_cast<uint32_t>(pieces.points.size() - 1);
        }
        if (turn && random.one_in(2)) {
            std::reverse(face.begin(), face.end());
        }
        pieces.add_face(face);
    }
    std::vector<uint32_t> place(pieces.points.size());
    std::iota(place.begin(), place.end(), 0u);
    random.shuffle(place);
    Soup mixed = pieces;
    for (uint32_t v = 0; v < place.size(); ++v) {
        mixed.points[place[v]] = pieces.points[v];
    }
    for (uint32_t &v : mixed.corners) {
        v = place[v];
    }
    return shuffled(mixed, random);
}

/// Sides that faces have for each component, by union-find with parity.
struct Parity {
    std::vector<uint32_t> parent, side;
    explicit Parity(std::size_t n) : parent(n), side(n) { std::iota(parent.begin(), parent.end(), 0u); }
    std::pair<uint32_t, uint32_t> root(uint32_t f) const {
        uint32_t turned = 0;
        for (; parent[f] != f; f = parent[f]) {
            turned ^= side[f];
        }
        return {f, turned};
    }
};

} // namespace

void welded(Case &test) {
    Random &random = test.random;
    const Soup whole = compact(with_holes(cut_to_triangles(random_shape(random, static_cast<Shape>(random.below(4))), random, random.below(3) / 2.0), random));
    const Verdict before = judge(whole.view(), false);
    if (!before.is_mesh) {
        test.note("holes that touch");
        return;
    }
    gusset::WeldOptions options;
    options.vertices = random.one_in(2) ? gusset::WeldVertices::all : gusset::WeldVertices::boundary;
    Soup pieces = shattered(whole, random, true);
    const bool noise = random.one_in(3);
    for (Point &p : pieces.points) {
        for (double &x : p) {
            x += noise ? random.real(-1e-7, 1e-7) : 0.0;
        }
    }
    if (noise) {
        options.tolerance = 1e-6;
    }
    const gusset::Weld weld(pieces.view(), options);
    gusset::OrientOptions outwards;
    outwards.outward = gusset::Outward::closed;
    const gusset::Orient orient(weld.mesh(), outwards);
    test.check(weld.left_edges().empty() && weld.dropped_faces() == 0, "an edge is left, or a face is lost");
    test.equal(orient.mesh().face_count(), whole.face_count(), "faces that were welded");
    const Verdict after = judge(orient.mesh(), false);
    if (test.check(after.is_mesh, "single faces welded and oriented are no mesh for CGAL")) {
        test.equal(count(orient.mesh()).vertices, whole.points.size(), "vertices that were welded");
        test.equal(after.euler, before.euler, "Euler's characteristic of what was welded");
        test.equal(after.components, before.components, "components of what was welded");
        test.check(after.boundary == before.boundary, "the loops of what was welded are others");
        check_outward(test, orient.mesh(), after);
    }
    bool bits = true;
    const gusset::Indices map = weld.vertex_map();
    for (std::size_t v = 0; v < map.size() && !noise; ++v) {
        bits = bits && weld.mesh().position(map[v]) == pieces.points[v];
    }
    test.check(bits, "a welded vertex has other bits");
}

/// Two sheets on either side of the line y = 0, whose borders there have different vertices.
void sewn(Case &test) {
    Random &random = test.random;
    std::vector<Soup> sides;
    for (double side : {1.0, -1.0}) {
        std::set<double> places{0, 1};
        for (uint32_t k = random.below(9); k-- > 0;) {
            places.insert(random.between(1, 63) / 64.0);
        }
        const std::vector<double> list(places.begin(), places.end());
        const auto n = static_cast<uint32_t>(list.size() - 1), m = random.between(1, 3);
        Soup soup = grid(n, m, false, false, [&](double s, double t) { return Point{list[static_cast<std::size_t>(std::lround(s * n))], side * t, 0}; });
        sides.push_back(cut_to_triangles(random.one_in(2) ? inside_out(soup) : soup, random, random.below(3) / 2.0));
    }
    const Counts a = count(sides[0].view()), b = count(sides[1].view());
    std::set<double> common;
    std::size_t on_a = 0, on_b = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        for (const Point &p : sides[k].points) {
            if (p[1] == 0) {
                common.insert(p[0]);
                (k == 0 ? on_a : on_b) += 1;
            }
        }
    }
    Soup both = together(sides);
    const auto rotation = random_rotation(random);
    if (random.one_in(2)) {
        move(both, rotation, {0.3, 0.1, -0.2});
    }
    both = shattered(both, random, false);
    const gusset::Sew sew(both.view());
    const gusset::Orient orient(sew.mesh());
    test.equal(sew.sewn_edges() > 0, true, "something sewn");
    test.check(sew.left_vertices().empty(), "a vertex is left unsewn");
    const Verdict after = judge(orient.mesh(), false);
    if (test.check(after.is_mesh, "two sheets sewn are no mesh for CGAL")) {
        test.equal(after.euler, 1, "Euler's characteristic of two sheets sewn");
        test.equal(after.components, 1u, "components of two sheets sewn");
        test.check(after.boundary == Lengths{a.boundary + b.boundary - (on_a - 1) - (on_b - 1)}, "the border of two sheets sewn has not the edges that were free");
        test.equal(count(orient.mesh()).vertices, a.vertices + b.vertices - on_a - on_b + common.size(), "vertices of two sheets sewn");
    }
}

void oriented(Case &test) {
    Random &random = test.random;
    Soup soup = cut_to_triangles(random_shape(random, static_cast<Shape>(random.below(4))), random, random.below(3) / 2.0);
    if (random.one_in(3)) {
        // A strip whose ends are joined, half of them turned over.
        const bool twisted = random.one_in(2);
        const uint32_t n = random.between(3, 12), m = random.between(1, 4);
        soup = grid(n, m, false, false, [&](double s, double t) { return Point{s, t, s * t}; });
        for (uint32_t &v : soup.corners) {
            const uint32_t row = v / (n + 1);
            v = v % (n + 1) == n ? (twisted ? m - row : row) * (n + 1) : v;
        }
    }
    soup = with_holes(soup, random);
    for (uint32_t k = random.one_in(3) ? random.between(1, 5) : 0; k-- > 0;) {
        soup.add_face({random.any(soup.corners), random.any(soup.corners), random.any(soup.corners)});
    }
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        if (random.one_in(3)) {
            turn_face(soup, f);
        }
    }
    const auto faces = faces_of(soup);
    std::map<std::pair<uint32_t, uint32_t>, std::vector<std::pair<uint32_t, bool>>> edges;
    for (uint32_t f = 0; f < faces.size(); ++f) {
        if (std::set<uint32_t>(faces[f].begin(), faces[f].end()).size() != faces[f].size()) {
            test.note("faces that repeat a vertex, which are not compared");
            return;
        }
        for (std::size_t k = 0; k < faces[f].size(); ++k) {
            const uint32_t v = faces[f][k], w = faces[f][(k + 1) % faces[f].size()];
            edges[std::minmax(v, w)].emplace_back(f, v < w);
        }
    }
    Parity sets(faces.size());
    std::set<uint32_t> one_sided;
    std::vector<uint32_t> odd;
    for (const auto &[edge, both] : edges) {
        if (both.size() != 2) {
            continue;
        }
        const auto [p, turned_p] = sets.root(both[0].first);
        const auto [q, turned_q] = sets.root(both[1].first);
        const uint32_t against = (both[0].second == both[1].second ? 1 : 0) ^ turned_p ^ turned_q;
        if (p != q) {
            sets.parent[std::max(p, q)] = std::min(p, q);
            sets.side[std::max(p, q)] = against;
        } else if (against) {
            odd.push_back(p);
        }
    }
    std::map<uint32_t, std::array<std::size_t, 2>> count_of;
    for (uint32_t f = 0; f < faces.size(); ++f) {
        const auto [root, turned] = sets.root(f);
        ++count_of[root][turned];
    }
    for (uint32_t p : odd) {
        one_sided.insert(sets.root(p).first);
    }
    std::size_t fewest = 0;
    for (const auto &[root, sides] : count_of) {
        fewest += one_sided.count(root) != 0 ? 0 : std::min(sides[0], sides[1]);
    }
    const gusset::Orient orient(soup.view());
    test.equal(orient.component_count(), count_of.size(), "components to be oriented");
    test.equal(orient.turned_faces(), fewest, "faces turned over");
    const gusset::Indices listed = orient.one_sided_faces();
    test.check(std::set<uint32_t>(listed.begin(), listed.end()) == one_sided, "the one-sided components are others");
    bool kept = true;
    for (uint32_t f = 0; f < faces.size(); ++f) {
        kept = kept && same_face(faces[f], face_of(orient.mesh(), f), orient.turned()[f] != 0);
        const auto [root, turned] = sets.root(f);
        const auto [other, other_turned] = sets.root(root);
        kept = kept && (one_sided.count(root) != 0 ? orient.turned()[f] == 0
                                                   : (orient.turned()[f] ^ turned) == (orient.turned()[other] ^ other_turned));
    }
    test.check(kept, "faces that share an edge disagree, or a face is another");
    if (one_sided.empty()) {
        test.check(gusset::Check(orient.mesh()).is_oriented(), "what was oriented is not");
    }
    test.check(gusset::Check(soup.view()).is_orientable() == one_sided.empty(), "what can be oriented cannot, or the other way round");
}
} // namespace campaign::of_validity
