#include "gusset_polydata.hpp"

#include "gusset_arrays.hpp"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace gusset_vtk {

namespace {

/// Calls `each(count, ids)` for each cell.
template <class Each>
void for_each_cell(vtkCellArray *cells, Each &&each) {
    const auto walk = vtk::TakeSmartPointer(cells->NewIterator());
    for (walk->GoToFirstCell(); !walk->IsDoneWithTraversal(); walk->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType *ids = nullptr;
        walk->GetCurrentCell(count, ids);
        each(count, ids);
    }
}

vtkSmartPointer<vtkPoints> points_of(const gusset::MeshView &mesh, bool single) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
    const auto count = static_cast<vtkIdType>(mesh.vertex_count());
    points->SetNumberOfPoints(count);
    for (vtkIdType v = 0; v < count; ++v) {
        points->SetPoint(v, mesh.position(static_cast<std::size_t>(v)).data());
    }
    return points;
}

template <class Array>
void set_polygons(vtkCellArray *to, const gusset::MeshView &mesh) {
    using Id = typename Array::ValueType;
    vtkNew<Array> offsets, corners;
    const auto count = static_cast<vtkIdType>(mesh.face_count());
    offsets->SetNumberOfValues(count + 1);
    vtkIdType next = 0;
    for (vtkIdType f = 0; f < count; ++f) {
        offsets->SetValue(f, static_cast<Id>(next));
        next += static_cast<vtkIdType>(mesh.face(static_cast<std::size_t>(f)).size());
    }
    offsets->SetValue(count, static_cast<Id>(next));
    corners->SetNumberOfValues(next);
    Id *at = corners->GetPointer(0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        at = std::transform(face.begin(), face.end(), at, [](uint32_t v) { return static_cast<Id>(v); });
    }
    to->SetData(offsets.Get(), corners.Get());
}

/// The vertices, or the lines, of all pieces with their points in the result.
vtkSmartPointer<vtkCellArray> loose_cells(const std::vector<Piece> &pieces, const std::vector<gusset::Indices> &vertices,
                                          vtkCellArray *(vtkPolyData::*of)()) {
    auto made = vtkSmartPointer<vtkCellArray>::New();
    std::vector<vtkIdType> mapped;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const gusset::Indices to = vertices[i];
        for_each_cell((pieces[i].data()->*of)(), [&](vtkIdType count, const vtkIdType *ids) {
            mapped.assign(ids, ids + count);
            for (vtkIdType &id : mapped) {
                if (id < 0 || id >= pieces[i].data()->GetNumberOfPoints()) {
                    throw std::out_of_range(pieces[i].where() + "a vertex or a line has the point id " + std::to_string(id));
                }
                id = to.empty() ? id : static_cast<vtkIdType>(to[static_cast<std::size_t>(id)]);
            }
            made->InsertNextCell(count, mapped.data());
        });
    }
    return made;
}

} // namespace

Piece::Piece(vtkPolyData *data, std::string name)
    : name_(std::move(name)), data_(data), view_(gusset::detail::sized<gusset_mesh_view>()) {
    vtkDataArray *points = data->GetPoints() != nullptr ? data->GetPoints()->GetData() : nullptr;
    if (points == nullptr || points->GetNumberOfTuples() == 0) {
        throw std::invalid_argument(where() + "there are no points");
    }
    points_ = points;
    const bool single = points->GetDataType() == VTK_FLOAT;
    if ((!single && points->GetDataType() != VTK_DOUBLE) || !points->HasStandardMemoryLayout()) {
        copy_points(single ? VTK_FLOAT : VTK_DOUBLE);
    }
    view_.positions = points_->GetVoidPointer(0);
    view_.vertex_count = static_cast<std::size_t>(points_->GetNumberOfTuples());
    view_.scalar = single ? GUSSET_F32 : GUSSET_F64;
    vtkCellArray *polygons = data->GetPolys();
    if (!polygons->IsStorage64Bit() && data->GetNumberOfStrips() == 0 && polygons->GetNumberOfCells() > 0) {
        // The same bits, and a negative id is out of range in either reading.
        view_.face_offsets = polygons->GetOffsetsArray32()->GetPointer(0);
        view_.face_corners = polygons->GetConnectivityArray32()->GetPointer(0);
        view_.face_count = static_cast<std::size_t>(polygons->GetNumberOfCells());
        return;
    }
    copy_polygons();
    if (data->GetNumberOfStrips() > 0) {
        add_strips();
    }
    view_.face_offsets = offsets_.data();
    view_.face_corners = corners_.data();
    view_.face_count = offsets_.size() - 1;
}

uint32_t Piece::index(vtkIdType id, vtkIdType cell) const {
    if (id < 0 || id > static_cast<vtkIdType>(std::numeric_limits<uint32_t>::max())) {
        throw std::out_of_range(where() + "cell " + std::to_string(cell) + " has the point id " + std::to_string(id));
    }
    return static_cast<uint32_t>(id);
}

void Piece::copy_points(int type) {
    const auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    copy->DeepCopy(points_);
    points_ = copy;
}

void Piece::widen() {
    if (is_single()) {
        copy_points(VTK_DOUBLE);
        view_.positions = points_->GetVoidPointer(0);
        view_.scalar = GUSSET_F64;
    }
}

void Piece::copy_polygons() {
    vtkCellArray *polygons = data_->GetPolys();
    offsets_.reserve(static_cast<std::size_t>(polygons->GetNumberOfCells()) + 1);
    corners_.reserve(static_cast<std::size_t>(polygons->GetNumberOfConnectivityIds()));
    offsets_.push_back(0);
    vtkIdType cell = loose_count();
    for_each_cell(polygons, [&](vtkIdType count, const vtkIdType *ids) {
        for (vtkIdType k = 0; k < count; ++k) {
            corners_.push_back(index(ids[k], cell));
        }
        offsets_.push_back(index(static_cast<vtkIdType>(corners_.size()), cell));
        ++cell;
    });
}

void Piece::add_strips() {
    vtkIdType cell = loose_count();
    for (std::size_t f = 0; f + 1 < offsets_.size(); ++f) {
        cells_.push_back(cell++);
    }
    for_each_cell(data_->GetStrips(), [&](vtkIdType count, const vtkIdType *ids) {
        for (vtkIdType k = 0; k + 2 < count; ++k) {
            // Every other triangle of a strip is the other way round.
            const vtkIdType odd = k % 2;
            for (const vtkIdType id : {ids[k + odd], ids[k + 1 - odd], ids[k + 2]}) {
                corners_.push_back(index(id, cell));
            }
            offsets_.push_back(index(static_cast<vtkIdType>(corners_.size()), cell));
            cells_.push_back(cell);
        }
        ++cell;
    });
}

std::vector<gusset::MeshView> views_of(std::vector<Piece> &pieces) {
    const bool single = std::all_of(pieces.begin(), pieces.end(), [](const Piece &piece) { return piece.is_single(); });
    std::vector<gusset::MeshView> views;
    for (Piece &piece : pieces) {
        if (!single) {
            piece.widen();
        }
        views.push_back(piece.view());
    }
    return views;
}

void with_names(const std::vector<Piece> &pieces, const std::function<void()> &call) {
    try {
        call();
    } catch (const gusset::Error &error) {
        const gusset_error_report &report = error.report();
        if (report.element == GUSSET_ELEMENT_NONE || report.input >= pieces.size()) {
            throw;
        }
        const Piece &piece = pieces[report.input];
        std::string text = piece.where() + error.what();
        if (report.element == GUSSET_ELEMENT_FACE && report.index < piece.face_count()) {
            const vtkIdType cell = piece.cell(static_cast<std::size_t>(report.index));
            // Vertices and lines are cells, but no faces, and strips are several.
            text += cell != static_cast<vtkIdType>(report.index) ? " (cell " + std::to_string(cell) + ")" : "";
        }
        throw gusset::Error(text.c_str(), report);
    }
}

void build(vtkPolyData *output, const gusset::MeshView &mesh, const gusset::Origins &origins, const std::vector<Piece> &pieces,
           const std::vector<gusset::Indices> &vertices, int precision, const Run &run) {
    // As the points and the cells were, if all of them were alike.
    const auto all = [&](auto &&is) { return std::all_of(pieces.begin(), pieces.end(), is); };
    const bool single = all([](const Piece &piece) { return piece.is_single(); });
    const bool narrow = all([](const Piece &piece) { return !piece.data()->GetPolys()->IsStorage64Bit(); });
    output->SetPoints(points_of(mesh, precision == vtkAlgorithm::DEFAULT_PRECISION ? single : precision == vtkAlgorithm::SINGLE_PRECISION));
    vtkNew<vtkCellArray> polygons;
    if (narrow && origins.size(gusset::Domain::corners) <= static_cast<std::size_t>(std::numeric_limits<int32_t>::max())) {
        set_polygons<vtkTypeInt32Array>(polygons, mesh);
    } else {
        set_polygons<vtkTypeInt64Array>(polygons, mesh);
    }
    output->SetPolys(polygons);
    output->SetVerts(loose_cells(pieces, vertices, &vtkPolyData::GetVerts));
    output->SetLines(loose_cells(pieces, vertices, &vtkPolyData::GetLines));
    carry_points(output, origins, pieces, run);
    carry_cells(output, origins, pieces, run);
}

} // namespace gusset_vtk
