// What the filters share: arrays of points and cells, carried over to results.
#ifndef GUSSET_VTK_ARRAYS_HPP
#define GUSSET_VTK_ARRAYS_HPP

#include "gusset_polydata.hpp"

namespace gusset_vtk {

/// Arrays of points, carried to the points of the output. Floats, doubles and bytes are mixed by the weights of the library,
/// normals on the sphere; integers, strings, ghost flags and ids are those of the source that counts most. Of many pieces, arrays
/// that not all of them have, with the same type and number of components, are left behind with a warning.
void carry_points(vtkPolyData *output, const gusset::Origins &origins, const std::vector<Piece> &pieces, const Run &run);

/// The same of arrays of cells. The output's vertices and lines come first and have their own values.
void carry_cells(vtkPolyData *output, const gusset::Origins &origins, const std::vector<Piece> &pieces, const Run &run);

} // namespace gusset_vtk

#endif // GUSSET_VTK_ARRAYS_HPP
