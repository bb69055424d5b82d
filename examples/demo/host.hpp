// The host's mesh: polygons, double precision, vertices and faces with colours.
#pragma once

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

struct HostTraits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
};
using HostMesh = OpenMesh::PolyMesh_ArrayKernelT<HostTraits>;
