// Meshes of pieces of surfaces. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_MESH_HPP
#define GUSSET_SHEET_MESH_HPP

#include <gusset/sheet.hpp>

namespace gusset {

/// How a sheet becomes a mesh; see gusset_sheet_mesh_options.
struct SheetMeshOptions {
    /// How far triangles may be from the surface; 0: no demand.
    double tolerance = 0.0;
    /// The fewest parts of each cell.
    uint32_t least_u = 1;
    uint32_t least_v = 1;
    /// Triangles only; else quads, and triangles at poles.
    bool triangles = false;
};

/// The mesh of a sheet; see gusset_sheet_mesh_create. It keeps nothing of the sheet; views and spans live as long as this, and are
/// not lent by a temporary.
class SheetMesh {
public:
    explicit SheetMesh(const Sheet &sheet, const SheetMeshOptions &options = {}, const Context &context = Context()) {
        gusset_sheet_mesh_options given{};
        given.struct_size = sizeof given;
        given.tolerance = options.tolerance;
        given.least_u = options.least_u;
        given.least_v = options.least_v;
        given.triangles = options.triangles ? 1 : 0;
        gusset_sheet_mesh *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_sheet_mesh_create(c, sheet.get(), &given, &created); });
        mesh_.reset(created);
    }

    MeshView mesh() const & {
        return MeshView(detail::lent<gusset_mesh_view>(gusset_sheet_mesh_get_mesh, mesh_.get()));
    }
    MeshView mesh() const && = delete;
    /// Of each vertex.
    Span<const SurfacePlace> places() const & {
        const gusset_sheet_mesh_view all = parts();
        return {all.places, all.vertex_count};
    }
    Span<const SurfacePlace> places() const && = delete;
    /// Of each vertex the unit normal; 0 where there is none.
    Span<const Point3> normals() const & {
        const gusset_sheet_mesh_view all = parts();
        return detail::points(all.normals, all.vertex_count);
    }
    Span<const Point3> normals() const && = delete;
    /// A bound of the distance between the surface and the triangles, or either pair of triangles of quads.
    double deviation() const { return parts().deviation; }

private:
    struct Destroy {
        void operator()(gusset_sheet_mesh *mesh) const noexcept { gusset_sheet_mesh_destroy(mesh); }
    };
    gusset_sheet_mesh_view parts() const { return detail::lent(gusset_sheet_mesh_get_view, mesh_.get()); }
    std::unique_ptr<gusset_sheet_mesh, Destroy> mesh_;
};

} // namespace gusset

#endif // GUSSET_SHEET_MESH_HPP
