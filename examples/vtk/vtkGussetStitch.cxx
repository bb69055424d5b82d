#include "vtkGussetStitch.h"

#include "gusset_leaves.hpp"
#include "gusset_polydata.hpp"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkGussetStitch);

vtkGussetStitch::vtkGussetStitch() {
    this->SetNumberOfInputPorts(2);
}

int vtkGussetStitch::FillInputPortInformation(int port, vtkInformation *info) {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    if (port == 0) {
        info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
    } else {
        info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    }
    return 1;
}

int vtkGussetStitch::RequestData(vtkInformation *, vtkInformationVector **inputs, vtkInformationVector *outputs) {
    vtkDataObject *input = vtkDataObject::GetData(inputs[0], 0);
    vtkPolyData *second = vtkPolyData::GetData(inputs[1], 0);
    vtkDataObject *output = vtkDataObject::GetData(outputs, 0);
    if (second != nullptr && vtkPolyData::SafeDownCast(input) == nullptr) {
        vtkErrorMacro(<< "with a second input the first must be a vtkPolyData: vtkGussetAssemble joins more");
        output->Initialize();
        return 0;
    }
    gusset::StitchOptions options;
    options.finish = static_cast<gusset::Finish>(this->Finish);
    // A blend reads neither rows nor fairing.
    if (this->Finish == FINISH_STRIP && this->Rows != 0) {
        if (this->Rows < 0) {
            options.rows = gusset::RowRule::mean_edge;
        } else {
            options.row_count = static_cast<uint32_t>(this->Rows);
        }
        options.fairing = this->Fair ? gusset::Fairing::thin_plate : gusset::Fairing::none;
    }
    options.outward = this->OrientOutwards ? gusset::Outward::closed : gusset::Outward::keep;
    gusset_vtk::Run run(this, this->NumberOfThreads);
    const auto join = [&](vtkPolyData *from, vtkPolyData *to) {
        std::vector<gusset_vtk::Piece> pieces;
        pieces.emplace_back(from, second != nullptr ? "input 0" : "");
        if (second != nullptr) {
            pieces.emplace_back(second, "input 1");
        }
        const std::vector<gusset::MeshView> views = gusset_vtk::views_of(pieces);
        gusset_vtk::with_names(pieces, [&] {
            const gusset::Stitch stitch = second != nullptr ? gusset::stitch(views[0], views[1], options, run.context())
                                                            : gusset::stitch_within(views[0], options, run.context());
            std::vector<gusset::Indices> vertices{stitch.vertex_map(0)};
            if (second != nullptr) {
                vertices.push_back(stitch.vertex_map(1));
            }
            gusset_vtk::build(to, stitch.mesh(), stitch.origins(run.context()), pieces, vertices, this->OutputPointsPrecision, run);
        });
    };
    return gusset_vtk::guarded(run, output, [&] {
        if (second != nullptr) {
            run.section(0.0, 1.0);
            join(vtkPolyData::SafeDownCast(input), vtkPolyData::SafeDownCast(output));
        } else {
            gusset_vtk::each_leaf(input, output, run, join);
        }
    });
}

void vtkGussetStitch::PrintSelf(ostream &os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Finish: " << this->Finish << "\n";
    os << indent << "Rows: " << this->Rows << "\n";
    os << indent << "Fair: " << this->Fair << "\n";
    os << indent << "OrientOutwards: " << this->OrientOutwards << "\n";
    os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
    os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
