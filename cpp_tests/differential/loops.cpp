// Boundary loops of polygon soups, from orderly to wild, against walks by hand from the faces
// alone, OpenMesh and CGAL.
#include "../cpp/host.hpp"
#include "../cpp/judge.hpp"
#include "pieces.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace campaign {
namespace of_loops {
namespace {
using Edge = std::pair<uint32_t, uint32_t>;
using Cycle = std::vector<uint32_t>;

/// The sides of the faces, and which are borders, without a table of the library's.
struct Sides {
    /// For each half-edge: its ends, and its neighbours in the face that are not degenerate. A
    /// face of fewer than three such sides has none.
    std::vector<uint32_t> tail, head, next, previous;
    std::vector<bool> used;
    std::map<Edge, std::vector<uint32_t>> edges;

    explicit Sides(const Soup &soup)
        : tail(soup.corners), head(tail.size()), next(tail.size()), previous(tail.size()), used(tail.size()) {
        for (std::size_t f = 0; f < soup.face_count(); ++f) {
            std::vector<uint32_t> sides;
            for (uint32_t h = soup.offsets[f]; h < soup.offsets[f + 1]; ++h) {
                head[h] = tail[h + 1 < soup.offsets[f + 1] ? h + 1 : soup.offsets[f]];
                if (tail[h] != head[h]) {
                    sides.push_back(h);
                }
            }
            for (std::size_t k = 0; k < sides.size() && sides.size() >= 3; ++k) {
                const uint32_t h = sides[k], after = sides[(k + 1) % sides.size()];
                next[h] = after;
                previous[after] = h;
                used[h] = true;
                edges[std::minmax(tail[h], head[h])].push_back(h);
            }
        }
    }
    const std::vector<uint32_t> &at(uint32_t h) const { return edges.at(std::minmax(tail[h], head[h])); }
    bool is_border(uint32_t h) const { return at(h).size() != 2; }
    bool is_free(uint32_t h) const { return at(h).size() == 1; }
    /// The border beside border h in the fan of faces at its head, or its tail.
    uint32_t beside(uint32_t h, uint32_t v) const {
        for (;;) {
            h = head[h] == v ? next[h] : previous[h];
            const auto &both = at(h);
            if (both.size() != 2) {
                return h;
            }
            h = both[0] == h ? both[1] : both[0];
        }
    }
};

/// The walks with a free edge, each as the set of its half-edges.
std::set<std::set<uint32_t>> walks_by_hand(const Sides &sides) {
    std::set<std::set<uint32_t>> walks;
    std::vector<bool> seen(sides.tail.size());
    for (uint32_t start = 0; start < seen.size(); ++start) {
        if (!sides.used[start] || seen[start] || !sides.is_free(start)) {
            continue;
        }
        std::set<uint32_t> walk;
        uint32_t h = start, to = sides.head[start];
        do {
            seen[h] = true;
            walk.insert(h);
            h = sides.beside(h, to);
            to = sides.head[h] == to ? sides.tail[h] : sides.head[h];
        } while (h != start);
        walks.insert(walk);
    }
    return walks;
}

Soup any_soup(Random &random, uint32_t wildness) {
    if (wildness == 4) {
        // Faces of few vertices, any at all.
        Soup soup;
        const uint32_t n = random.between(3, 12);
        for (uint32_t v = 0; v < n; ++v) {
            soup.points.push_back({random.unit(), random.unit(), random.unit()});
        }
        for (uint32_t f = random.between(1, 24); f-- > 0;) {
            std::vector<uint32_t> face;
            for (uint32_t k = random.between(3, 6); k-- > 0;) {
                face.push_back(random.below(n));
            }
            soup.add_face(face);
        }
        return soup;
    }
    std::vector<Soup> pieces;
    for (uint32_t k = random.between(1, 2); k-- > 0;) {
        pieces.push_back(random_shape(random, static_cast<Shape>(random.below(4))));
    }
    Soup soup = with_holes(cut_to_triangles(together(pieces), random, random.below(3) / 2.0), random);
    const double share = random.one_in(2) ? 0.0 : random.one_in(2) ? 0.03 : random.real(0, 0.5);
    const Soup thinned = without(soup, [&](std::size_t) { return random.unit() < share; });
    soup = thinned.face_count() != 0 ? thinned : soup;
    for (std::size_t f = 0; f < soup.face_count() && wildness >= 1; ++f) {
        if (random.one_in(8)) {
            turn_face(soup, f);
        }
    }
    for (uint32_t k = wildness >= 2 ? random.between(1, 8) : 0; k-- > 0;) {
        // Merges two vertices, whatever the result.
        const uint32_t from = random.any(soup.corners), to = random.any(soup.corners);
        std::replace(soup.corners.begin(), soup.corners.end(), from, to);
    }
    for (uint32_t k = wildness >= 3 ? random.between(1, 5) : 0; k-- > 0;) {
        const auto faces = faces_of(soup);
        std::vector<uint32_t> face = random.any(faces);
        if (random.one_in(2)) {
            face = {random.any(soup.corners), face[0], face[1]};
        }
        soup.add_face(face);
    }
    return soup;
}

/// Each loop is a chain of sides that are borders, and passes each vertex once.
void check_chain(Case &test, const Soup &soup, const Sides &sides, const gusset::Loop &loop) {
    const std::size_t n = loop.half_edges.size();
    test.check(loop.vertices.size() == n + (loop.is_closed() ? 0 : 1), "a loop has not as many vertices as edges");
    test.check(std::set<uint32_t>(loop.vertices.begin(), loop.vertices.end()).size() == loop.vertices.size(), "a loop passes a vertex twice");
    bool chained = true, flagged = true, of_faces = true, border = true;
    for (std::size_t i = 0; i < n; ++i) {
        const uint32_t h = loop.half_edges[i], f = loop.faces[i];
        of_faces = of_faces && soup.offsets[f] <= h && h < soup.offsets[f + 1];
        if (!sides.used[h]) {
            border = false;
            continue;
        }
        Edge edge{sides.tail[h], sides.head[h]};
        if (loop.edge_flags[i] & GUSSET_EDGE_REVERSED) {
            std::swap(edge.first, edge.second);
        }
        chained = chained && edge == Edge{loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]};
        border = border && sides.is_border(h);
        flagged = flagged && sides.is_free(h) == ((loop.edge_flags[i] & GUSSET_EDGE_NON_MANIFOLD) == 0);
    }
    test.check(of_faces, "a half-edge of a loop is not of its face");
    test.check(border, "a loop runs along an edge of two faces");
    test.check(chained, "the edges of a loop are no chain");
    test.check(flagged, "edges of three faces and more are not those that are flagged");
}

void check_against_hand(Case &test, const Soup &soup, const Sides &sides, const gusset::Boundary &boundary) {
    std::map<uint32_t, std::set<uint32_t>> by_walk;
    std::size_t edges = 0, different = 0;
    for (const gusset::Loop loop : boundary) {
        check_chain(test, soup, sides, loop);
        test.check(loop.is_closed(), "a loop is open");
        by_walk[loop.walk].insert(loop.half_edges.begin(), loop.half_edges.end());
        edges += loop.half_edges.size();
    }
    std::set<std::set<uint32_t>> ours;
    for (const auto &[walk, half_edges] : by_walk) {
        ours.insert(half_edges);
        different += half_edges.size();
    }
    test.check(edges == different, "two loops run along the same side of a face");
    test.equal(boundary.walk_count(), ours.size(), "walks");
    test.check(ours == walks_by_hand(sides), "the walks are not those by hand");

    gusset::BoundaryOptions stop;
    stop.non_manifold = gusset::NonManifold::stop;
    std::size_t free = 0, found = 0;
    for (const auto &[edge, half_edges] : sides.edges) {
        free += half_edges.size() == 1;
    }
    const gusset::Boundary chains(soup.view(), stop);
    for (const gusset::Loop loop : chains) {
        check_chain(test, soup, sides, loop);
        for (uint32_t h : loop.half_edges) {
            found += sides.used[h] && sides.is_free(h);
        }
    }
    test.equal(found, free, "edges with one face, in chains that stop");
}

bool has_balanced_branch(const Sides &sides) {
    return std::any_of(sides.edges.begin(), sides.edges.end(), [&](const auto &edge) {
        const auto &all = edge.second;
        const auto up = std::count_if(all.begin(), all.end(), [&](uint32_t h) { return sides.tail[h] == edge.first.first; });
        return all.size() >= 4 && 2 * static_cast<std::size_t>(up) == all.size();
    });
}

void check_against_openmesh(Case &test, const Soup &soup, const gusset::Boundary &boundary) {
    const auto host = host_mesh(soup);
    if (!host) {
        return;
    }
    test.note("meshes that OpenMesh took");
    const auto from_smallest = [](Cycle cycle) {
        std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
        return cycle;
    };
    std::multiset<Cycle> ours, theirs;
    std::set<uint32_t> passed;
    for (const gusset::Loop loop : boundary) {
        // OpenMesh has the hole on the left.
        Cycle cycle(loop.vertices.begin(), loop.vertices.end());
        std::reverse(cycle.begin(), cycle.end());
        ours.insert(from_smallest(cycle));
    }
    for (const Cycle &cycle : walks(*host)) {
        for (uint32_t v : cycle) {
            // At such a vertex OpenMesh goes across the gap to another fan, and not round its own.
            if (!passed.insert(v).second) {
                return;
            }
        }
        theirs.insert(from_smallest(cycle));
    }
    test.note("loops compared with OpenMesh's");
    test.check(ours == theirs, "the loops are not those of OpenMesh");
}

void check_against_cgal(Case &test, const Soup &soup, const gusset::Boundary &boundary) {
    const Verdict verdict = judge(soup.view(), false);
    if (!verdict.is_mesh) {
        return;
    }
    test.note("meshes that CGAL took");
    std::vector<std::size_t> lengths(boundary.walk_count());
    for (const gusset::Loop loop : boundary) {
        lengths[loop.walk] += loop.half_edges.size();
    }
    std::sort(lengths.begin(), lengths.end(), std::greater<>());
    test.check(lengths == verdict.boundary, "the lengths of the loops are not those of CGAL");
    const gusset::Check check(soup.view());
    test.equal(check.view().euler, verdict.euler, "Euler's characteristic");
    test.equal(check.view().component_count, verdict.components, "components");
    test.check(check.is_manifold() && check.is_oriented(), "a mesh of CGAL is not manifold and oriented");
    test.check(check.is_closed() == verdict.closed, "what is closed for CGAL is not, or the other way round");
}
} // namespace
} // namespace of_loops

void loops(Case &test) {
    using namespace of_loops;
    const Soup soup = shuffled(any_soup(test.random, test.random.below(5)), test.random);
    const gusset::Boundary boundary(soup.view());
    const Sides sides(soup);
    check_against_hand(test, soup, sides, boundary);
    gusset::BoundaryOptions only;
    only.survey = gusset::Survey::boundary_only;
    const gusset::Boundary fast(soup.view(), only);
    bool same = fast.size() == boundary.size();
    for (std::size_t i = 0; i < boundary.size() && same; ++i) {
        const gusset::Loop a = boundary[i], b = fast[i];
        same = std::equal(a.half_edges.begin(), a.half_edges.end(), b.half_edges.begin(), b.half_edges.end());
    }
    // Loops are not cut at an edge with as many faces one way as the other, two or more each.
    if (!has_balanced_branch(sides)) {
        test.check(same, "the loops of the boundary alone are not those of the whole mesh");
    }
    const bool repeats = [&] {
        for (const auto &face : faces_of(soup)) {
            if (std::set<uint32_t>(face.begin(), face.end()).size() != face.size()) {
                return true;
            }
        }
        return false;
    }();
    if (!repeats) {
        const Counts counts = count(soup.view());
        const gusset::Check check(soup.view());
        test.equal(check.view().boundary_edges.count, counts.boundary, "boundary edges");
        test.equal(check.view().non_manifold_edges.count, counts.branches, "edges of three faces and more");
        test.equal(check.view().edge_count, counts.edges, "edges");
        test.equal(check.view().euler, counts.euler(), "Euler's characteristic");
        check_against_openmesh(test, soup, boundary);
        check_against_cgal(test, soup, boundary);
    }
}
} // namespace campaign
