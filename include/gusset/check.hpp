/// @file
/// Checks of meshes. Include gusset.hpp, not this.
#ifndef GUSSET_CHECK_HPP
#define GUSSET_CHECK_HPP

#include <gusset/mesh.hpp>

namespace gusset {

/// The defects of a mesh; see gusset_check_view, whose lists live as long as this.
class Check {
public:
    /// See ::gusset_check_create.
    explicit Check(const MeshView &mesh, const Context &context = Context()) {
        check_.reset(context.result(gusset_check_create, &mesh.get()));
    }
    /// See ::gusset_check_get_view.
    gusset_check_view view() const & { return detail::lent(gusset_check_get_view, check_.get()); }
    gusset_check_view view() const && = delete;
    /// There are edges, and every one has exactly two faces; degenerate faces have none.
    bool is_closed() const { return has(GUSSET_MESH_CLOSED); }
    /// No edge has three or more faces, no vertex is a bow-tie.
    bool is_manifold() const { return has(GUSSET_MESH_MANIFOLD); }
    /// Faces that share an edge run it in opposite directions.
    bool is_oriented() const { return has(GUSSET_MESH_ORIENTED); }
    /// Faces can be oriented consistently.
    bool is_orientable() const { return has(GUSSET_MESH_ORIENTABLE); }

private:
    bool has(uint32_t property) const { return (view().properties & property) != 0; }
    detail::Handle<gusset_check, gusset_check_destroy> check_;
};

} // namespace gusset

#endif // GUSSET_CHECK_HPP
