#include "vtkGussetFill.h"

#include "gusset_leaves.hpp"
#include "gusset_polydata.hpp"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkGussetFill);

int vtkGussetFill::FillInputPortInformation(int, vtkInformation *info) {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
    return 1;
}

int vtkGussetFill::RequestData(vtkInformation *, vtkInformationVector **inputs, vtkInformationVector *outputs) {
    vtkDataObject *input = vtkDataObject::GetData(inputs[0], 0);
    vtkDataObject *output = vtkDataObject::GetData(outputs, 0);
    gusset::FillOptions options;
    options.refine = this->Refine ? gusset::FillRefinement::rim_density : gusset::FillRefinement::none;
    options.fairing = this->Refine && this->Fair ? gusset::Fairing::thin_plate : gusset::Fairing::none;
    options.keep = static_cast<gusset::FillKeep>(this->Keep);
    options.max_edges = static_cast<uint32_t>(this->MaxEdges);
    options.max_diameter = this->MaxDiameter;
    options.outward = this->OrientOutwards ? gusset::Outward::closed : gusset::Outward::keep;
    gusset_vtk::Run run(this, this->NumberOfThreads);
    return gusset_vtk::guarded(run, output, [&] {
        gusset_vtk::each_leaf(input, output, run, [&](vtkPolyData *from, vtkPolyData *to) {
            std::vector<gusset_vtk::Piece> pieces;
            pieces.emplace_back(from);
            gusset_vtk::with_names(pieces, [&] {
                const gusset::Fill fill(pieces[0].view(), options, run.context());
                gusset_vtk::build(to, fill.mesh(), fill.origins(run.context()), pieces, {{}}, this->OutputPointsPrecision, run);
            });
        });
    });
}

void vtkGussetFill::PrintSelf(ostream &os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Refine: " << this->Refine << "\n";
    os << indent << "Fair: " << this->Fair << "\n";
    os << indent << "Keep: " << this->Keep << "\n";
    os << indent << "MaxEdges: " << this->MaxEdges << "\n";
    os << indent << "MaxDiameter: " << this->MaxDiameter << "\n";
    os << indent << "OrientOutwards: " << this->OrientOutwards << "\n";
    os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
    os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
