// One tile by itself: the soup is welded, oriented and checked, and its rim cut into four sides.
#pragma once

#include "soup.hpp"
#include "stopwatch.hpp"

#include <gusset.hpp>

namespace tiles {
using gusset::Point3;

/// The mesh of a tile. Vertices that it owns come first; foreign ones, which a lower tile numbers, are last.
struct Mesh {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;
};

/// The data of a tile that stay in memory while its mesh is on disk: O(sqrt n).
struct Rim {
    /// The vertices of each side along the rim, with both corners, and their positions.
    std::array<std::vector<uint32_t>, 4> vertices;
    std::array<std::vector<Point3>, 4> points;
    uint32_t owned = 0, foreign = 0, edges = 0, faces = 0;
};

/// The report of cleaning.
struct Cleaned {
    uint64_t soup_faces = 0, turned = 0, dropped = 0;
};

/// The loop of vertices round a tile, cut at the four places where the plan has its corners.
inline std::array<std::vector<uint32_t>, 4> cut_rim(const gusset::MeshView &mesh, const TileGrid &grid, const gusset::Context &context) {
    gusset::BoundaryOptions options;
    options.survey = gusset::Survey::boundary_only;
    const gusset::Boundary boundary(mesh, options, context);
    if (boundary.size() != 1 || !boundary[0].is_closed()) {
        throw std::runtime_error("the rim is not one closed loop");
    }
    const gusset::Indices loop = boundary[0].vertices;
    std::array<std::size_t, 5> place{};
    for (uint32_t k = 0; k < 4; ++k) {
        const PointF corner = grid.corner(k);
        const auto found = std::find_if(loop.begin(), loop.end(), [&](uint32_t v) {
            const Point3 p = mesh.position(v);
            return p[0] == corner[0] && p[1] == corner[1] && p[2] == corner[2];
        });
        if (found == loop.end()) {
            throw std::runtime_error("the rim does not pass through corner " + std::to_string(k));
        }
        place[k] = static_cast<std::size_t>(found - loop.begin());
        // From corner 0 on, corners must come in order within one round.
        if (k > 0) {
            place[k] = place[0] + (place[k] + loop.size() - place[0]) % loop.size();
            if (place[k] <= place[k - 1]) {
                throw std::runtime_error("the rim passes its corners in another order: the tile is inside out");
            }
        }
    }
    place[4] = place[0] + loop.size();
    std::array<std::vector<uint32_t>, 4> sides;
    for (std::size_t k = 0; k < 4; ++k) {
        // No more than that: a rank keeps the rims of all its tiles.
        sides[k].reserve(place[k + 1] - place[k] + 1);
        for (std::size_t i = place[k]; i <= place[k + 1]; ++i) {
            sides[k].push_back(loop[i % loop.size()]);
        }
    }
    return sides;
}

/// The vertices that a lower tile owns: vertices of coincident rims.
inline std::vector<uint8_t> foreign_vertices(const Plan &plan, uint32_t tile, const Rim &rim, std::size_t count) {
    std::vector<uint8_t> foreign(count);
    if (plan.gap) {
        return foreign;
    }
    for (uint32_t k = 0; k < 4; ++k) {
        if (!plan.owns_side(tile, k)) {
            for (std::size_t i = 1; i + 1 < rim.vertices[k].size(); ++i) {
                foreign[rim.vertices[k][i]] = 1;
            }
        }
        foreign[rim.vertices[k].front()] = plan.junction_owner(tile, k) != tile;
    }
    return foreign;
}

/// Copies the clean mesh of a tile, with its own vertices before foreign ones.
inline void keep(const Plan &plan, uint32_t tile, const gusset::MeshView &view, Mesh &mesh, Rim &rim) {
    const std::vector<uint8_t> foreign = foreign_vertices(plan, tile, rim, view.vertex_count());
    std::vector<uint32_t> place(view.vertex_count());
    for (const uint8_t kind : {uint8_t{0}, uint8_t{1}}) {
        uint32_t &count = kind == 0 ? rim.owned : rim.foreign;
        for (std::size_t v = 0; v < place.size(); ++v) {
            if (foreign[v] == kind) {
                place[v] = (kind == 0 ? 0 : rim.owned) + count++;
            }
        }
    }
    mesh.points.resize(place.size());
    for (std::size_t v = 0; v < place.size(); ++v) {
        mesh.points[place[v]] = view.position(v);
    }
    mesh.corners.reserve(view.face_count() * 3);
    for (std::size_t f = 0; f < view.face_count(); ++f) {
        for (const uint32_t v : view.face(f)) {
            mesh.corners.push_back(place[v]);
        }
    }
    for (std::size_t k = 0; k < 4; ++k) {
        rim.points[k].reserve(rim.vertices[k].size());
        for (uint32_t &v : rim.vertices[k]) {
            v = place[v];
            rim.points[k].push_back(mesh.points[v]);
        }
    }
}

/// Cleans a soup.
inline void clean(const Plan &plan, uint32_t tile, Soup &&soup, const gusset::Context &context, Stopwatch &watch, Mesh &mesh,
                  Rim &rim, Cleaned &cleaned) {
    cleaned.soup_faces += soup.size() / 3;
    //! [clean]
    std::vector<uint32_t> corners(soup.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = static_cast<uint32_t>(i);
    }
    gusset::WeldOptions options;
    options.vertices = gusset::WeldVertices::all;
    options.tolerance = 0.0;
    options.collapse = gusset::Collapse::allow;
    options.unused = gusset::Unused::remove;
    auto weld = std::make_unique<gusset::Weld>(gusset::MeshView::triangles(soup, corners), options, context);
    Soup().swap(soup); // the largest of all that a tile needs
    std::vector<uint32_t>().swap(corners);
    watch.lap(Stage::weld);
    const gusset::Orient orient(weld->mesh(), {}, context);
    cleaned.dropped += weld->dropped_faces();
    cleaned.turned += orient.turned_faces();
    weld.reset();
    watch.lap(Stage::orient);
    const gusset::MeshView view = orient.mesh();
    {
        const gusset::Check check(view, context);
        const gusset_check_view found = check.view();
        if (!check.is_manifold() || !check.is_oriented() || found.component_count != 1 || found.degenerate_faces.count != 0) {
            throw std::runtime_error("the clean tile is not a connected, oriented manifold");
        }
        rim.edges = found.edge_count;
        rim.faces = found.face_count;
    }
    rim.vertices = cut_rim(view, TileGrid(plan, tile), context);
    //! [clean]
    keep(plan, tile, view, mesh, rim);
    watch.lap(Stage::check);
}
} // namespace tiles
