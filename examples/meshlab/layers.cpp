#include "layers.hpp"

#include "attributes.hpp"

#include <cstring>

namespace {

/// The point at `index` of an array of either scalar type, of any alignment.
Point3m point(const void *array, std::size_t stride, std::size_t index, std::uint32_t scalar) {
    const std::size_t size = scalar == GUSSET_PLUGIN_F32 ? sizeof(float) : sizeof(double);
    const char *at = static_cast<const char *>(array) + index * (stride == 0 ? 3 * size : stride);
    Point3m point;
    for (int k = 0; k < 3; ++k, at += size) {
        if (scalar == GUSSET_PLUGIN_F32) {
            float value = 0;
            std::memcpy(&value, at, size);
            point[k] = Scalarm(value);
        } else {
            double value = 0;
            std::memcpy(&value, at, size);
            point[k] = Scalarm(value);
        }
    }
    return point;
}

std::vector<std::uint32_t> numbers(const void *array, std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    if (count > 0) {
        std::memcpy(numbers.data(), array, count * sizeof(std::uint32_t));
    }
    return numbers;
}

Polygons faces_of(const gusset_plugin_mesh &mesh) {
    // Outputs have offsets.
    Polygons faces;
    faces.offsets = numbers(mesh.face_offsets, mesh.face_count + 1);
    faces.corners = numbers(mesh.face_corners, faces.offsets.back());
    return faces;
}

/// Copies vertices and faces of a mesh, with their attributes, into an empty one.
void build(MeshModel &layer, const gusset_plugin_mesh &mesh, const Polygons &faces, const Attributes &attributes) {
    vcg::tri::Allocator<CMeshO>::AddVertices(layer.cm, mesh.vertex_count);
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
        layer.cm.vert[v].P() = point(mesh.positions, mesh.position_stride, v, mesh.scalar);
    }
    const Triangles triangles = add_faces(layer.cm, faces);
    if (triangles.faces.size() != mesh.face_count) {
        layer.updateDataMask(MeshModel::MM_POLYGONAL);
    }
    attributes.put(layer, triangles);
    layer.updateBoxAndNormals();
}

/// Removes all elements of a layer, with their attributes.
void empty(MeshModel &layer) {
    const int always = MeshModel::MM_VERTCOORD | MeshModel::MM_VERTNORMAL | MeshModel::MM_VERTFLAG |
                       MeshModel::MM_FACEVERT | MeshModel::MM_FACENORMAL | MeshModel::MM_FACEFLAG |
                       MeshModel::MM_TRANSFMATRIX | MeshModel::MM_CAMERA;
    layer.clearDataMask(layer.dataMask() & ~always);
    layer.clearTextures();
    layer.cm.Clear();
    layer.cm.sfn = layer.cm.svn = 0;
}

} // namespace

void Inputs::add(const MeshModel &model, std::uint32_t kind) {
    const CMeshO &layer = model.cm;
    Held &held = held_.emplace_back();
    held.layer = &model;
    if (list_.empty()) {
        first_ = layer.Tr;
    }
    const bool moved = !(layer.Tr == first_);
    const Matrix44m move = moved ? vcg::Inverse(first_) * layer.Tr : Matrix44m::Identity();
    if (kind == GUSSET_KIND_CURVES) {
        held.wires = wires(layer);
        for (std::size_t k = 0; moved && k < held.wires.points.size(); k += 3) {
            double *at = held.wires.points.data() + k;
            const Point3m p = move * Point3m(Scalarm(at[0]), Scalarm(at[1]), Scalarm(at[2]));
            std::copy_n(p.V(), 3, at);
        }
        const Wires &wires = held.wires;
        held.curves = {sizeof(gusset_plugin_curves), wires.points.data(),  0,
                       wires.points.size() / 3,      wires.offsets.data(), wires.closed.data(),
                       wires.closed.size(),          GUSSET_PLUGIN_F64,    0};
        list_.push_back({sizeof(gusset_input), &held.curves, kind, 0});
    } else {
        add_mesh(layer, held, moved ? &move : nullptr);
        list_.push_back({sizeof(gusset_input), &held.mesh, kind, 0});
    }
}

void Inputs::add_mesh(const CMeshO &layer, Held &held, const Matrix44m *move) {
    held.faces = polygons(layer);
    held.mesh = {};
    held.mesh.struct_size = sizeof held.mesh;
    held.mesh.vertex_count = layer.vert.size();
    held.mesh.face_offsets = held.faces.offsets.data();
    held.mesh.face_corners = held.faces.corners.data();
    held.mesh.face_count = held.faces.offsets.size() - 1;
    if (move == nullptr) {
        held.mesh.positions = layer.vert.empty() ? nullptr : layer.vert[0].cP().V();
        held.mesh.position_stride = sizeof(CVertexO);
        held.mesh.scalar = sizeof(Scalarm) == sizeof(float) ? GUSSET_PLUGIN_F32 : GUSSET_PLUGIN_F64;
        return;
    }
    for (const CVertexO &vertex : layer.vert) {
        const Point3m p = *move * vertex.cP();
        held.positions.insert(held.positions.end(), p.V(), p.V() + 3);
    }
    held.mesh.positions = held.positions.data();
    held.mesh.scalar = GUSSET_PLUGIN_F64;
}

void replace(MeshModel &layer, const gusset_plugin_mesh &mesh, const Polygons &before, const Attributes &attributes) {
    CMeshO &cm = layer.cm;
    const Polygons faces = faces_of(mesh);
    if (cm.vert.size() == mesh.vertex_count && faces == before) {
        for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
            cm.vert[v].P() = point(mesh.positions, mesh.position_stride, v, mesh.scalar);
        }
        layer.updateBoxAndNormals();
        return;
    }
    empty(layer);
    build(layer, mesh, faces, attributes);
}

void replace(MeshModel &layer, const gusset_plugin_curves &curves) {
    empty(layer);
    fill(layer, curves);
}

void fill(MeshModel &layer, const gusset_plugin_mesh &mesh, const Attributes &attributes) {
    build(layer, mesh, faces_of(mesh), attributes);
}

void fill(MeshModel &layer, const gusset_plugin_curves &curves) {
    Wires wires;
    for (std::size_t p = 0; p < curves.point_count; ++p) {
        const Point3m at = point(curves.points, curves.point_stride, p, curves.scalar);
        wires.points.insert(wires.points.end(), at.V(), at.V() + 3);
    }
    if (curves.curve_count > 0) {
        wires.offsets = numbers(curves.offsets, curves.curve_count + 1);
    }
    wires.closed.assign(curves.curve_count, 0);
    for (std::size_t c = 0; c < curves.curve_count && curves.closed != nullptr; ++c) {
        wires.closed[c] = curves.closed[c];
    }
    add_wires(layer.cm, wires);
    layer.updateBoxAndNormals();
}
