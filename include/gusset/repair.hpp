/// @file
/// Welding, sewing, orienting and triangulating. Include gusset.hpp, not this.
#ifndef GUSSET_REPAIR_HPP
#define GUSSET_REPAIR_HPP

#include <gusset/result.hpp>

namespace gusset {

/// A mesh with coincident vertices merged; see gusset_weld.
class Weld : public Result {
public:
    /// The index of an element that is not in the result.
    static constexpr uint32_t none = UINT32_MAX;

    /// See ::gusset_weld.
    explicit Weld(const MeshView &mesh, const WeldOptions &options = {}, const Context &context = Context()) {
        const gusset_weld_options given = detail::as_c(options);
        take(context.result(gusset_weld, &mesh.get(), &given));
    }

    /// For each old vertex its index in the result, or UINT32_MAX.
    Indices vertex_map() const & { return detail::indices(report().vertex_map); }
    Indices vertex_map() const && = delete;
    /// For each old face its index in the result, or UINT32_MAX.
    Indices face_map() const & { return detail::indices(report().face_map); }
    Indices face_map() const && = delete;
    /// Half-edges of the old mesh: free edges that lie on another and are not sewn to it.
    Indices left_edges() const & { return detail::indices(report().left_edges); }
    Indices left_edges() const && = delete;
    /// Vertices of the old mesh that lie together with another and are not welded to it.
    Indices left_vertices() const & { return detail::indices(report().left_vertices); }
    Indices left_vertices() const && = delete;
    /// The number of vertices welded to one of a smaller index.
    uint32_t welded_vertices() const { return report().welded_vertices; }
    /// The number of edges sewn from two free edges.
    uint32_t sewn_edges() const { return report().sewn_edges; }
    /// How far apart vertices that lie together were allowed to be, short edges apart; 0 for equal positions.
    double tolerance() const { return report().tolerance; }
    /// The number of faces dropped.
    uint32_t dropped_faces() const { return report().dropped_faces; }
    /// The number of pairs of free edges that only a larger tolerance would sew.
    uint32_t near_edge_pairs() const { return report().near_edge_pairs; }
    /// The tolerance that would sew them; 0 if there are none.
    double near_tolerance() const { return report().near_tolerance; }

private:
    gusset_weld_report report() const { return detail::lent(gusset_result_get_weld, get()); }
};

/// A mesh whose borders are sewn, also where their vertices do not match; see gusset_sew.
class Sew : public Result {
public:
    /// The index of an element that is not in the result.
    static constexpr uint32_t none = UINT32_MAX;

    /// See ::gusset_sew.
    explicit Sew(const MeshView &mesh, const WeldOptions &options = {}, const Context &context = Context()) {
        const gusset_weld_options given = detail::as_c(options);
        take(context.result(gusset_sew, &mesh.get(), &given));
    }

    /// For each old vertex its index in the result, or UINT32_MAX.
    Indices vertex_map() const & { return detail::indices(report().vertex_map); }
    Indices vertex_map() const && = delete;
    /// For each old face the index of its first face in the result, or UINT32_MAX.
    Indices face_map() const & { return detail::indices(report().face_map); }
    Indices face_map() const && = delete;
    /// For each face of the result the old face that contains it.
    Indices face_origin() const & { return detail::indices(report().face_origin); }
    Indices face_origin() const && = delete;
    /// Old vertices that lie together with another, or inside a free edge, and are not sewn to it.
    Indices left_vertices() const & { return detail::indices(report().left_vertices); }
    Indices left_vertices() const && = delete;
    /// The number of vertices welded to one of a smaller index.
    uint32_t welded_vertices() const { return report().welded_vertices; }
    /// The number of edges sewn from two free edges, or parts of such.
    uint32_t sewn_edges() const { return report().sewn_edges; }
    /// The number of points at which free edges were split.
    uint32_t splits() const { return report().splits; }
    /// The number of old faces that were cut or gained corners.
    uint32_t split_faces() const { return report().split_faces; }
    /// The number of old faces dropped.
    uint32_t dropped_faces() const { return report().dropped_faces; }
    /// How far apart what lies together was allowed to be, short edges apart; 0 for equal positions.
    double tolerance() const { return report().tolerance; }
    /// The number of pairs of free edges that only a larger tolerance would sew.
    uint32_t near_edge_pairs() const { return report().near_edge_pairs; }
    /// The tolerance that would sew them; 0 if there are none.
    double near_tolerance() const { return report().near_tolerance; }

private:
    gusset_sew_report report() const { return detail::lent(gusset_result_get_sew, get()); }
};

/// A solid made by gusset_repair or gusset_unite, and where its elements are from.
class Solid : public Result {
public:
    /// The index of an element that is not from the input.
    static constexpr uint32_t none = UINT32_MAX;

    /// True if the result bounds a solid: closed, manifold, oriented, without degenerate, duplicate
    /// or intersecting faces.
    bool valid() const { return report().valid != 0; }
    /// For each face the old face that it is, or is a part of; `none` for faces of patches.
    Indices face_origin() const & { return detail::indices(report().face_origin); }
    Indices face_origin() const && = delete;
    /// For each vertex the smallest old vertex that it is; `none` for new vertices.
    Indices vertex_origin() const & { return detail::indices(report().vertex_origin); }
    Indices vertex_origin() const && = delete;
    /// For each face 1 if it was turned over.
    Span<const uint8_t> turned() const & {
        const gusset_repair_report found = report();
        return {found.turned, found.face_count};
    }
    Span<const uint8_t> turned() const && = delete;
    /// The dropped old faces, ascending.
    Indices dropped_faces() const & { return detail::indices(report().dropped_faces); }
    Indices dropped_faces() const && = delete;
    /// The reason for each of them: GUSSET_DROP_...
    Span<const gusset_drop_reason> drop_reasons() const & {
        const gusset_repair_report found = report();
        return {found.drop_reasons, found.dropped_count};
    }
    Span<const gusset_drop_reason> drop_reasons() const && = delete;
    /// Pairs of faces that intersect in the result.
    Indices intersecting_pairs() const & { return detail::indices(report().intersecting_pairs); }
    Indices intersecting_pairs() const && = delete;
    /// The counts of changes, and of defects that remain.
    gusset_repair_report report() const & { return detail::lent(gusset_result_get_repair, get()); }
    gusset_repair_report report() const && = delete;

private:
    // Made by the classes below.
    Solid() = default;
    friend class Repair;
    friend class Unite;
};

/// A mesh without its defects, changed only at these; see gusset_repair.
class Repair : public Solid {
public:
    /// See ::gusset_repair.
    explicit Repair(const MeshView &mesh, const RepairOptions &options = {}, const Context &context = Context()) {
        detail::RepairOptionsNested nested;
        const gusset_repair_options given = detail::as_c(options, nested);
        take(context.result(gusset_repair, &mesh.get(), &given));
    }
};

/// The union of closed pieces; see gusset_unite. Old vertices and faces are numbered piece after piece.
class Unite : public Solid {
public:
    /// See ::gusset_unite.
    explicit Unite(Span<const MeshView> pieces, const Context &context = Context()) {
        const std::vector<gusset_mesh_view> views = detail::c_views(pieces);
        take(context.result(gusset_unite, views.data(), views.size()));
    }
};

/// A mesh whose faces agree with their neighbours; see gusset_orient.
class Orient : public Result {
public:
    /// The faces of a mesh, turned over where they disagree.
    explicit Orient(const MeshView &mesh, const OrientOptions &options = {}, const Context &context = Context()) {
        const gusset_orient_options given = detail::as_c(options);
        take(context.result(gusset_orient, &mesh.get(), &given));
    }

    /// For each face 1 if it was reversed.
    Span<const uint8_t> turned() const & {
        const gusset_orient_report found = report();
        return {found.turned, found.face_count};
    }
    Span<const uint8_t> turned() const && = delete;
    /// The number of faces turned over.
    uint32_t turned_faces() const { return report().turned_faces; }
    /// The number of components.
    uint32_t component_count() const { return report().component_count; }
    /// The number of closed components that were turned to face outwards.
    uint32_t inverted_components() const { return report().inverted_components; }
    /// The smallest face of each one-sided component.
    Indices one_sided_faces() const & { return detail::indices(report().one_sided_faces); }
    Indices one_sided_faces() const && = delete;
    /// For each one-sided component a half-edge where two faces disagree.
    Indices one_sided_half_edges() const & { return detail::indices(report().one_sided_half_edges); }
    Indices one_sided_half_edges() const && = delete;

private:
    gusset_orient_report report() const { return detail::lent(gusset_result_get_orient, get()); }
};

/// A mesh whose faces were split into triangles of their own corners, concave ones too; see ::gusset_triangulate. origins()
/// gives the face of each triangle.
class Triangulation : public Result {
public:
    /// See ::gusset_triangulate.
    explicit Triangulation(const MeshView &mesh, const Context &context = Context()) {
        take(context.result(gusset_triangulate, &mesh.get()));
    }
};

} // namespace gusset

#endif // GUSSET_REPAIR_HPP
