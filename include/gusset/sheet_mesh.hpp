/// @file
/// Meshes of sheets. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_MESH_HPP
#define GUSSET_SHEET_MESH_HPP

#include <gusset/result.hpp>
#include <gusset/sheet.hpp>

namespace gusset {

/// The mesh of a sheet; see gusset_sheet_to_mesh. It keeps nothing of the sheet; views and
/// spans live as long as this, and are not lent by a temporary.
class SheetMesh : public Result {
public:
    /// See ::gusset_sheet_to_mesh.
    explicit SheetMesh(const Sheet &sheet, const SheetMeshOptions &options = {}, const Context &context = Context()) {
        const gusset_sheet_mesh_options given = detail::as_c(options);
        take(context.result(gusset_sheet_to_mesh, sheet.get(), &given));
    }

    /// The place of each vertex.
    Span<const SurfacePlace> places() const & {
        const gusset_sheet_mesh_report all = report();
        return {all.places, all.vertex_count};
    }
    Span<const SurfacePlace> places() const && = delete;
    /// For each vertex the unit normal; 0 if undefined.
    Points normals() const & {
        const gusset_sheet_mesh_report all = report();
        return detail::points(all.normals, all.vertex_count);
    }
    Points normals() const && = delete;
    /// A bound of the distance between the surface and the triangles, or either pair of triangles
    /// of quads.
    double deviation() const { return report().deviation; }

private:
    gusset_sheet_mesh_report report() const { return detail::lent(gusset_result_get_sheet_mesh, get()); }
};

} // namespace gusset

#endif // GUSSET_SHEET_MESH_HPP
