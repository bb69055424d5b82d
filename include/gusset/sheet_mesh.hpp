// Meshes of sheets. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_MESH_HPP
#define GUSSET_SHEET_MESH_HPP

#include <gusset/attributes.hpp>
#include <gusset/mesh.hpp>
#include <gusset/sheet.hpp>

namespace gusset {

/// The options of the mesh of a sheet; see gusset_sheet_mesh_options.
struct SheetMeshOptions {
    /// The largest distance of triangles from the surface; 0: no limit.
    double tolerance = 0.0;
    /// The smallest number of parts of each cell.
    uint32_t min_u = 1, min_v = 1;
    /// Triangles only; else quads, and triangles at poles.
    bool triangles = false;
};

/// The mesh of a sheet; see gusset_sheet_mesh_create. It keeps nothing of the sheet; views and
/// spans live as long as this, and are not lent by a temporary.
class SheetMesh {
public:
    explicit SheetMesh(const Sheet &sheet, const SheetMeshOptions &options = {}, const Context &context = Context()) {
        auto given = detail::sized<gusset_sheet_mesh_options>();
        given.tolerance = options.tolerance;
        given.min_u = options.min_u;
        given.min_v = options.min_v;
        given.triangles = options.triangles ? 1 : 0;
        mesh_.reset(context.result(gusset_sheet_mesh_create, sheet.get(), &given));
    }

    MeshView mesh() const & {
        return MeshView(detail::lent(gusset_sheet_mesh_get_mesh, mesh_.get()));
    }
    MeshView mesh() const && = delete;
    /// The place of each vertex.
    Span<const SurfacePlace> places() const & {
        const gusset_sheet_mesh_view all = view();
        return {all.places, all.vertex_count};
    }
    Span<const SurfacePlace> places() const && = delete;
    /// Of each vertex the unit normal; 0 where there is none.
    Points normals() const & {
        const gusset_sheet_mesh_view all = view();
        return detail::points(all.normals, all.vertex_count);
    }
    Points normals() const && = delete;
    /// A bound of the distance between the surface and the triangles, or either pair of triangles
    /// of quads.
    double deviation() const { return view().deviation; }
    /// Where the result's vertices, corners and faces come from.
    Origins origins(const Context &context = Context()) const {
        return Origins(context.result(gusset_sheet_mesh_origins_create, mesh_.get()));
    }

private:
    gusset_sheet_mesh_view view() const { return detail::lent(gusset_sheet_mesh_get_view, mesh_.get()); }
    detail::Handle<gusset_sheet_mesh, gusset_sheet_mesh_destroy> mesh_;
};

} // namespace gusset

#endif // GUSSET_SHEET_MESH_HPP
