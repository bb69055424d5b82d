// Shared by the filters: vtkPolyData as the library's input and output.
#ifndef GUSSET_VTK_POLYDATA_HPP
#define GUSSET_VTK_POLYDATA_HPP

#include "gusset_run.hpp"

#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

namespace gusset_vtk {

/// The polygons and strips of a vtkPolyData as a mesh. Packed points of floats or doubles and polygons of 32-bit ids
/// are read in place; other arrays are copied. Strips are read as triangles.
class Piece {
public:
    /// `name`: what errors call it, or empty. Throws std::invalid_argument if points are missing, std::out_of_range
    /// if the id of a cell is not a point.
    explicit Piece(vtkPolyData *data, std::string name = {});
    Piece(Piece &&) = default;
    Piece &operator=(Piece &&) = default;

    gusset::MeshView view() const { return gusset::MeshView(view_); }
    bool is_single() const { return view_.scalar == GUSSET_F32; }
    /// Reads points of floats as doubles, which is exact.
    void widen();
    vtkPolyData *data() const { return data_; }
    /// The start of a message about it.
    std::string where() const { return name_.empty() ? name_ : name_ + ": "; }
    std::size_t face_count() const { return view_.face_count; }
    /// The cells before the polygons: vertices and lines, which the library does not see.
    vtkIdType loose_count() const { return data_->GetNumberOfVerts() + data_->GetNumberOfLines(); }
    /// The cells of triangles of strips, and of polygons beside them; empty if face f is the cell loose_count() + f.
    const std::vector<vtkIdType> &cells() const { return cells_; }
    /// The cell that a face is of.
    vtkIdType cell(std::size_t face) const {
        return cells_.empty() ? loose_count() + static_cast<vtkIdType>(face) : cells_[face];
    }

private:
    void copy_points(int type);
    void copy_polygons();
    void add_strips();
    uint32_t index(vtkIdType id, vtkIdType cell) const;

    std::string name_;
    vtkSmartPointer<vtkPolyData> data_;
    vtkSmartPointer<vtkDataArray> points_;
    std::vector<uint32_t> offsets_, corners_;
    std::vector<vtkIdType> cells_;
    gusset_mesh_view view_;
};

/// The pieces as one call of the library takes them, which wants one type of coordinates: doubles,
/// if not all are floats.
std::vector<gusset::MeshView> views_of(std::vector<Piece> &pieces);

/// A call of the library on pieces. Its errors name cells of VTK beside the library's faces, and of many pieces the one that they are
/// about.
void with_names(const std::vector<Piece> &pieces, const std::function<void()> &call);

/// Fills `output` with a result and all that its pieces have: vertices and lines, arrays of points and cells. `vertices`: of each
/// piece its points in the result, empty if they keep their numbers. `precision`: one of vtkAlgorithm::DesiredPrecision.
void build(vtkPolyData *output, const gusset::MeshView &mesh, const gusset::Origins &origins, const std::vector<Piece> &pieces,
           const std::vector<gusset::Indices> &vertices, int precision, const Run &run);

} // namespace gusset_vtk

#endif // GUSSET_VTK_POLYDATA_HPP
