// The filters in a pipeline: errors, progress, abort, repeated execution, threads.
#include "shapes.hpp"

#include "vtkGussetAssemble.h"
#include "vtkGussetFill.h"
#include "vtkGussetStitch.h"

#include <vtkPartitionedDataSet.h>

#include <doctest/doctest.h>

#include <limits>
#include <sstream>
#include <thread>

namespace {

vtkPolyData *output(vtkAlgorithm *filter) {
    return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}
bool has(const std::string &text, const std::string &part) {
    CAPTURE(text);
    const bool found = text.find(part) != std::string::npos;
    CHECK(found);
    return found;
}

} // namespace

TEST_CASE("errors are heard with the element, and leave nothing behind") {
    const auto data = tube({});
    data->GetPoints()->SetPoint(37, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
    vtkNew<vtkGussetFill> fill;
    Messages heard(fill);
    fill->SetInputData(data);
    fill->Update();
    CHECK(has(heard.errors, "vertex 37"));
    CHECK(output(fill)->GetNumberOfPoints() == 0);
    // Repaired, it runs again.
    heard.errors.clear();
    const auto good = tube({});
    fill->SetInputData(good);
    fill->Update();
    CHECK(heard.errors.empty());
    CHECK(open_edges(output(fill)) == 0);

    // Which of many pieces it is.
    vtkNew<vtkPartitionedDataSet> parts;
    parts->SetPartition(0, good);
    parts->SetPartition(1, data);
    fill->SetInputData(parts);
    fill->Update();
    CHECK(has(heard.errors, "partition 1: "));
    CHECK(has(heard.errors, "vertex 37"));
    vtkNew<vtkGussetAssemble> assemble;
    const Messages of_assembly(assemble);
    assemble->SetInputData(parts);
    assemble->Update();
    CHECK(has(of_assembly.errors, "input 0, partition 1: vertex 37"));
    CHECK(assemble->GetOutput()->GetNumberOfPoints() == 0);

    vtkNew<vtkGussetStitch> stitch;
    const Messages of_stitch(stitch);
    stitch->SetInputData(0, parts);
    stitch->SetInputData(1, good);
    stitch->Update();
    CHECK(has(of_stitch.errors, "vtkGussetAssemble"));
}

TEST_CASE("cells that are broken are named by their ids") {
    for (const bool narrow : {false, true}) {
        for (const vtkIdType id : {vtkIdType{60}, vtkIdType{-1}}) {
            CAPTURE(narrow);
            CAPTURE(id);
            Tube shape;
            shape.narrow_ids = narrow;
            const auto data = tube(shape);
            const vtkIdType bad[3] = {0, 1, id}, vertex = 0;
            data->GetPolys()->InsertNextCell(3, bad);
            vtkNew<vtkCellArray> vertices;
            vertices->InsertNextCell(1, &vertex);
            data->SetVerts(vertices);
            vtkNew<vtkGussetFill> fill;
            const Messages heard(fill);
            fill->SetInputData(data);
            fill->Update();
            // A vertex, 48 quads, and this.
            const bool refused_here = !narrow && id < 0;
            CHECK(has(heard.errors, refused_here ? "cell 49 has the point id -1" : id < 0 ? "4294967295" : "60"));
            CHECK(output(fill)->GetNumberOfPoints() == 0);
        }
    }
    const auto data = tube({});
    const vtkIdType bad[2] = {0, 5}, vertex = 0;
    data->GetPolys()->InsertNextCell(2, bad);
    vtkNew<vtkCellArray> vertices;
    vertices->InsertNextCell(1, &vertex);
    data->SetVerts(vertices);
    vtkNew<vtkGussetFill> fill;
    const Messages heard(fill);
    fill->SetInputData(data);
    fill->Update();
    CHECK(has(heard.errors, "face 48"));
    CHECK(has(heard.errors, "(cell 49)"));
}

TEST_CASE("cells that are broken are named with their input") {
    Tube upper;
    upper.from = 1.2;
    const auto good = tube({}), polygon = tube(upper), line = tube(upper);
    const vtkIdType triangle[3] = {0, 1, -5}, segment[2] = {0, 60};
    polygon->GetPolys()->InsertNextCell(3, triangle);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(2, segment);
    line->SetLines(lines);
    vtkNew<vtkPolyData> pointless;
    pointless->SetPolys(good->GetPolys());
    const std::pair<vtkPolyData *, const char *> all[] = {{polygon, "input 1: cell 48 has the point id -5"},
                                                          {line, "input 1: a vertex or a line has"},
                                                          {pointless, "input 1: there are no points"}};
    for (const auto &[bad, sentence] : all) {
        vtkNew<vtkGussetAssemble> assemble;
        vtkNew<vtkGussetStitch> stitch;
        assemble->AddInputData(good);
        assemble->AddInputData(bad);
        stitch->SetInputData(0, good);
        stitch->SetInputData(1, bad);
        for (vtkAlgorithm *filter : std::vector<vtkAlgorithm *>{assemble, stitch}) {
            const Messages heard(filter);
            filter->Update();
            CHECK(has(heard.errors, sentence));
            CHECK(output(filter)->GetNumberOfPoints() == 0);
        }
    }
}

TEST_CASE("progress never goes back, and ends at 1") {
    vtkNew<vtkPartitionedDataSet> parts;
    for (unsigned i = 0; i < 3; ++i) {
        Tube shape;
        shape.around = 100;
        const auto data = tube(shape);
        give_arrays(data);
        parts->SetPartition(i, data);
    }
    vtkNew<vtkGussetFill> fill;
    fill->SetInputData(parts);
    fill->RefineOn();
    std::vector<double> seen;
    const Listener listener(fill, vtkCommand::ProgressEvent, [&](const char *) { seen.push_back(fill->GetProgress()); });
    fill->Update();
    REQUIRE(seen.size() > 4);
    CHECK(std::is_sorted(seen.begin(), seen.end()));
    CHECK(seen.back() == 1.0);
    CHECK(std::count_if(seen.begin(), seen.end(), [](double part) { return part > 0.3 && part < 0.7; }) > 0);
}

TEST_CASE("an abort ends the run without an error, and the next one is whole") {
    Tube shape;
    shape.around = 3000;
    shape.rows = 2;
    const auto data = tube(shape);
    for (const double when : {0.0, 0.1}) {
        vtkNew<vtkGussetFill> fill;
        const Messages heard(fill);
        fill->SetInputData(data);
        fill->RefineOn();
        bool asked = false;
        double reached = 0.0;
        {
            const Listener listener(fill, vtkCommand::ProgressEvent, [&](const char *) {
                if (fill->GetProgress() >= when && fill->GetProgress() < 1.0) {
                    asked = true;
                    reached = std::max(reached, fill->GetProgress());
                    fill->SetAbortExecute(1);
                }
            });
            fill->Update();
        }
        REQUIRE(asked);
        CHECK(heard.errors.empty());
        CHECK(output(fill)->GetNumberOfPoints() == 0);
        // The call is cancelled, not waited for.
        CHECK(reached < 0.9);
        fill->SetMaxEdges(100);
        fill->Update();
        CHECK(output(fill)->GetNumberOfPolys() == 6000);
    }
}

TEST_CASE("a filter runs again when its options or its input change, and only then") {
    const auto data = tube({});
    vtkNew<vtkGussetFill> fill;
    vtkNew<vtkGussetStitch> stitch;
    vtkNew<vtkGussetAssemble> assemble;
    const auto count_runs = [&](auto *filter, auto &&change) {
        int runs = 0;
        filter->SetInputDataObject(data);
        const Listener listener(filter, vtkCommand::StartEvent, [&](const char *) { ++runs; });
        filter->Update();
        CHECK(runs == 1);
        filter->Update();
        CHECK(runs == 1);
        change(filter);
        filter->Update();
        CHECK(runs == 2);
        // Setting an equal value is not a change.
        change(filter);
        filter->Update();
        CHECK(runs == 2);
        data->Modified();
        filter->Update();
        CHECK(runs == 3);
    };
    count_runs(fill.Get(), [](vtkGussetFill *filter) { filter->SetKeepToLongest(); });
    CHECK(open_edges(output(fill)) == 12);
    count_runs(stitch.Get(), [](vtkGussetStitch *filter) { filter->SetRows(2); });
    CHECK(output(stitch)->GetNumberOfPoints() == 60 + 2 * 24);
    count_runs(assemble.Get(), [](vtkGussetAssemble *filter) { filter->FillHolesOn(); });
    CHECK(open_edges(output(assemble)) == 0);
    for (vtkAlgorithm *filter : std::vector<vtkAlgorithm *>{fill, stitch, assemble}) {
        std::ostringstream text;
        filter->Print(text);
        CHECK(has(text.str(), "NumberOfThreads: 0"));
    }
}

TEST_CASE("filters on many threads give the bytes of one") {
    const auto data = tube({});
    give_arrays(data);
    std::vector<vtkSmartPointer<vtkGussetFill>> filters(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < filters.size(); ++i) {
        filters[i] = vtkSmartPointer<vtkGussetFill>::New();
        // A pipeline of its own each, on arrays that all read.
        vtkNew<vtkPolyData> own;
        own->ShallowCopy(data);
        filters[i]->SetInputData(own);
        filters[i]->RefineOn();
        filters[i]->FairOn();
        filters[i]->SetNumberOfThreads(static_cast<int>(i));
        threads.emplace_back([filter = filters[i].Get()] { filter->Update(); });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    const Soup first(output(filters[0]));
    REQUIRE(first.points.size() > 60);
    for (const auto &filter : filters) {
        const Soup other(output(filter));
        CHECK(other.points == first.points);
        CHECK(other.corners == first.corners);
        for (vtkIdType v = 0; v < output(filter)->GetNumberOfPoints(); ++v) {
            CHECK(output(filter)->GetPointData()->GetScalars()->GetComponent(v, 0) ==
                  output(filters[0])->GetPointData()->GetScalars()->GetComponent(v, 0));
        }
    }
}
