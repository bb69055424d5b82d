#include "polygons.hpp"

#include <vcg/space/planar_polygon_tessellation.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace {

/// Sets of triangles, each named by its least.
class Groups {
public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t of(std::uint32_t face) {
        while (parent_[face] != face) {
            face = parent_[face] = parent_[parent_[face]];
        }
        return face;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a);
        b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Edge `edge` of triangle `face`, from vertex `from` to vertex `to`.
struct HalfEdge {
    std::uint32_t from, to, face;
    int edge;

    /// The wedge where it begins.
    std::uint32_t wedge() const { return 3 * face + static_cast<std::uint32_t>(edge); }
    auto key() const { return std::make_tuple(std::min(from, to), std::max(from, to)); }
};

HalfEdge half_edge(const CMeshO &mesh, std::uint32_t face, int edge) {
    const CFaceO &f = mesh.face[face];
    const auto index = [&](int corner) { return static_cast<std::uint32_t>(vcg::tri::Index(mesh, f.cV(corner % 3))); };
    return {index(edge), index(edge + 1), face, edge};
}

/// For each edge of each triangle whether it lies inside a polygon: marked as faux from both sides, which run against
/// each other.
std::vector<std::uint8_t> inner_edges(const CMeshO &mesh, Groups &groups) {
    std::vector<HalfEdge> faux;
    for (std::uint32_t face = 0; face < mesh.face.size(); ++face) {
        for (int edge = 0; edge < 3 && !mesh.face[face].IsD(); ++edge) {
            if (mesh.face[face].IsF(edge)) {
                faux.push_back(half_edge(mesh, face, edge));
            }
        }
    }
    std::sort(faux.begin(), faux.end(), [](const HalfEdge &a, const HalfEdge &b) { return a.key() < b.key(); });
    std::vector<std::uint8_t> inner(3 * mesh.face.size(), 0);
    for (std::size_t first = 0, end; first < faux.size(); first = end) {
        end = first;
        while (end < faux.size() && faux[end].key() == faux[first].key()) {
            ++end;
        }
        if (end - first == 2 && faux[first].from == faux[first + 1].to && faux[first].face != faux[first + 1].face) {
            for (std::size_t k = first; k < end; ++k) {
                inner[faux[k].wedge()] = 1;
            }
            groups.join(faux[first].face, faux[first + 1].face);
        }
    }
    return inner;
}

/// The wedges along the outline of a group, or nothing if it is not one simple loop.
std::vector<std::uint32_t> outline(const CMeshO &mesh, const std::vector<std::uint32_t> &group,
                                   const std::vector<std::uint8_t> &inner) {
    // By the vertex where an edge of the outline begins.
    std::unordered_map<std::uint32_t, HalfEdge> next;
    std::vector<std::uint32_t> loop;
    std::size_t edges = 0;
    std::uint32_t start = 0;
    for (const std::uint32_t face : group) {
        for (int edge = 0; edge < 3; ++edge) {
            if (inner[3 * face + static_cast<std::size_t>(edge)] == 0) {
                const HalfEdge outer = half_edge(mesh, face, edge);
                next.insert_or_assign(outer.from, outer);
                start = edges++ == 0 ? outer.from : start;
            }
        }
    }
    for (std::uint32_t at = start; loop.size() < edges;) {
        const auto found = next.find(at);
        if (found == next.end()) {
            break;
        }
        loop.push_back(found->second.wedge());
        at = found->second.to;
        if (at == start) {
            return loop.size() == edges && edges >= 3 ? loop : std::vector<std::uint32_t>();
        }
    }
    return {};
}

/// Places among the corners of a polygon, three for each triangle that it is cut into.
std::vector<int> cut(const CMeshO &mesh, const std::uint32_t *corners, std::size_t count) {
    std::vector<Point3m> points;
    for (std::size_t k = 0; k < count; ++k) {
        points.push_back(mesh.vert[corners[k]].cP());
    }
    std::vector<int> triangles;
    vcg::TessellatePlanarPolygon3(points, triangles);
    if (triangles.size() != 3 * (count - 2)) {
        // It found no way, as for polygons without area.
        triangles.clear();
        for (int k = 2; k < static_cast<int>(count); ++k) {
            triangles.insert(triangles.end(), {0, k - 1, k});
        }
    }
    return triangles;
}

} // namespace

Polygons polygons(const CMeshO &mesh) {
    Polygons found;
    Groups groups(mesh.face.size());
    const std::vector<std::uint8_t> inner = inner_edges(mesh, groups);
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members;
    for (std::uint32_t face = 0; face < mesh.face.size(); ++face) {
        if (groups.of(face) != face) {
            members[groups.of(face)].push_back(face);
        }
    }
    const auto add = [&](const std::vector<std::uint32_t> &wedges) {
        for (const std::uint32_t wedge : wedges) {
            found.corners.push_back(half_edge(mesh, wedge / 3, static_cast<int>(wedge % 3)).from);
        }
        found.wedges.insert(found.wedges.end(), wedges.begin(), wedges.end());
        found.offsets.push_back(static_cast<std::uint32_t>(found.corners.size()));
    };
    for (std::uint32_t face = 0; face < mesh.face.size(); ++face) {
        if (mesh.face[face].IsD() || groups.of(face) != face) {
            continue;
        }
        std::vector<std::uint32_t> group{face};
        if (const auto more = members.find(face); more != members.end()) {
            group.insert(group.end(), more->second.begin(), more->second.end());
            if (const auto loop = outline(mesh, group, inner); !loop.empty()) {
                add(loop);
                continue;
            }
        }
        for (const std::uint32_t triangle : group) {
            add({3 * triangle, 3 * triangle + 1, 3 * triangle + 2});
        }
    }
    return found;
}

Triangles add_faces(CMeshO &mesh, const Polygons &faces) {
    const std::size_t count = faces.offsets.size() - 1;
    Triangles made;
    auto face = vcg::tri::Allocator<CMeshO>::AddFaces(mesh, faces.corners.size() - 2 * count);
    for (std::uint32_t f = 0; f < count; ++f) {
        const std::uint32_t *corners = faces.corners.data() + faces.offsets[f];
        const int degree = static_cast<int>(faces.offsets[f + 1] - faces.offsets[f]);
        const std::vector<int> places = cut(mesh, corners, static_cast<std::size_t>(degree));
        for (std::size_t k = 0; k < places.size(); k += 3, ++face) {
            made.faces.push_back(f);
            for (int c = 0; c < 3; ++c) {
                const int here = places[k + static_cast<std::size_t>(c)],
                          next = places[k + static_cast<std::size_t>((c + 1) % 3)];
                face->V(c) = &mesh.vert[corners[here]];
                made.corners.push_back(faces.offsets[f] + static_cast<std::uint32_t>(here));
                if ((here + 1) % degree != next) {
                    face->SetF(c);
                }
            }
        }
    }
    return made;
}
