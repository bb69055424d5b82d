#include "vtkGussetAssemble.h"

#include "gusset_leaves.hpp"
#include "gusset_polydata.hpp"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkGussetAssemble);

int vtkGussetAssemble::FillInputPortInformation(int, vtkInformation *info) {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    return 1;
}

int vtkGussetAssemble::RequestData(vtkInformation *, vtkInformationVector **inputs, vtkInformationVector *outputs) {
    vtkPolyData *output = vtkPolyData::GetData(outputs, 0);
    gusset::JoinOptions options;
    if (!this->Weld) {
        options.weld = gusset::Welding::none;
    }
    if (!this->AutomaticMaxGap) {
        options.max_gap = this->MaxGap;
    }
    options.within_components = this->WithinComponents != 0;
    options.strip_options.finish = static_cast<gusset::Finish>(this->Finish);
    if (this->FillHoles) {
        options.fill = true;
        options.fill_options.refine = this->Refine ? gusset::FillRefinement::rim_density : gusset::FillRefinement::none;
        options.fill_options.fairing = this->Refine && this->Fair ? gusset::Fairing::thin_plate : gusset::Fairing::none;
    }
    gusset_vtk::Run run(this, this->NumberOfThreads);
    return gusset_vtk::guarded(run, output, [&] {
        run.section(0.0, 1.0);
        std::vector<gusset_vtk::Piece> pieces;
        for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i) {
            for (const gusset_vtk::Leaf &leaf : gusset_vtk::leaves(vtkDataObject::GetData(inputs[0], i), run)) {
                const std::string name = "input " + std::to_string(i) + (leaf.name.empty() ? "" : ", " + leaf.name);
                if (leaf.data->GetNumberOfPolys() + leaf.data->GetNumberOfStrips() == 0) {
                    // An empty input is valid: a part of a pipeline may be idle.
                    if (leaf.data->GetNumberOfPoints() + leaf.data->GetNumberOfCells() > 0) {
                        vtkWarningMacro(<< name << ", which has no polygons, is left out");
                    }
                    continue;
                }
                pieces.emplace_back(leaf.data, name);
            }
        }
        if (pieces.empty()) {
            return;
        }
        const std::vector<gusset::MeshView> views = gusset_vtk::views_of(pieces);
        gusset_vtk::with_names(pieces, [&] {
            const gusset::Join assembly(views, options, run.context());
            std::vector<gusset::Indices> vertices;
            for (const gusset_piece_map &piece : assembly.pieces()) {
                vertices.push_back(gusset::detail::indices(piece.vertices));
            }
            gusset_vtk::build(output, assembly.mesh(), assembly.origins(run.context()), pieces, vertices, this->OutputPointsPrecision, run);
        });
    });
}

void vtkGussetAssemble::PrintSelf(ostream &os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Finish: " << this->Finish << "\n";
    os << indent << "Weld: " << this->Weld << "\n";
    os << indent << "AutomaticMaxGap: " << this->AutomaticMaxGap << "\n";
    os << indent << "MaxGap: " << this->MaxGap << "\n";
    os << indent << "WithinComponents: " << this->WithinComponents << "\n";
    os << indent << "FillHoles: " << this->FillHoles << "\n";
    os << indent << "Refine: " << this->Refine << "\n";
    os << indent << "Fair: " << this->Fair << "\n";
    os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
    os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
