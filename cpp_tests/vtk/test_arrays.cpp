// Arrays of points and cells, carried over by the filters.
#include "shapes.hpp"

#include "vtkGussetAssemble.h"
#include "vtkGussetFill.h"
#include "vtkGussetStitch.h"

#include <vtkBitArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkLookupTable.h>
#include <vtkSOADataArrayTemplate.h>

#include <doctest/doctest.h>

#include <limits>

namespace {

vtkPolyData *run(vtkAlgorithm *filter) {
    filter->Update();
    auto *made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    REQUIRE(made != nullptr);
    return made;
}

/// Checks all points of a result whose inputs have the arrays of give_arrays(). `first`: how many points are old,
/// that
/// keep their numbers.
void check_points(vtkPolyData *made, vtkPolyData *first) {
    vtkPointData *values = made->GetPointData();
    auto *height = vtkDoubleArray::SafeDownCast(values->GetArray("height"));
    auto *pair = vtkFloatArray::SafeDownCast(values->GetArray("pair"));
    auto *directions = vtkFloatArray::SafeDownCast(values->GetArray("directions"));
    auto *colour = vtkUnsignedCharArray::SafeDownCast(values->GetArray("colour"));
    auto *number = vtkIntArray::SafeDownCast(values->GetArray("number"));
    auto *name = vtkStringArray::SafeDownCast(values->GetAbstractArray("name"));
    auto *global = vtkIdTypeArray::SafeDownCast(values->GetArray("global"));
    REQUIRE((height && pair && directions && colour && number && name && global));
    CHECK(values->GetNumberOfArrays() == 7);
    CHECK(values->GetScalars() == height);
    CHECK(values->GetNormals() == directions);
    // New points share the ids of others, so that they are global no more.
    CHECK(values->GetGlobalIds() == nullptr);
    const vtkIdType count = made->GetNumberOfPoints();
    REQUIRE(count > first->GetNumberOfPoints());
    double off = 0.0, off_pair = 0.0, off_length = 0.0;
    for (vtkIdType v = 0; v < count; ++v) {
        double p[3], d[3];
        made->GetPoint(v, p);
        directions->GetTuple(v, d);
        off = std::max(off, std::abs(height->GetValue(v) - field(p)));
        off_pair = std::max({off_pair, std::abs(pair->GetComponent(v, 0) - p[0]), std::abs(pair->GetComponent(v, 1) + p[2])});
        off_length = std::max(off_length, std::abs(vtkMath::Norm(d) - 1.0));
        CHECK((colour->GetComponent(v, 0) == 10 && colour->GetComponent(v, 2) == 250));
        // The three are of one and the same old point, which has this number.
        const vtkIdType id = global->GetValue(v) - (vtkIdType{1} << 40);
        CHECK(number->GetValue(v) == id - 7);
        CHECK(name->GetValue(v) == "point " + std::to_string(id));
    }
    CHECK(off < 1e-6);
    CHECK(off_pair < 1e-6);
    CHECK(off_length < 1e-6);
    for (vtkIdType v = 0; v < first->GetNumberOfPoints(); ++v) {
        CHECK(number->GetValue(v) == v - 7);
        CHECK(height->GetValue(v) == vtkDoubleArray::SafeDownCast(first->GetPointData()->GetArray("height"))->GetValue(v));
    }
}

/// Checks all cells of the result; the cells before `first` belong to the first input.
void check_cells(vtkPolyData *made, vtkIdType first) {
    auto *part = vtkIntArray::SafeDownCast(made->GetCellData()->GetArray("part"));
    auto *label = vtkStringArray::SafeDownCast(made->GetCellData()->GetAbstractArray("label"));
    auto *area = vtkDoubleArray::SafeDownCast(made->GetCellData()->GetArray("area"));
    REQUIRE((part && label && area));
    CHECK(made->GetCellData()->GetScalars() == area);
    REQUIRE(part->GetNumberOfTuples() == made->GetNumberOfCells());
    for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c) {
        const double number = std::round(10.0 * area->GetValue(c));
        CHECK(label->GetValue(c) == "cell " + std::to_string(static_cast<int>(number)));
        if (c < first) {
            CHECK(part->GetValue(c) == -c);
            CHECK(number == static_cast<double>(c));
        }
    }
}

} // namespace

TEST_CASE("arrays go with a fill, also to new points and cells") {
    for (const int scalar : {VTK_FLOAT, VTK_DOUBLE}) {
        Tube shape;
        shape.scalar = scalar;
        shape.around = 24;
        const auto data = tube(shape);
        give_arrays(data);
        vtkNew<vtkGussetFill> filter;
        filter->SetInputData(data);
        filter->RefineOn();
        vtkPolyData *made = run(filter);
        check_points(made, data);
        check_cells(made, 96);
        CHECK(made->GetNumberOfCells() > 96 + 2 * 22);
        // New cells have the values of cells at the rims: of the first or the last row.
        auto *part = vtkIntArray::SafeDownCast(made->GetCellData()->GetArray("part"));
        for (vtkIdType c = 96; c < made->GetNumberOfCells(); ++c) {
            CHECK((part->GetValue(c) > -24 || part->GetValue(c) <= -72));
        }
        CHECK(made->GetFieldData()->GetAbstractArray("title") != nullptr);
    }
}

TEST_CASE("arrays go with a stitch, and of two inputs each with its own") {
    Tube upper;
    upper.from = 1.3;
    const auto a = tube({}), b = tube(upper);
    give_arrays(a);
    give_arrays(b, 1000);
    vtkNew<vtkGussetStitch> filter;
    filter->SetInputData(0, a);
    filter->SetInputData(1, b);
    filter->SetRows(3);
    vtkPolyData *made = run(filter);
    check_points(made, a);
    check_cells(made, 48);
    auto *part = vtkIntArray::SafeDownCast(made->GetCellData()->GetArray("part"));
    for (vtkIdType c = 0; c < 48; ++c) {
        CHECK(part->GetValue(48 + c) == 1000 - c);
    }
    CHECK(made->GetFieldData()->GetAbstractArray("title") != nullptr);
}

TEST_CASE("arrays go with an assembly; those that not all pieces have stay behind") {
    Tube upper;
    upper.from = 1.1;
    const auto a = tube({}), b = tube(upper);
    give_arrays(a);
    give_arrays(b, 1000);
    vtkNew<vtkGussetAssemble> filter;
    filter->AddInputData(a);
    filter->AddInputData(b);
    filter->SetFinishToBlend();
    {
        const Messages heard(filter);
        vtkPolyData *made = run(filter);
        auto *height = made->GetPointData()->GetArray("height");
        REQUIRE(height != nullptr);
        for (vtkIdType v = 0; v < made->GetNumberOfPoints(); ++v) {
            // Blends are curved: their field is the field of the strip between the rims.
            CHECK(std::abs(height->GetComponent(v, 0) - field(made->GetPoint(v))) < (v < 120 ? 1e-12 : 0.1));
        }
        check_cells(made, 48);
        CHECK(heard.errors.empty());
        CHECK(heard.warnings.empty());
    }
    b->GetPointData()->RemoveArray("number");
    const auto other = array<vtkFloatArray>("area", 1, b->GetNumberOfCells());
    other->Fill(0.0);
    b->GetCellData()->AddArray(other);
    const Messages heard(filter);
    vtkPolyData *made = run(filter);
    CHECK(made->GetPointData()->GetArray("number") == nullptr);
    CHECK(made->GetPointData()->GetAbstractArray("name") != nullptr);
    CHECK(made->GetCellData()->GetArray("area") == nullptr);
    CHECK(heard.warnings.find("the array number is left behind") != std::string::npos);
    CHECK(heard.warnings.find("the array area is left behind") != std::string::npos);
    CHECK(heard.errors.empty());
}

TEST_CASE("polygons after vertices and lines have their own values") {
    const auto data = tube({});
    const vtkIdType line[2] = {3, 7}, vertex = 5;
    vtkNew<vtkCellArray> vertices, lines;
    vertices->InsertNextCell(1, &vertex);
    lines->InsertNextCell(2, line);
    lines->InsertNextCell(2, line);
    data->SetVerts(vertices);
    data->SetLines(lines);
    give_arrays(data);
    vtkNew<vtkGussetFill> filter;
    filter->SetInputData(data);
    vtkPolyData *made = run(filter);
    REQUIRE(made->GetNumberOfCells() == 3 + 48 + 2 * 10);
    check_cells(made, 51);
    auto *part = vtkIntArray::SafeDownCast(made->GetCellData()->GetArray("part"));
    for (vtkIdType c = 51; c < made->GetNumberOfCells(); ++c) {
        // The value of a quad of the first or the last row.
        CHECK(((part->GetValue(c) <= -3 && part->GetValue(c) > -15) || part->GetValue(c) <= -39));
    }
}

TEST_CASE("arrays of other layouts, bits, ghost flags, tables of colours and names of components") {
    const auto data = tube({});
    const vtkIdType count = data->GetNumberOfPoints();
    vtkNew<vtkSOADataArrayTemplate<double>> apart;
    apart->SetName("apart");
    apart->SetNumberOfComponents(2);
    apart->SetNumberOfTuples(count);
    apart->SetComponentName(1, "second");
    const auto bits = array<vtkBitArray>("bits", 1, count);
    const auto ghosts = array<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), 1, count);
    const auto coloured = array<vtkFloatArray>("coloured", 1, count);
    vtkNew<vtkLookupTable> table;
    coloured->SetLookupTable(table);
    for (vtkIdType v = 0; v < count; ++v) {
        const double *p = data->GetPoint(v);
        apart->SetTypedComponent(v, 0, field(p));
        apart->SetTypedComponent(v, 1, -field(p));
        bits->SetValue(v, static_cast<int>(v % 2));
        ghosts->SetValue(v, v % 2 == 0 ? 1 : 16);
        coloured->SetValue(v, 1.0F);
    }
    for (vtkDataArray *each : {static_cast<vtkDataArray *>(apart), static_cast<vtkDataArray *>(bits), static_cast<vtkDataArray *>(ghosts),
                               static_cast<vtkDataArray *>(coloured)}) {
        data->GetPointData()->AddArray(each);
    }
    vtkNew<vtkGussetFill> filter;
    filter->SetInputData(data);
    filter->RefineOn();
    vtkPolyData *made = run(filter);
    REQUIRE(made->GetNumberOfPoints() > count);
    auto *carried = made->GetPointData()->GetArray("apart");
    REQUIRE(carried != nullptr);
    CHECK(std::string(carried->GetComponentName(1)) == "second");
    CHECK(made->GetPointData()->GetArray("coloured")->GetLookupTable() == table);
    for (vtkIdType v = 0; v < made->GetNumberOfPoints(); ++v) {
        CHECK(std::abs(carried->GetComponent(v, 1) + field(made->GetPoint(v))) < 1e-6);
        // Both come from one point, and flags are not averaged.
        const double flag = made->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName())->GetComponent(v, 0);
        CHECK((flag == 1 || flag == 16));
        CHECK(made->GetPointData()->GetArray("bits")->GetComponent(v, 0) == (flag == 1 ? 0 : 1));
    }
}

TEST_CASE("an array that is several attributes stays all of them; units stay") {
    const auto data = tube({});
    give_arrays(data);
    // Normals that are coloured by and drawn as arrows.
    vtkPointData *values = data->GetPointData();
    values->SetActiveScalars("directions");
    values->SetActiveVectors("directions");
    values->GetArray("height")->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "mm");
    vtkNew<vtkGussetFill> filter;
    filter->SetInputData(data);
    filter->RefineOn();
    vtkPolyData *made = run(filter);
    vtkDataArray *directions = made->GetPointData()->GetArray("directions");
    REQUIRE(directions != nullptr);
    CHECK(made->GetPointData()->GetScalars() == directions);
    CHECK(made->GetPointData()->GetVectors() == directions);
    CHECK(made->GetPointData()->GetNormals() == directions);
    REQUIRE(made->GetNumberOfPoints() > data->GetNumberOfPoints());
    for (vtkIdType v = 0; v < made->GetNumberOfPoints(); ++v) {
        CHECK(std::abs(vtkMath::Norm(directions->GetTuple(v)) - 1.0) < 1e-6);
    }
    CHECK(std::string(made->GetPointData()->GetArray("height")->GetInformation()->Get(vtkDataArray::UNITS_LABEL())) == "mm");
}

TEST_CASE("values that have no mean are copied, with a warning; broken arrays stay behind") {
    const auto data = tube({});
    const auto holes = array<vtkDoubleArray>("holes", 1, data->GetNumberOfPoints());
    holes->Fill(3.0);
    holes->SetValue(1, std::numeric_limits<double>::quiet_NaN());
    const auto few = array<vtkDoubleArray>("few", 1, 5);
    few->Fill(1.0);
    data->GetPointData()->AddArray(holes);
    data->GetPointData()->AddArray(few);
    vtkNew<vtkGussetFill> filter;
    const Messages heard(filter);
    filter->SetInputData(data);
    filter->RefineOn();
    vtkPolyData *made = run(filter);
    auto *carried = vtkDoubleArray::SafeDownCast(made->GetPointData()->GetArray("holes"));
    REQUIRE(carried != nullptr);
    for (vtkIdType v = 0; v < made->GetNumberOfPoints(); ++v) {
        CHECK((carried->GetValue(v) == 3.0 || std::isnan(carried->GetValue(v))));
    }
    CHECK(std::isnan(carried->GetValue(1)));
    CHECK(made->GetPointData()->GetArray("few") == nullptr);
    CHECK(heard.errors.empty());
    CHECK(heard.warnings.find("the array holes is not mixed") != std::string::npos);
    CHECK(heard.warnings.find("the array few is left behind") != std::string::npos);
}

TEST_CASE("normals turn with the piece that is turned over") {
    Tube upper;
    upper.from = 1.2;
    const auto a = tube({}), b = tube(upper);
    give_arrays(a);
    give_arrays(b);
    // The other way round: its faces, and so its normals, face the axis.
    vtkNew<vtkCellArray> turned;
    for (vtkIdType f = 0; f < b->GetNumberOfPolys(); ++f) {
        const vtkIdType quad[4] = {b->GetCell(f)->GetPointId(3), b->GetCell(f)->GetPointId(2), b->GetCell(f)->GetPointId(1),
                                   b->GetCell(f)->GetPointId(0)};
        turned->InsertNextCell(4, quad);
    }
    b->SetPolys(turned);
    auto *inward = b->GetPointData()->GetNormals();
    for (vtkIdType v = 0; v < b->GetNumberOfPoints(); ++v) {
        const double *d = inward->GetTuple(v);
        inward->SetTuple3(v, -d[0], -d[1], -d[2]);
    }
    vtkNew<vtkGussetStitch> filter;
    const Messages heard(filter);
    filter->SetInputData(0, a);
    filter->SetInputData(1, b);
    vtkPolyData *made = run(filter);
    for (vtkIdType v = 0; v < made->GetNumberOfPoints(); ++v) {
        const double *d = made->GetPointData()->GetNormals()->GetTuple(v);
        double p[3];
        made->GetPoint(v, p);
        CHECK(d[0] * p[0] + d[1] * p[1] > 0.49);
    }
    CHECK(heard.warnings.find("turned") != std::string::npos);
}
