// Meshes of sheets. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_MESH_HPP
#define GUSSET_SHEET_MESH_HPP

#include <gusset/result.hpp>
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

/// The mesh of a sheet; see gusset_sheet_to_mesh. It keeps nothing of the sheet; views and
/// spans live as long as this, and are not lent by a temporary.
class SheetMesh : public Result {
public:
    explicit SheetMesh(const Sheet &sheet, const SheetMeshOptions &options = {}, const Context &context = Context()) {
        auto given = detail::sized<gusset_sheet_mesh_options>();
        given.tolerance = options.tolerance;
        given.min_u = options.min_u;
        given.min_v = options.min_v;
        given.triangles = options.triangles ? 1 : 0;
        take(context.result(gusset_sheet_to_mesh, sheet.get(), &given));
    }

    /// The place of each vertex.
    Span<const SurfacePlace> places() const & {
        const gusset_sheet_mesh_report all = report();
        return {all.places, all.vertex_count};
    }
    Span<const SurfacePlace> places() const && = delete;
    /// Of each vertex the unit normal; 0 where there is none.
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
