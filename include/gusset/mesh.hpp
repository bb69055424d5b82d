/// @file
/// Views of polygon meshes. Include gusset.hpp, not this.
#ifndef GUSSET_MESH_HPP
#define GUSSET_MESH_HPP

#include <gusset/context.hpp>
#include <gusset/mesh_options.hpp>

#include <cstring>

namespace gusset {

/// A polygon mesh in memory: the caller's on the way in, a result's on the way out. It owns
/// nothing.
class MeshView {
public:
    /// A view as the C interface has it.
    explicit MeshView(const gusset_mesh_view &view) : view_(view) {}

    /// Faces of `face_size` corners each. `points`: any container or array that keeps its elements
    /// side by side; their first bytes are three floats or doubles, p[0] to p[2]. The view borrows:
    /// points and indices must outlive it. Throws std::invalid_argument if there are corners over.
    template <class Points>
    static MeshView uniform(const Points &points, Indices corners, uint32_t face_size) {
        gusset_mesh_view view = with_points(std::data(points), std::size(points));
        view.face_corners = corners.data();
        view.face_count = face_size == 0 ? 0 : corners.size() / face_size;
        view.face_size = face_size;
        if (face_size != 0 && corners.size() % face_size != 0) {
            throw std::invalid_argument("gusset: the number of corners is no multiple of face_size");
        }
        return MeshView(view);
    }
    template <class... Arguments, class = std::enable_if_t<(detail::is_temporary<Arguments> || ...)>>
    static MeshView uniform(Arguments &&...) = delete;
    /// Triangles, three corners each.
    template <class Points>
    static MeshView triangles(const Points &points, Indices corners) { return uniform(points, corners, 3); }
    /// Containers that are gone with the expression cannot be borrowed.
    template <class... Arguments, class = std::enable_if_t<(detail::is_temporary<Arguments> || ...)>>
    static MeshView triangles(Arguments &&...) = delete;

    /// Face f has the corners offsets[f] to offsets[f + 1] - 1. Throws std::invalid_argument if the last
    /// offset is not the number of corners.
    template <class Points>
    static MeshView polygons(const Points &points, Indices offsets, Indices corners) {
        if (offsets.empty() || offsets[offsets.size() - 1] != corners.size()) {
            throw std::invalid_argument("gusset: the last offset is not the number of corners");
        }
        gusset_mesh_view view = with_points(std::data(points), std::size(points));
        view.face_offsets = offsets.data();
        view.face_corners = corners.data();
        view.face_count = offsets.size() - 1;
        return MeshView(view);
    }
    template <class... Arguments, class = std::enable_if_t<(detail::is_temporary<Arguments> || ...)>>
    static MeshView polygons(Arguments &&...) = delete;

    /// The same mesh with merged vertices: merge[v] is the representative of v, and merge[merge[v]] = merge[v]; see
    /// find_merge(). The indices must outlive the view. Throws
    /// std::invalid_argument if there is not one for each vertex.
    MeshView merged(Indices merge) const {
        if (merge.size() != view_.vertex_count) {
            throw std::invalid_argument("gusset: there is not one entry of the merge map for each vertex");
        }
        MeshView same(*this);
        same.view_.merge = merge.data();
        return same;
    }
    /// The vertex that each vertex is one with; empty if none is one with another.
    Indices merge() const noexcept {
        return {static_cast<const uint32_t *>(view_.merge), view_.merge == nullptr ? 0 : view_.vertex_count};
    }

    /// The argument for the C interface, which this still owns.
    const gusset_mesh_view &get() const noexcept { return view_; }
    /// The number of vertices.
    std::size_t vertex_count() const noexcept { return view_.vertex_count; }
    /// The number of faces.
    std::size_t face_count() const noexcept { return view_.face_count; }

    /// Position `v` < vertex_count().
    Point3 position(std::size_t v) const {
        const bool wide = view_.scalar == GUSSET_F64;
        const std::size_t stride = view_.position_stride != 0 ? view_.position_stride : (wide ? 24 : 12);
        const char *at = static_cast<const char *>(view_.positions) + v * stride;
        Point3 wide_point;
        if (wide) {
            std::memcpy(wide_point.data(), at, 24);
            return wide_point;
        }
        std::array<float, 3> point;
        std::memcpy(point.data(), at, 12);
        return {point[0], point[1], point[2]};
    }

    /// The vertices of face `f` < face_count().
    Indices face(std::size_t f) const {
        const auto *corners = static_cast<const uint32_t *>(view_.face_corners);
        if (view_.face_offsets == nullptr) {
            return {corners + f * view_.face_size, view_.face_size};
        }
        const auto *offsets = static_cast<const uint32_t *>(view_.face_offsets);
        return {corners + offsets[f], offsets[f + 1] - offsets[f]};
    }

private:
    template <class Point>
    static gusset_mesh_view with_points(const Point *points, std::size_t count) {
        using Coordinate = typename detail::PointTraits3<Point>::Scalar;
        auto view = detail::sized<gusset_mesh_view>();
        view.positions = points;
        view.position_stride = sizeof(Point);
        view.vertex_count = count;
        view.scalar = std::is_same_v<Coordinate, float> ? GUSSET_F32 : GUSSET_F64;
        return view;
    }

    gusset_mesh_view view_;
};

/// For each vertex the smallest one with an equal key, or without keys at the same position; see
/// gusset_mesh_find_merge. Throws std::invalid_argument if there is not one key for each vertex.
inline std::vector<uint32_t> find_merge(const MeshView &mesh, Indices keys = {}, const Context &context = Context()) {
    if (!keys.empty() && keys.size() != mesh.vertex_count()) {
        throw std::invalid_argument("gusset: there is not one key for each vertex");
    }
    std::vector<uint32_t> merge(mesh.vertex_count());
    context.call(gusset_mesh_find_merge, &mesh.get(), keys.empty() ? nullptr : keys.data(), merge.data());
    return merge;
}

} // namespace gusset

#endif // GUSSET_MESH_HPP
