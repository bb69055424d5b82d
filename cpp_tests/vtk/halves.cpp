// Two halves of a sphere with a gap between them, each with a hole at its pole: halves left.vtp right.vtp
#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkXMLPolyDataWriter.h>

int main(int argc, char **argv) {
    if (argc != 3) {
        return 2;
    }
    for (const int half : {0, 1}) {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetThetaResolution(24);
        sphere->SetPhiResolution(16);
        sphere->SetStartPhi(half == 0 ? 20 : 95);
        sphere->SetEndPhi(half == 0 ? 85 : 160);
        vtkNew<vtkXMLPolyDataWriter> writer;
        writer->SetInputConnection(sphere->GetOutputPort());
        writer->SetFileName(argv[half + 1]);
        if (writer->Write() != 1) {
            return 1;
        }
    }
    return 0;
}
