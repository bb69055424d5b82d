// Shapes, and queries of data sets for the tests.
#ifndef GUSSET_TEST_VTK_SHAPES_HPP
#define GUSSET_TEST_VTK_SHAPES_HPP

#include <gusset.hpp>

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// A field that is linear in space.
inline double field(const double p[3]) {
    return 0.7 * p[0] - 1.3 * p[1] + 0.4 * p[2];
}

/// An open tube of quads round the z axis, from z = `from` on, 1 high.
struct Tube {
    double from = 0.0;
    int around = 12;
    int rows = 4;
    int scalar = VTK_DOUBLE;
    bool narrow_ids = false;
    double radius = 0.5;
};

inline vtkSmartPointer<vtkPolyData> tube(const Tube &shape) {
    vtkNew<vtkPoints> points;
    points->SetDataType(shape.scalar);
    for (int row = 0; row <= shape.rows; ++row) {
        for (int k = 0; k < shape.around; ++k) {
            const double angle = 2.0 * vtkMath::Pi() * k / shape.around;
            points->InsertNextPoint(shape.radius * std::cos(angle), shape.radius * std::sin(angle), shape.from + 1.0 * row / shape.rows);
        }
    }
    vtkNew<vtkCellArray> cells;
    if (shape.narrow_ids) {
        cells->Use32BitStorage();
    } else {
        cells->Use64BitStorage();
    }
    for (int row = 0; row < shape.rows; ++row) {
        for (int k = 0; k < shape.around; ++k) {
            const vtkIdType here = row * shape.around + k, next = row * shape.around + (k + 1) % shape.around;
            const vtkIdType quad[4] = {here, next, next + shape.around, here + shape.around};
            cells->InsertNextCell(4, quad);
        }
    }
    auto made = vtkSmartPointer<vtkPolyData>::New();
    made->SetPoints(points);
    made->SetPolys(cells);
    return made;
}

template <class Array>
vtkSmartPointer<Array> array(const char *name, int components, vtkIdType count) {
    auto made = vtkSmartPointer<Array>::New();
    made->SetName(name);
    made->SetNumberOfComponents(components);
    made->SetNumberOfTuples(count);
    return made;
}

/// Gives a data set arrays of many kinds. Numbers of cells and points count from `base`.
inline void give_arrays(vtkPolyData *data, int base = 0) {
    const vtkIdType points = data->GetNumberOfPoints(), cells = data->GetNumberOfCells();
    const auto height = array<vtkDoubleArray>("height", 1, points);
    const auto pair = array<vtkFloatArray>("pair", 2, points);
    const auto normals = array<vtkFloatArray>("directions", 3, points);
    const auto colour = array<vtkUnsignedCharArray>("colour", 3, points);
    const auto number = array<vtkIntArray>("number", 1, points);
    const auto name = array<vtkStringArray>("name", 1, points);
    const auto global = array<vtkIdTypeArray>("global", 1, points);
    for (vtkIdType v = 0; v < points; ++v) {
        double p[3];
        data->GetPoint(v, p);
        const double radius = std::hypot(p[0], p[1]);
        height->SetValue(v, field(p));
        pair->SetTuple2(v, p[0], -p[2]);
        normals->SetTuple3(v, p[0] / radius, p[1] / radius, 0.0);
        colour->SetTuple3(v, 10.0, 20.0, 250.0);
        number->SetValue(v, base + static_cast<int>(v) - 7);
        name->SetValue(v, "point " + std::to_string(base + v));
        global->SetValue(v, (vtkIdType{1} << 40) + base + v);
    }
    const auto part = array<vtkIntArray>("part", 1, cells);
    const auto label = array<vtkStringArray>("label", 1, cells);
    const auto area = array<vtkDoubleArray>("area", 1, cells);
    for (vtkIdType c = 0; c < cells; ++c) {
        part->SetValue(c, base - static_cast<int>(c));
        label->SetValue(c, "cell " + std::to_string(base + c));
        area->SetValue(c, 0.1 * static_cast<double>(base + c));
    }
    data->GetPointData()->SetScalars(height);
    data->GetPointData()->AddArray(pair);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->AddArray(colour);
    data->GetPointData()->AddArray(number);
    data->GetPointData()->AddArray(name);
    data->GetPointData()->SetGlobalIds(global);
    data->GetCellData()->AddArray(part);
    data->GetCellData()->AddArray(label);
    data->GetCellData()->SetScalars(area);
    vtkNew<vtkStringArray> title;
    title->SetName("title");
    title->InsertNextValue("a tube");
    data->GetFieldData()->AddArray(title);
}

/// The points and polygons of a data set, as the library's own caller has them.
struct Soup {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<float, 3>> single;
    std::vector<uint32_t> offsets{0}, corners;
    bool is_single;

    explicit Soup(vtkPolyData *data) : is_single(data->GetPoints() != nullptr && data->GetPoints()->GetDataType() == VTK_FLOAT) {
        for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) {
            std::array<double, 3> p;
            data->GetPoint(v, p.data());
            points.push_back(p);
            single.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
        }
        vtkNew<vtkIdList> ids;
        for (vtkIdType f = 0; f < data->GetNumberOfPolys(); ++f) {
            data->GetPolys()->GetCellAtId(f, ids);
            for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k) {
                corners.push_back(static_cast<uint32_t>(ids->GetId(k)));
            }
            offsets.push_back(static_cast<uint32_t>(corners.size()));
        }
    }
    gusset::MeshView view() const {
        const gusset::Offsets first(offsets);
        const gusset::Corners vertices(corners);
        return is_single ? gusset::MeshView::polygons(single, first, vertices) : gusset::MeshView::polygons(points, first, vertices);
    }
};

/// Whether a data set has the very points, as `Scalar`, and the very polygons of a result.
template <class Scalar>
bool equals(vtkPolyData *data, const gusset::MeshView &mesh) {
    const Soup soup(data);
    if (soup.points.size() != mesh.vertex_count() || soup.offsets.size() != mesh.face_count() + 1) {
        return false;
    }
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (soup.points[v][axis] != static_cast<double>(static_cast<Scalar>(mesh.position(v)[axis]))) {
                return false;
            }
        }
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        if (std::vector<uint32_t>(face.begin(), face.end()) !=
            std::vector<uint32_t>(soup.corners.begin() + soup.offsets[f], soup.corners.begin() + soup.offsets[f + 1])) {
            return false;
        }
    }
    return true;
}

inline vtkIdType open_edges(vtkPolyData *data) {
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(data);
    edges->FeatureEdgesOff();
    edges->ManifoldEdgesOff();
    edges->NonManifoldEdgesOff();
    edges->Update();
    return edges->GetOutput()->GetNumberOfCells();
}

/// Hears an object's events; errors and warnings are heard in place of being printed.
class Listener {
public:
    Listener(vtkObject *object, unsigned long event, std::function<void(const char *)> heard) : object_(object), heard_(std::move(heard)) {
        command_->SetClientData(this);
        command_->SetCallback([](vtkObject *, unsigned long, void *self, void *text) {
            static_cast<Listener *>(self)->heard_(static_cast<const char *>(text));
        });
        tag_ = object->AddObserver(event, command_);
    }
    ~Listener() { object_->RemoveObserver(tag_); }
    Listener(const Listener &) = delete;
    Listener &operator=(const Listener &) = delete;

private:
    vtkSmartPointer<vtkObject> object_;
    std::function<void(const char *)> heard_;
    vtkNew<vtkCallbackCommand> command_;
    unsigned long tag_ = 0;
};

/// Collects the errors and the warnings of a filter, except the message of its executive that it failed.
struct Messages {
    std::string errors, warnings;
    explicit Messages(vtkAlgorithm *filter)
        : error_(filter, vtkCommand::ErrorEvent, [this](const char *text) { errors += text; }),
          warning_(filter, vtkCommand::WarningEvent, [this](const char *text) { warnings += text; }),
          executive_(filter->GetExecutive(), vtkCommand::ErrorEvent, [](const char *) {}) {}

private:
    Listener error_, warning_, executive_;
};

#endif // GUSSET_TEST_VTK_SHAPES_HPP
