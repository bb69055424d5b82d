// Joins the pieces of VTK files to one surface and fills what is open:
//   vtk_close out.vtp piece.vtp [piece.vtp ...]
#include "vtkGussetAssemble.h"
#include "vtkGussetFill.h"

#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <vector>

int main(int argc, char **argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: %s out.vtp piece.vtp [piece.vtp ...]\n", argv[0]);
        return 2;
    }
    std::vector<vtkSmartPointer<vtkXMLPolyDataReader>> readers;
    for (int i = 2; i < argc; ++i) {
        readers.push_back(vtkSmartPointer<vtkXMLPolyDataReader>::New());
        readers.back()->SetFileName(argv[i]);
    }
    //! [use]
    vtkNew<vtkGussetAssemble> joined;
    for (vtkXMLPolyDataReader *reader : readers) {
        joined->AddInputConnection(reader->GetOutputPort());
    }
    joined->SetFinishToBlend();
    vtkNew<vtkGussetFill> closed;
    closed->SetInputConnection(joined->GetOutputPort());
    closed->RefineOn();
    closed->FairOn();
    closed->Update();
    //! [use]
    vtkNew<vtkFeatureEdges> open;
    open->SetInputConnection(closed->GetOutputPort());
    open->FeatureEdgesOff();
    open->ManifoldEdgesOff();
    open->NonManifoldEdgesOff();
    open->Update();
    auto *result = vtkPolyData::SafeDownCast(closed->GetOutputDataObject(0));
    std::printf("%d points, %d cells, %d open edges\n", static_cast<int>(result->GetNumberOfPoints()),
                static_cast<int>(result->GetNumberOfCells()), static_cast<int>(open->GetOutput()->GetNumberOfCells()));
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(result);
    writer->SetFileName(argv[1]);
    return writer->Write() == 1 ? 0 : 1;
}
