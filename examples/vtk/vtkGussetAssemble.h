/**
 * @class   vtkGussetAssemble
 * @brief   join all pieces of the inputs to one surface, carrying point and cell data
 *
 * Takes any number of connections: each a vtkPolyData, a vtkPartitionedDataSet, a vtkPartitionedDataSetCollection or a
 * vtkMultiBlockDataSet. All their vtkPolyData become one. Coincident borders are sewn. Loops that face each other
 * across a gap are joined by a strip or a blend. With FillHoles, the remaining holes are filled.
 *
 * Values of points and cells are carried as vtkGussetFill does it, of arrays that all pieces have. Vertices and lines are kept;
 * strips become triangles. The output has the field data of the first input. A vtkPolyData without polygons is left
 * out, with a warning.
 *
 * @sa vtkGussetFill vtkGussetStitch vtkAppendPolyData
 */
#ifndef vtkGussetAssemble_h
#define vtkGussetAssemble_h

#include "vtkGussetModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKGUSSET_EXPORT vtkGussetAssemble : public vtkPolyDataAlgorithm {
public:
    static vtkGussetAssemble *New();
    vtkTypeMacro(vtkGussetAssemble, vtkPolyDataAlgorithm);
    void PrintSelf(ostream &os, vtkIndent indent) override;

    enum FinishType { FINISH_STRIP = 0, FINISH_BLEND = 1 };
    ///@{
    /**
     * The faces between the loops: strips without new points, or smooth blends with new points.
     * FINISH_STRIP by default.
     */
    vtkSetClampMacro(Finish, int, FINISH_STRIP, FINISH_BLEND);
    vtkGetMacro(Finish, int);
    void SetFinishToStrip() { this->SetFinish(FINISH_STRIP); }
    void SetFinishToBlend() { this->SetFinish(FINISH_BLEND); }
    ///@}

    ///@{
    /**
     * Borders that coincide are sewn, up to what rounding can have done to them. On by default.
     */
    vtkSetMacro(Weld, vtkTypeBool);
    vtkGetMacro(Weld, vtkTypeBool);
    vtkBooleanMacro(Weld, vtkTypeBool);
    ///@}

    ///@{
    /**
     * The widest gap follows from the size of the loops; off, it is MaxGap. On by default.
     */
    vtkSetMacro(AutomaticMaxGap, vtkTypeBool);
    vtkGetMacro(AutomaticMaxGap, vtkTypeBool);
    vtkBooleanMacro(AutomaticMaxGap, vtkTypeBool);
    ///@}

    ///@{
    /**
     * The widest gap that is closed, in the unit of the points; 0, the default, leaves all open. Read without AutomaticMaxGap.
     */
    vtkSetClampMacro(MaxGap, double, 0.0, VTK_DOUBLE_MAX);
    vtkGetMacro(MaxGap, double);
    ///@}

    ///@{
    /**
     * Loops of one component may be joined to each other. Off by default.
     */
    vtkSetMacro(WithinComponents, vtkTypeBool);
    vtkGetMacro(WithinComponents, vtkTypeBool);
    vtkBooleanMacro(WithinComponents, vtkTypeBool);
    ///@}

    ///@{
    /**
     * The holes that are left in the end are filled; with Refine and Fair as vtkGussetFill does it. All off by default.
     */
    vtkSetMacro(FillHoles, vtkTypeBool);
    vtkGetMacro(FillHoles, vtkTypeBool);
    vtkBooleanMacro(FillHoles, vtkTypeBool);
    vtkSetMacro(Refine, vtkTypeBool);
    vtkGetMacro(Refine, vtkTypeBool);
    vtkBooleanMacro(Refine, vtkTypeBool);
    vtkSetMacro(Fair, vtkTypeBool);
    vtkGetMacro(Fair, vtkTypeBool);
    vtkBooleanMacro(Fair, vtkTypeBool);
    ///@}

    ///@{
    /**
     * The precision of the output's points, one of vtkAlgorithm::DesiredPrecision. By default single if all pieces' are.
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
    vtkGussetAssemble() = default;
    ~vtkGussetAssemble() override = default;

    int FillInputPortInformation(int port, vtkInformation *info) override;
    int RequestData(vtkInformation *request, vtkInformationVector **inputs, vtkInformationVector *outputs) override;

    int Finish = FINISH_STRIP;
    vtkTypeBool Weld = 1;
    vtkTypeBool AutomaticMaxGap = 1;
    double MaxGap = 0.0;
    vtkTypeBool WithinComponents = 0;
    vtkTypeBool FillHoles = 0;
    vtkTypeBool Refine = 0;
    vtkTypeBool Fair = 0;
    int OutputPointsPrecision = DEFAULT_PRECISION;
    int NumberOfThreads = 0;

private:
    vtkGussetAssemble(const vtkGussetAssemble &) = delete;
    void operator=(const vtkGussetAssemble &) = delete;
};

#endif
