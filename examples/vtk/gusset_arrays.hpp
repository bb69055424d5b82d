// Shared by the filters: carries arrays of points and cells over to results.
#ifndef GUSSET_VTK_ARRAYS_HPP
#define GUSSET_VTK_ARRAYS_HPP

#include "gusset_polydata.hpp"

namespace gusset_vtk {

/// Arrays of points, carried to the points of the output. Floats, doubles and bytes are averaged by the library's
/// weights, normals on the sphere. Integers, strings, ghost flags and ids come from the source with the largest
/// weight. An array is dropped with a warning if a piece lacks it, or has it with another type or number of
/// components.
void carry_points(vtkPolyData *output, const gusset::Origins &origins, const std::vector<Piece> &pieces, const Run &run);

/// The same of arrays of cells. The output's vertices and lines come first and have their own values.
void carry_cells(vtkPolyData *output, const gusset::Origins &origins, const std::vector<Piece> &pieces, const Run &run);

} // namespace gusset_vtk

#endif // GUSSET_VTK_ARRAYS_HPP
