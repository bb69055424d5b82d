/// @file
/// Views of polygon meshes. Include gusset.hpp, not this.
#ifndef GUSSET_MESH_HPP
#define GUSSET_MESH_HPP

#include <gusset/context.hpp>
#include <gusset/mesh_options.hpp>

#include <cstring>

namespace gusset {

/// The vertex of each corner, face by face, in memory that belongs to someone else: 32-bit integers, signed or not, or rows of
/// them that hold as many corners as each face has, such as std::array<int, 3>.
class Corners : public Indices {
public:
    /// Borrows the elements of a container. Throws an Error for the first negative index.
    template <class Container>
    explicit Corners(const Container &corners)
        : Indices(reinterpret_cast<const uint32_t *>(std::data(corners)), std::size(corners) * row_size<Container>) {
        if constexpr (std::is_signed_v<typename Traits<Container>::Number>) {
            require_signs(GUSSET_ELEMENT_HALF_EDGE, "corner");
        }
    }
    /// A container that is gone with the expression cannot be borrowed.
    template <class Container, std::enable_if_t<detail::is_temporary<Container>, int> = 0>
    explicit Corners(Container &&) = delete;

    /// The number of indices in an element of a container.
    template <class Container>
    static constexpr std::size_t row_size = detail::IndexTraits<typename detail::Elements<Container>::Type>::count;

private:
    template <class Container>
    using Traits = detail::IndexTraits<typename detail::Elements<Container>::Type>;
};

/// The first corner of each face, then the number of corners, in memory that belongs to someone else.
class Offsets : public Indices {
public:
    /// Borrows the elements of a container of 32-bit integers. Throws an Error for the first negative one.
    template <class Container>
    explicit Offsets(const Container &offsets) : Indices(offsets) {
        static_assert(Corners::row_size<Container> == 1, "one offset in each element");
    }
    /// A container that is gone with the expression cannot be borrowed.
    template <class Container, std::enable_if_t<detail::is_temporary<Container>, int> = 0>
    explicit Offsets(Container &&) = delete;
};

/// A polygon mesh in memory: the caller's on the way in, a result's on the way out. It owns
/// nothing.
class MeshView {
public:
    /// A view as the C interface has it.
    explicit MeshView(const gusset_mesh_view &view) : view_(view) {}

    /// Faces of `face_size` corners each. `points`: a container that keeps its elements side by side. Each element begins
    /// with three floats or doubles, p[0] to p[2], or is one of three numbers of a point. `corners`: as Corners takes
    /// them. The view borrows: points and corners must outlive it. Throws an Error if there are corners or numbers
    /// over, or rows of another length.
    template <class Points, class Container>
    static MeshView uniform(const Points &points, const Container &corners, uint32_t face_size) {
        const Corners indices(corners);
        constexpr std::size_t row_size = Corners::row_size<Container>;
        if ((row_size != 1 && row_size != face_size) || (face_size != 0 && indices.size() % face_size != 0)) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "there are corners over: each face needs as many as the others");
        }
        gusset_mesh_view view = with_points(points);
        view.face_corners = indices.data();
        view.face_count = face_size == 0 ? 0 : indices.size() / face_size;
        view.face_size = face_size;
        return MeshView(view);
    }
    template <class... Arguments, class = std::enable_if_t<(detail::is_temporary<Arguments> || ...)>>
    static MeshView uniform(Arguments &&...) = delete;
    /// Triangles, three corners each.
    template <class Points, class Container>
    static MeshView triangles(const Points &points, const Container &corners) {
        static_assert(Corners::row_size<Container> == 1 || Corners::row_size<Container> == 3,
                      "rows of three corners: MeshView::uniform takes rows of another length");
        return uniform(points, corners, 3);
    }
    /// Containers that are gone with the expression cannot be borrowed.
    template <class... Arguments, class = std::enable_if_t<(detail::is_temporary<Arguments> || ...)>>
    static MeshView triangles(Arguments &&...) = delete;

    /// Face f has the corners offsets[f] to offsets[f + 1] - 1. Both arrays are named, because they have one type:
    /// `polygons(points, Offsets(o), Corners(c))`. Throws an Error if the last offset is not the number of corners.
    template <class Points, class First, class Second>
    static MeshView polygons(const Points &points, const First &offsets, const Second &corners) {
        constexpr bool are_named = std::is_same_v<First, Offsets> && std::is_same_v<Second, Corners>;
        static_assert(are_named, "name the arrays: MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(corners))");
        gusset_mesh_view view = with_points(points);
        if constexpr (are_named) {
            if (offsets.empty()) {
                detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "there are no offsets: a mesh without faces has the offset 0");
            }
            if (offsets[offsets.size() - 1] != corners.size()) {
                detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the last offset is not the number of corners");
            }
            view.face_offsets = offsets.data();
            view.face_corners = corners.data();
            view.face_count = offsets.size() - 1;
        }
        return MeshView(view);
    }
    template <class... Arguments, class = std::enable_if_t<(detail::is_temporary<Arguments> || ...)>>
    static MeshView polygons(Arguments &&...) = delete;

    /// The same mesh with merged vertices: merge[v] is the representative of v, and merge[merge[v]] = merge[v]; see
    /// find_merge(). The indices must outlive the view. Throws
    /// an Error if there is not one for each vertex.
    MeshView merged(Indices merge) const {
        if (merge.size() != view_.vertex_count) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "there is not one entry of the merge map for each vertex");
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

    /// The positions, side by side. Throws an Error if they are of the other type, float or double, or have gaps
    /// between them; position() reads both. Results have no gaps.
    template <class Scalar = double>
    Span<const std::array<Scalar, 3>> positions() const {
        using Row = std::array<Scalar, 3>;
        static_assert(std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>, "positions of float or double");
        if (view_.scalar != (std::is_same_v<Scalar, float> ? GUSSET_F32 : GUSSET_F64)) {
            detail::refuse(GUSSET_ERROR_UNKNOWN_VALUE, has_floats() ? "the positions are floats: call positions<float>()"
                                                                    : "the positions are doubles: call positions<double>()");
        }
        if (view_.position_stride != 0 && view_.position_stride != sizeof(Row)) {
            detail::refuse(GUSSET_ERROR_BAD_STRIDE, "the positions are not side by side: read them by position(v)");
        }
        return {static_cast<const Row *>(view_.positions), view_.vertex_count};
    }
    /// True if positions are floats, false if they are doubles.
    bool has_floats() const noexcept { return view_.scalar == GUSSET_F32; }
    /// The vertex of each corner, face by face.
    Indices corners() const noexcept {
        const std::size_t count = view_.face_offsets == nullptr ? view_.face_count * view_.face_size
                                  : static_cast<const uint32_t *>(view_.face_offsets)[view_.face_count];
        return {static_cast<const uint32_t *>(view_.face_corners), count};
    }
    /// The first corner of each face, then the number of corners; empty if all faces have face_size() corners.
    Indices offsets() const noexcept {
        return {static_cast<const uint32_t *>(view_.face_offsets), view_.face_offsets == nullptr ? 0 : view_.face_count + 1};
    }
    /// The number of corners of every face; 0 if offsets() gives it.
    uint32_t face_size() const noexcept { return view_.face_size; }

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
    template <class Points>
    static gusset_mesh_view with_points(const Points &points) {
        using Given = typename detail::Elements<Points>::Type;
        constexpr bool is_flat = std::is_floating_point_v<Given>;
        using Point = std::conditional_t<is_flat, std::array<Given, 3>, Given>;
        using Coordinate = typename detail::PointTraits3<Point>::Scalar;
        if (is_flat && std::size(points) % 3 != 0) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of coordinates is not a multiple of 3");
        }
        auto view = detail::sized<gusset_mesh_view>();
        view.positions = std::data(points);
        view.position_stride = sizeof(Point);
        view.vertex_count = std::size(points) / (is_flat ? 3 : 1);
        view.scalar = std::is_same_v<Coordinate, float> ? GUSSET_F32 : GUSSET_F64;
        return view;
    }

    gusset_mesh_view view_;
};

namespace detail {
/// The arguments for the C interface, in an array.
inline std::vector<gusset_mesh_view> c_views(Span<const MeshView> pieces) {
    std::vector<gusset_mesh_view> views;
    for (const MeshView &piece : pieces) {
        views.push_back(piece.get());
    }
    return views;
}
} // namespace detail

/// For each vertex the smallest one with an equal key, or without keys at the same position; see
/// gusset_mesh_find_merge. Throws an Error if there is not one key for each vertex.
inline std::vector<uint32_t> find_merge(const MeshView &mesh, Indices keys = {}, const Context &context = Context()) {
    if (!keys.empty() && keys.size() != mesh.vertex_count()) {
        detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "there is not one key for each vertex");
    }
    std::vector<uint32_t> merge(mesh.vertex_count());
    context.call(gusset_mesh_find_merge, &mesh.get(), keys.empty() ? nullptr : keys.data(), merge.data());
    return merge;
}

} // namespace gusset

#endif // GUSSET_MESH_HPP
