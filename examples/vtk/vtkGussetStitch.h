/**
 * @class   vtkGussetStitch
 * @brief   join two boundary loops across a gap, carrying point and cell data
 *
 * With one input, joins the two nearest loops of a vtkPolyData, or of each vtkPolyData in a vtkPartitionedDataSet, a
 * vtkPartitionedDataSetCollection or a vtkMultiBlockDataSet. The output has the type of the input. With a
 * vtkPolyData at the second input too, joins that to the first, which must be a vtkPolyData then. Nothing old moves. To join many
 * pieces at once use vtkGussetAssemble.
 *
 * Values of points and cells are carried as vtkGussetFill does it; of two inputs, arrays that both have. Vertices and lines are kept;
 * strips become triangles.
 *
 * @sa vtkGussetAssemble vtkGussetFill
 */
#ifndef vtkGussetStitch_h
#define vtkGussetStitch_h

#include "vtkGussetModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"

class VTKGUSSET_EXPORT vtkGussetStitch : public vtkPassInputTypeAlgorithm {
public:
    static vtkGussetStitch *New();
    vtkTypeMacro(vtkGussetStitch, vtkPassInputTypeAlgorithm);
    void PrintSelf(ostream &os, vtkIndent indent) override;

    enum FinishType { FINISH_STRIP = 0, FINISH_BLEND = 1 };
    ///@{
    /**
     * The faces between the loops: a strip without new points, or a smooth blend with new points.
     * FINISH_STRIP by default.
     */
    vtkSetClampMacro(Finish, int, FINISH_STRIP, FINISH_BLEND);
    vtkGetMacro(Finish, int);
    void SetFinishToStrip() { this->SetFinish(FINISH_STRIP); }
    void SetFinishToBlend() { this->SetFinish(FINISH_BLEND); }
    ///@}

    ///@{
    /**
     * Interior rows of a strip: 0, the default, for none; -1 chooses them so that edges across the strip are about as
     * long as edges along it.
     */
    vtkSetClampMacro(Rows, int, -1, VTK_INT_MAX);
    vtkGetMacro(Rows, int);
    ///@}

    ///@{
    /**
     * The points of interior rows lie on a thin plate that continues the surface. Read with Rows. Off by default.
     */
    vtkSetMacro(Fair, vtkTypeBool);
    vtkGetMacro(Fair, vtkTypeBool);
    vtkBooleanMacro(Fair, vtkTypeBool);
    ///@}

    ///@{
    /**
     * Closed components of the result face outwards. Off by default.
     */
    vtkSetMacro(OrientOutwards, vtkTypeBool);
    vtkGetMacro(OrientOutwards, vtkTypeBool);
    vtkBooleanMacro(OrientOutwards, vtkTypeBool);
    ///@}

    ///@{
    /**
     * The precision of the output's points, one of vtkAlgorithm::DesiredPrecision. By default single if all inputs' are.
     */
    vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
    vtkGetMacro(OutputPointsPrecision, int);
    ///@}

    ///@{
    /**
     * How many threads compute, on which the result does not depend. 0, the default, is as many as the machine has.
     */
    vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
    vtkGetMacro(NumberOfThreads, int);
    ///@}

protected:
    vtkGussetStitch();
    ~vtkGussetStitch() override = default;

    int FillInputPortInformation(int port, vtkInformation *info) override;
    int RequestData(vtkInformation *request, vtkInformationVector **inputs, vtkInformationVector *outputs) override;

    int Finish = FINISH_STRIP;
    int Rows = 0;
    vtkTypeBool Fair = 0;
    vtkTypeBool OrientOutwards = 0;
    int OutputPointsPrecision = DEFAULT_PRECISION;
    int NumberOfThreads = 0;

private:
    vtkGussetStitch(const vtkGussetStitch &) = delete;
    void operator=(const vtkGussetStitch &) = delete;
};

#endif
