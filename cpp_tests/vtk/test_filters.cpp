// Compares the filters with the library on equal arrays; composite data sets; data sets that are not surfaces.
#include "shapes.hpp"

#include "vtkGussetAssemble.h"
#include "vtkGussetFill.h"
#include "vtkGussetStitch.h"

#include <gusset_polydata.hpp>

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>

#include <doctest/doctest.h>

TEST_CASE("points and ids are read where they are") {
    for (const int scalar : {VTK_FLOAT, VTK_DOUBLE}) {
        Tube shape;
        shape.scalar = scalar;
        shape.narrow_ids = true;
        const auto data = tube(shape);
        const gusset_vtk::Piece piece(data);
        CHECK(piece.view().get().positions == data->GetPoints()->GetVoidPointer(0));
        CHECK(piece.view().get().face_corners == data->GetPolys()->GetConnectivityArray32()->GetVoidPointer(0));
        CHECK(piece.view().get().face_offsets == data->GetPolys()->GetOffsetsArray32()->GetVoidPointer(0));
        CHECK(piece.view().face_count() == 48);
    }
}

TEST_CASE("filled as the library fills") {
    for (const int scalar : {VTK_FLOAT, VTK_DOUBLE}) {
        for (const bool narrow : {false, true}) {
            for (const bool smooth : {false, true}) {
                Tube shape;
                shape.scalar = scalar;
                shape.narrow_ids = narrow;
                const auto data = tube(shape);
                vtkNew<vtkGussetFill> filter;
                filter->SetInputData(data);
                filter->SetRefine(smooth);
                filter->SetFair(smooth);
                filter->OrientOutwardsOn();
                filter->Update();
                auto *made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
                gusset::FillOptions options;
                options.refine = smooth ? gusset::FillRefinement::rim_density : gusset::FillRefinement::none;
                options.fairing = smooth ? gusset::Fairing::thin_plate : gusset::Fairing::none;
                options.outward = gusset::Outward::closed;
                const Soup soup(data);
                const gusset::Fill fill(soup.view(), options);
                REQUIRE(fill.holes().size() == 2);
                CHECK((scalar == VTK_FLOAT ? equals<float>(made, fill.mesh()) : equals<double>(made, fill.mesh())));
                CHECK(made->GetPoints()->GetDataType() == scalar);
                CHECK(made->GetPolys()->IsStorage64Bit() != narrow);
                CHECK(open_edges(data) == 24);
                CHECK(open_edges(made) == 0);
            }
        }
    }
}

TEST_CASE("options of filling reach the library") {
    const auto data = tube({});
    const auto filled = [&](auto &&set) {
        vtkNew<vtkGussetFill> filter;
        filter->SetInputData(data);
        set(filter.Get());
        filter->Update();
        return open_edges(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)));
    };
    CHECK(filled([](vtkGussetFill *filter) { filter->SetMaxEdges(11); }) == 24);
    CHECK(filled([](vtkGussetFill *filter) { filter->SetMaxEdges(12); }) == 0);
    CHECK(filled([](vtkGussetFill *filter) { filter->SetMaxDiameter(1.3); }) == 24);
    CHECK(filled([](vtkGussetFill *filter) { filter->SetMaxDiameter(1.5); }) == 0);
    CHECK(filled([](vtkGussetFill *filter) { filter->SetKeepToLongest(); }) == 12);
    vtkNew<vtkGussetFill> doubled;
    doubled->SetInputData(tube([] { Tube shape; shape.scalar = VTK_FLOAT; return shape; }()));
    doubled->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    doubled->Update();
    CHECK(vtkPolyData::SafeDownCast(doubled->GetOutputDataObject(0))->GetPoints()->GetDataType() == VTK_DOUBLE);
}

TEST_CASE("stitched as the library stitches: two inputs, and one") {
    Tube upper;
    upper.from = 1.2;
    upper.around = 17;
    const auto a = tube({}), b = tube(upper);
    for (const bool blend : {false, true}) {
        vtkNew<vtkGussetStitch> filter;
        filter->SetInputData(0, a);
        filter->SetInputData(1, b);
        filter->SetFinish(blend ? vtkGussetStitch::FINISH_BLEND : vtkGussetStitch::FINISH_STRIP);
        filter->SetRows(2);
        filter->FairOn();
        filter->Update();
        gusset::StitchOptions options;
        options.finish = blend ? gusset::Finish::blend : gusset::Finish::strip;
        if (!blend) {
            options.row_count = 2;
            options.fairing = gusset::Fairing::thin_plate;
        }
        const Soup first(a), second(b);
        const gusset::Stitch stitch = gusset::stitch(first.view(), second.view(), options);
        auto *made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
        CHECK(equals<double>(made, stitch.mesh()));
        CHECK(made->GetNumberOfPoints() > a->GetNumberOfPoints() + b->GetNumberOfPoints());
        CHECK(open_edges(made) == 12 + 17);
    }
    vtkNew<vtkGussetStitch> filter;
    filter->SetInputData(a);
    filter->Update();
    const Soup soup(a);
    auto *made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    const gusset::Stitch within = gusset::stitch_within(soup.view());
    CHECK(equals<double>(made, within.mesh()));
    CHECK(open_edges(made) == 0);
}

TEST_CASE("assembled as the library assembles: connections, and all of one") {
    std::vector<vtkSmartPointer<vtkPolyData>> tubes;
    vtkNew<vtkPartitionedDataSet> parts;
    for (int i = 0; i < 3; ++i) {
        Tube shape;
        // The second begins where the first ends; between it and the third is a gap.
        shape.from = i == 2 ? 2.4 : i;
        tubes.push_back(tube(shape));
        parts->SetPartition(static_cast<unsigned>(i), tubes.back());
    }
    gusset::JoinOptions options;
    options.strip_options.finish = gusset::Finish::blend;
    options.fill = true;
    const std::vector<Soup> soups{Soup(tubes[0]), Soup(tubes[1]), Soup(tubes[2])};
    const std::vector<gusset::MeshView> views{soups[0].view(), soups[1].view(), soups[2].view()};
    const gusset::Join assembly(views, options);
    REQUIRE(assembly.mesh().vertex_count() > 3 * 60 - 12);
    for (const bool composite : {false, true}) {
        vtkNew<vtkGussetAssemble> filter;
        if (composite) {
            filter->SetInputData(parts);
        } else {
            for (const auto &data : tubes) {
                filter->AddInputData(data);
            }
        }
        filter->SetFinishToBlend();
        filter->FillHolesOn();
        filter->Update();
        CHECK(equals<double>(filter->GetOutput(), assembly.mesh()));
        CHECK(open_edges(filter->GetOutput()) == 0);
    }
    vtkNew<vtkGussetAssemble> apart;
    apart->SetInputData(parts);
    apart->WeldOff();
    apart->AutomaticMaxGapOff();
    apart->Update();
    CHECK(open_edges(apart->GetOutput()) == 6 * 12);
    apart->SetMaxGap(0.5);
    apart->Update();
    CHECK(open_edges(apart->GetOutput()) == 2 * 12);
}

TEST_CASE("each partition is closed, and the composite keeps its shape") {
    Tube wide;
    wide.from = 3;
    wide.scalar = VTK_FLOAT;
    const auto a = tube({}), b = tube(wide);
    vtkNew<vtkPolyData> nothing;
    vtkNew<vtkPartitionedDataSet> parts;
    parts->SetPartition(0, a);
    parts->SetPartition(2, b);
    parts->SetPartition(3, nothing);
    for (const bool stitch : {false, true}) {
        vtkSmartPointer<vtkAlgorithm> filter = vtkSmartPointer<vtkGussetFill>::New();
        if (stitch) {
            filter = vtkSmartPointer<vtkGussetStitch>::New();
        }
        filter->SetInputDataObject(parts);
        filter->Update();
        auto *made = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
        REQUIRE(made != nullptr);
        REQUIRE(made->GetNumberOfPartitions() == 4);
        CHECK(made->GetPartition(1) == nullptr);
        for (const unsigned i : {0U, 2U}) {
            auto *closed = vtkPolyData::SafeDownCast(made->GetPartition(i));
            REQUIRE(closed != nullptr);
            CHECK(closed->GetNumberOfPolys() > 48);
            CHECK(open_edges(closed) == 0);
        }
        CHECK(vtkPolyData::SafeDownCast(made->GetPartition(3))->GetNumberOfCells() == 0);
        CHECK(a->GetNumberOfPolys() == 48);
    }
    vtkNew<vtkPartitionedDataSetCollection> collection;
    collection->SetPartitionedDataSet(0, parts);
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, a);
    blocks->GetMetaData(0U)->Set(vtkCompositeDataSet::NAME(), "stem");
    vtkNew<vtkImageData> image;
    blocks->SetBlock(1, image);
    for (vtkDataObject *input : {static_cast<vtkDataObject *>(collection), static_cast<vtkDataObject *>(blocks)}) {
        vtkNew<vtkGussetFill> filter;
        const Messages heard(filter);
        filter->SetInputDataObject(input);
        filter->Update();
        vtkDataObject *made = filter->GetOutputDataObject(0);
        REQUIRE(std::string(made->GetClassName()) == input->GetClassName());
        if (auto *as_blocks = vtkMultiBlockDataSet::SafeDownCast(made)) {
            CHECK(open_edges(vtkPolyData::SafeDownCast(as_blocks->GetBlock(0))) == 0);
            CHECK(std::string(as_blocks->GetMetaData(0U)->Get(vtkCompositeDataSet::NAME())) == "stem");
            CHECK(as_blocks->GetBlock(1)->IsA("vtkImageData"));
            CHECK(heard.warnings.find("vtkImageData") != std::string::npos);
        } else {
            auto *inner = vtkPartitionedDataSetCollection::SafeDownCast(made)->GetPartitionedDataSet(0);
            CHECK(open_edges(vtkPolyData::SafeDownCast(inner->GetPartition(2))) == 0);
            CHECK(heard.warnings.empty());
        }
    }
}

TEST_CASE("pieces of floats beside pieces of doubles are joined in doubles") {
    Tube upper;
    upper.from = 1.2;
    upper.scalar = VTK_FLOAT;
    const auto a = tube({}), b = tube(upper);
    const Soup first(a);
    Soup second(b);
    second.is_single = false;
    vtkNew<vtkGussetStitch> stitch;
    stitch->SetInputData(0, b);
    stitch->SetInputData(1, a);
    stitch->Update();
    auto *stitched = vtkPolyData::SafeDownCast(stitch->GetOutputDataObject(0));
    const gusset::Stitch wanted = gusset::stitch(second.view(), first.view());
    REQUIRE(equals<double>(stitched, wanted.mesh()));
    CHECK(stitched->GetPoints()->GetDataType() == VTK_DOUBLE);
    vtkNew<vtkGussetAssemble> assemble;
    assemble->AddInputData(a);
    assemble->AddInputData(b);
    assemble->Update();
    const std::vector<gusset::MeshView> views{first.view(), second.view()};
    const gusset::Join assembly(views);
    REQUIRE(equals<double>(assemble->GetOutput(), assembly.mesh()));
    CHECK(assemble->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE);
    CHECK(open_edges(assemble->GetOutput()) == 24);
}

TEST_CASE("coordinates of other types and layouts") {
    const auto data = tube({});
    vtkNew<vtkSOADataArrayTemplate<double>> apart;
    apart->SetNumberOfComponents(3);
    apart->SetNumberOfTuples(data->GetNumberOfPoints());
    for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) {
        apart->SetTuple(v, data->GetPoint(v));
    }
    vtkNew<vtkPolyData> other;
    other->SetPolys(data->GetPolys());
    vtkNew<vtkPoints> points;
    points->SetData(apart);
    other->SetPoints(points);
    vtkNew<vtkGussetFill> filter;
    filter->SetInputData(other);
    filter->Update();
    const Soup soup(data);
    const gusset::Fill fill(soup.view());
    CHECK(equals<double>(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)), fill.mesh()));

    vtkNew<vtkPoints> whole;
    whole->SetDataType(VTK_INT);
    for (const double z : {0.0, 5.0}) {
        whole->InsertNextPoint(0, 0, z);
        whole->InsertNextPoint(5, 0, z);
        whole->InsertNextPoint(0, 5, z);
    }
    vtkNew<vtkCellArray> sides;
    for (vtkIdType k = 0; k < 3; ++k) {
        const vtkIdType next = (k + 1) % 3, quad[4] = {k, next, next + 3, k + 3};
        sides->InsertNextCell(4, quad);
    }
    vtkNew<vtkPolyData> prism;
    prism->SetPoints(whole);
    prism->SetPolys(sides);
    filter->SetInputData(prism);
    filter->Update();
    auto *made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    CHECK(open_edges(made) == 0);
    CHECK(made->GetPoint(5)[1] == 5.0);
}

TEST_CASE("strips are read as triangles, and vertices and lines are kept") {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    // Round a prism of five sides, bottom and top in turn.
    vtkNew<vtkCellArray> strips, vertices, lines, polygons;
    std::vector<vtkIdType> strip;
    for (int k = 0; k < 5; ++k) {
        for (const double z : {0.0, 1.0}) {
            strip.push_back(points->InsertNextPoint(std::cos(1.256 * k), std::sin(1.256 * k), z));
        }
    }
    // Four sides are a strip, the fifth a polygon.
    strips->InsertNextCell(10, strip.data());
    const vtkIdType fifth[4] = {9, 1, 0, 8}, line[3] = {0, 4, 10}, vertex = 10;
    polygons->InsertNextCell(4, fifth);
    points->InsertNextPoint(0, 0, 7);
    lines->InsertNextCell(3, line);
    vertices->InsertNextCell(1, &vertex);
    data->SetPoints(points);
    data->SetStrips(strips);
    data->SetPolys(polygons);
    data->SetLines(lines);
    data->SetVerts(vertices);
    vtkNew<vtkIntArray> number;
    number->SetName("number");
    for (const int value : {100, 200, 300, 400}) {
        number->InsertNextValue(value);
    }
    data->GetCellData()->AddArray(number);
    vtkNew<vtkGussetFill> filter;
    filter->SetInputData(data);
    filter->Update();
    auto *made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    CHECK(made->GetNumberOfVerts() == 1);
    CHECK(made->GetNumberOfLines() == 1);
    CHECK(made->GetNumberOfStrips() == 0);
    CHECK(made->GetNumberOfPolys() == 1 + 8 + 3 + 3);
    CHECK(open_edges(made) == 0);
    CHECK(made->GetCell(1)->GetPointId(2) == 10);
    // The triangles agree with VTK's own.
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(data);
    triangles->PassVertsOff();
    triangles->PassLinesOff();
    triangles->Update();
    REQUIRE(triangles->GetOutput()->GetNumberOfPolys() == 2 + 8);
    for (vtkIdType f = 0; f < 8; ++f) {
        for (int k = 0; k < 3; ++k) {
            CHECK(made->GetCell(3 + f)->GetPointId(k) == triangles->GetOutput()->GetCell(2 + f)->GetPointId(k));
        }
    }
    auto *carried = vtkIntArray::SafeDownCast(made->GetCellData()->GetArray("number"));
    REQUIRE(carried != nullptr);
    REQUIRE(carried->GetNumberOfTuples() == made->GetNumberOfCells());
    const int wanted[] = {100, 200, 300, 400, 400, 400, 400, 400, 400, 400, 400};
    for (vtkIdType c = 0; c < 11; ++c) {
        CHECK(carried->GetValue(c) == wanted[c]);
    }
    for (vtkIdType c = 11; c < 17; ++c) {
        CHECK((carried->GetValue(c) == 300 || carried->GetValue(c) == 400));
    }
    // In a result of many pieces, vertices come first, then lines, with indices of the result's points.
    vtkNew<vtkGussetAssemble> both;
    both->AddInputData(data);
    vtkNew<vtkPolyData> moved;
    moved->DeepCopy(data);
    for (vtkIdType v = 0; v < 11; ++v) {
        const double *p = data->GetPoint(v);
        moved->GetPoints()->SetPoint(v, p[0], p[1], p[2] + 1.0);
    }
    both->AddInputData(moved);
    both->Update();
    CHECK(both->GetOutput()->GetNumberOfVerts() == 2);
    CHECK(both->GetOutput()->GetNumberOfLines() == 2);
    CHECK(both->GetOutput()->GetCell(1)->GetPoints()->GetPoint(0)[2] == 8.0);
    CHECK(both->GetOutput()->GetCell(3)->GetPoints()->GetPoint(0)[2] == 1.0);
    CHECK(vtkIntArray::SafeDownCast(both->GetOutput()->GetCellData()->GetArray("number"))->GetValue(2) == 200);
    CHECK(open_edges(both->GetOutput()) == 10);
}

TEST_CASE("empty inputs give empty outputs") {
    vtkNew<vtkPolyData> nothing;
    vtkNew<vtkGussetFill> fill;
    vtkNew<vtkGussetStitch> stitch;
    vtkNew<vtkGussetAssemble> assemble;
    for (vtkAlgorithm *filter : std::vector<vtkAlgorithm *>{fill, stitch, assemble}) {
        const Messages heard(filter);
        filter->SetInputDataObject(nothing);
        filter->Update();
        CHECK(heard.errors.empty());
        CHECK(heard.warnings.empty());
        CHECK(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() == 0);
    }
    vtkNew<vtkPartitionedDataSet> none;
    assemble->SetInputData(none);
    assemble->Update();
    CHECK(assemble->GetOutput()->GetNumberOfPoints() == 0);
    // An empty piece does not disturb the others.
    assemble->SetInputData(nothing);
    assemble->AddInputData(tube({}));
    assemble->Update();
    CHECK(assemble->GetOutput()->GetNumberOfPolys() == 48);
    // Points without cells pass unchanged.
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(tube({})->GetPoints());
    fill->SetInputData(cloud);
    fill->Update();
    CHECK(vtkPolyData::SafeDownCast(fill->GetOutputDataObject(0))->GetNumberOfPoints() == 60);
    // An assembly omits them with a warning.
    const Messages heard(assemble);
    assemble->AddInputData(cloud);
    assemble->Update();
    CHECK(heard.warnings.find("input 2, which has no polygons, is left out") != std::string::npos);
    CHECK(assemble->GetOutput()->GetNumberOfPolys() == 48);
}
