/**
 * @class   vtkGussetFill
 * @brief   fill holes of surfaces, carrying point and cell data
 *
 * Fills the boundary loops of a vtkPolyData, or of each one of a vtkPartitionedDataSet, a vtkPartitionedDataSetCollection or a
 * vtkMultiBlockDataSet; the output is of the type of the input. Old points and cells keep their numbers and values; new points and
 * cells come after them. Patches continue the curvature of the surface around the hole. With Refine they get new
 * points as dense as the rim, and with Fair these lie on a thin plate.
 *
 * Floats, doubles and bytes of new points are interpolated, normals on the sphere. Integers and strings come from the
 * nearest point. New cells have the values of the cell across the nearest edge of the rim. Vertices and lines are
 * kept; strips become
 * triangles.
 *
 * @sa vtkGussetAssemble vtkGussetStitch vtkFillHolesFilter
 */
#ifndef vtkGussetFill_h
#define vtkGussetFill_h

#include "vtkGussetModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"

class VTKGUSSET_EXPORT vtkGussetFill : public vtkPassInputTypeAlgorithm {
public:
    static vtkGussetFill *New();
    vtkTypeMacro(vtkGussetFill, vtkPassInputTypeAlgorithm);
    void PrintSelf(ostream &os, vtkIndent indent) override;

    ///@{
    /**
     * Patches get new points as dense as the rim. Off by default.
     */
    vtkSetMacro(Refine, vtkTypeBool);
    vtkGetMacro(Refine, vtkTypeBool);
    vtkBooleanMacro(Refine, vtkTypeBool);
    ///@}

    ///@{
    /**
     * The new points lie on a thin plate that continues the surface. Read with Refine. Off by default.
     */
    vtkSetMacro(Fair, vtkTypeBool);
    vtkGetMacro(Fair, vtkTypeBool);
    vtkBooleanMacro(Fair, vtkTypeBool);
    ///@}

    enum KeepLoops { KEEP_AUTO = 0, KEEP_NONE = 1, KEEP_LONGEST = 2, KEEP_BORDERS = 3 };
    ///@{
    /**
     * The loops that stay open: outer borders of sheets and of loose faces; none; the longest; or outer borders of
     * sheets and shallow bowls. KEEP_AUTO by default.
     */
    vtkSetClampMacro(Keep, int, KEEP_AUTO, KEEP_BORDERS);
    vtkGetMacro(Keep, int);
    void SetKeepToAuto() { this->SetKeep(KEEP_AUTO); }
    void SetKeepToNone() { this->SetKeep(KEEP_NONE); }
    void SetKeepToLongest() { this->SetKeep(KEEP_LONGEST); }
    void SetKeepToBorders() { this->SetKeep(KEEP_BORDERS); }
    ///@}

    ///@{
    /**
     * Loops with more edges stay open; 0, the default, sets no limit.
     */
    vtkSetClampMacro(MaxEdges, int, 0, VTK_INT_MAX);
    vtkGetMacro(MaxEdges, int);
    ///@}

    ///@{
    /**
     * Loops whose bounding box has a longer diagonal stay open; 0, the default, sets no limit.
     */
    vtkSetClampMacro(MaxDiameter, double, 0.0, VTK_DOUBLE_MAX);
    vtkGetMacro(MaxDiameter, double);
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
     * The precision of the output's points, one of vtkAlgorithm::DesiredPrecision. The default is the precision of
     * the input.
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
    vtkGussetFill() = default;
    ~vtkGussetFill() override = default;

    int FillInputPortInformation(int port, vtkInformation *info) override;
    int RequestData(vtkInformation *request, vtkInformationVector **inputs, vtkInformationVector *outputs) override;

    vtkTypeBool Refine = 0;
    vtkTypeBool Fair = 0;
    int Keep = KEEP_AUTO;
    int MaxEdges = 0;
    double MaxDiameter = 0.0;
    vtkTypeBool OrientOutwards = 0;
    int OutputPointsPrecision = DEFAULT_PRECISION;
    int NumberOfThreads = 0;

private:
    vtkGussetFill(const vtkGussetFill &) = delete;
    void operator=(const vtkGussetFill &) = delete;
};

#endif
