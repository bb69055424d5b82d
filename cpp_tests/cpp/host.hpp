// The OpenMesh host's side of the tests.
#pragma once

#include "soup.hpp"

#include <gusset/openmesh.hpp>

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <optional>

using HostMesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// The soup as an OpenMesh mesh, vertex for vertex and face for face; nothing if OpenMesh refuses a
/// face.
inline std::optional<HostMesh> host_mesh(const Soup &soup) {
    omerr().disable(); // It tells of each face that it refuses.
    HostMesh mesh;
    if (!gusset::openmesh::append(mesh, soup.view()).empty()) {
        return std::nullopt;
    }
    return mesh;
}

/// The boundary cycles of OpenMesh's own walk, as it goes: the hole on the left.
inline std::vector<std::vector<uint32_t>> walks(const HostMesh &mesh) {
    std::vector<std::vector<uint32_t>> cycles;
    std::vector<bool> seen(mesh.n_halfedges());
    for (auto start : mesh.halfedges()) {
        if (!mesh.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())]) {
            continue;
        }
        cycles.emplace_back();
        OpenMesh::HalfedgeHandle h = start;
        do {
            seen[static_cast<std::size_t>(h.idx())] = true;
            cycles.back().push_back(static_cast<uint32_t>(mesh.from_vertex_handle(h).idx()));
            h = mesh.next_halfedge_handle(h);
        } while (h != start);
    }
    return cycles;
}
