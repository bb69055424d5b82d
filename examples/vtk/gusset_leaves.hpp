// Shared by the filters: the data sets within composite ones.
#ifndef GUSSET_VTK_LEAVES_HPP
#define GUSSET_VTK_LEAVES_HPP

#include "gusset_run.hpp"

#include <vtkPolyData.h>

#include <functional>
#include <string>
#include <vector>

namespace gusset_vtk {

/// One vtkPolyData of an input, and what messages call it.
struct Leaf {
    vtkPolyData *data;
    std::string name;
};

/// A vtkPolyData, or all vtkPolyData of a partitioned data set, a collection of partitioned data sets, or blocks.
/// Warns of others.
std::vector<Leaf> leaves(vtkDataObject *input, const Run &run);

/// Makes `output`, of the type of `input`, of it: `work(from, to)` for each vtkPolyData. Data sets without faces pass
/// unchanged; data sets of other types pass with a warning.
void each_leaf(vtkDataObject *input, vtkDataObject *output, Run &run,
               const std::function<void(vtkPolyData *from, vtkPolyData *to)> &work);

} // namespace gusset_vtk

#endif // GUSSET_VTK_LEAVES_HPP
