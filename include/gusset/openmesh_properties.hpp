/// @file
/// Properties of OpenMesh meshes, carried over to results. Include openmesh.hpp, not this.
#ifndef GUSSET_OPENMESH_PROPERTIES_HPP
#define GUSSET_OPENMESH_PROPERTIES_HPP

#include <gusset/host_values.hpp>

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>

#include <algorithm>

namespace gusset::openmesh::detail {

/// The values of an element of a property: one number, or a vector of them.
template <class T>
struct Values {
    using Value = T;
    static constexpr uint32_t count = 1;
};
template <class T, int N>
struct Values<OpenMesh::VectorT<T, N>> {
    using Value = T;
    static constexpr uint32_t count = N;
};

/// OpenMesh's properties of vertices, of corners (the halfedge that ends there) and of faces.
struct OfVertices {
    static constexpr Domain domain = Domain::vertices;
    template <class T>
    using Handle = OpenMesh::VPropHandleT<T>;
    template <class Mesh>
    static auto begin(const Mesh &mesh) { return mesh.vprops_begin(); }
    template <class Mesh>
    static auto end(const Mesh &mesh) { return mesh.vprops_end(); }
};
struct OfCorners {
    static constexpr Domain domain = Domain::corners;
    template <class T>
    using Handle = OpenMesh::HPropHandleT<T>;
    template <class Mesh>
    static auto begin(const Mesh &mesh) { return mesh.hprops_begin(); }
    template <class Mesh>
    static auto end(const Mesh &mesh) { return mesh.hprops_end(); }
};
struct OfFaces {
    static constexpr Domain domain = Domain::faces;
    template <class T>
    using Handle = OpenMesh::FPropHandleT<T>;
    template <class Mesh>
    static auto begin(const Mesh &mesh) { return mesh.fprops_begin(); }
    template <class Mesh>
    static auto end(const Mesh &mesh) { return mesh.fprops_end(); }
};

/// Adds what OpenMesh itself keeps under this name.
template <class Mesh>
void request(Mesh &mesh, const std::string &name) {
    if (name == "v:normals") mesh.request_vertex_normals();
    if (name == "v:colors") mesh.request_vertex_colors();
    if (name == "v:texcoords1D") mesh.request_vertex_texcoords1D();
    if (name == "v:texcoords2D") mesh.request_vertex_texcoords2D();
    if (name == "v:texcoords3D") mesh.request_vertex_texcoords3D();
    if (name == "h:texcoords1D") mesh.request_halfedge_texcoords1D();
    if (name == "h:texcoords2D") mesh.request_halfedge_texcoords2D();
    if (name == "h:texcoords3D") mesh.request_halfedge_texcoords3D();
    if (name == "h:normals") mesh.request_halfedge_normals();
    if (name == "h:colors") mesh.request_halfedge_colors();
    if (name == "f:colors") mesh.request_face_colors();
    if (name == "f:textureindex") mesh.request_face_texture_index();
}

/// Properties that are not carried: positions, connectivity, states, and normals of faces, which depend on positions.
inline bool is_own(const std::string &name) {
    return name == "v:points" || name == "f:normals" || name.find(":status") != std::string::npos || name.find(":connectivity") != std::string::npos;
}

/// Carries properties of the type T from the inputs to a mesh, `to[k]` of which is element k of the result. `from[i][k]`: element k of
/// input i.
template <class Kind, class T, class Mesh, class Element>
void carry(Mesh &mesh, const std::vector<Element> &to, const Origins &origins, const std::vector<const Mesh *> &inputs,
           const std::vector<std::vector<Element>> &from, const Context &context) {
    using Handle = typename Kind::template Handle<T>;
    using Value = typename Values<T>::Value;
    static_assert(sizeof(T) == Values<T>::count * sizeof(Value), "elements have gaps");
    std::vector<std::string> done;
    for (const Mesh *input : inputs) {
        for (auto property = Kind::begin(*input); property != Kind::end(*input); ++property) {
            if (*property == nullptr || dynamic_cast<const OpenMesh::PropertyT<T> *>(*property) == nullptr) {
                continue;
            }
            const std::string name = (*property)->name();
            if (is_own(name) || std::find(done.begin(), done.end(), name) != done.end()) {
                continue;
            }
            done.push_back(name);
            std::vector<std::vector<T>> values(inputs.size());
            gusset::detail::HostChannel channel{Kind::domain, gusset::Rule::linear, gusset::detail::host_value_type<Value>(),
                                                gusset::detail::host_components<Value>(Values<T>::count), {}};
            channel.rule = gusset::detail::rule_of(name, channel.domain, channel.value_type, channel.components);
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                Handle handle;
                if (inputs[i]->get_property_handle(handle, name)) {
                    for (const Element element : from[i]) {
                        values[i].push_back(inputs[i]->property(handle, element));
                    }
                }
                channel.inputs.push_back({values[i].empty() ? nullptr : values[i].data(), values[i].size(), 0});
            }
            std::vector<T> made(to.size());
            channel.apply(origins, made.data(), made.size(), context);
            request(mesh, name);
            Handle handle;
            if (!mesh.get_property_handle(handle, name)) {
                mesh.add_property(handle, name);
            }
            for (std::size_t k = 0; k < to.size(); ++k) {
                if (to[k].is_valid()) {
                    mesh.property(handle, to[k]) = made[k];
                }
            }
        }
    }
}

/// The same of all types that the library carries.
template <class Kind, class Mesh, class Element>
void carry_all(Mesh &mesh, const std::vector<Element> &to, const Origins &origins, const std::vector<const Mesh *> &inputs,
               const std::vector<std::vector<Element>> &from, const Context &context) {
    const auto each = [&](auto... types) { (carry<Kind, decltype(types)>(mesh, to, origins, inputs, from, context), ...); };
    using namespace OpenMesh;
    each(float{}, double{}, int{}, unsigned{}, long{}, static_cast<unsigned long>(0), short{}, static_cast<unsigned short>(0), char{},
         static_cast<unsigned char>(0), Vec1f{}, Vec2f{}, Vec3f{}, Vec4f{}, Vec1d{}, Vec2d{}, Vec3d{}, Vec4d{}, Vec3uc{}, Vec4uc{}, Vec2i{},
         Vec3i{}, Vec4i{}, Vec2ui{}, Vec3ui{}, Vec4ui{});
}

} // namespace gusset::openmesh::detail

#endif // GUSSET_OPENMESH_PROPERTIES_HPP
