// The programs of docs/guides/openmesh.md in one: left.obj right.obj
//! [includes]
#include <gusset.hpp>
#include <gusset/openmesh.hpp>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
//! [includes]

#include <iostream>

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

static bool two_meshes(const Mesh &left, const Mesh &right) {
    //! [stitch]
    // Positions are read where OpenMesh keeps them; the meshes must stay as they are meanwhile.
    const gusset::openmesh::Input a(left), b(right);
    const gusset::Stitch stitch = gusset::stitch(a.view(), b.view());
    Mesh joined;
    const auto refused = gusset::openmesh::append(joined, stitch.mesh());
    //! [stitch]
    std::cout << joined.n_faces() << " faces, " << refused.size() << " refused\n";

    //! [handles]
    // Vertex v of the view is OpenMesh's vertex v. The map gives its index in the result.
    const OpenMesh::VertexHandle first = a.vertex(0);
    const OpenMesh::VertexHandle now(static_cast<int>(stitch.vertex_map(0)[0]));
    const bool same = (left.point(first) - joined.point(now)).norm() == 0;
    //! [handles]
    return same && refused.empty();
}

static bool one_mesh(Mesh mesh) {
    //! [holes]
    // Deleted elements are skipped. Appending the strip keeps all handles and properties.
    const gusset::openmesh::Input input(mesh);
    const gusset::Boundary loops(input.view());
    if (loops.size() >= 2) {
        const gusset::Stitch stitch = gusset::stitch_within(input.view());
        if (!stitch.turned()) {
            gusset::openmesh::append_strip(mesh, stitch);
        }
    }
    //! [holes]

    //! [fill]
    const gusset::openmesh::Input open(mesh);
    const gusset::Fill filled(open.view());
    Mesh closed;
    const auto refused = gusset::openmesh::append(closed, filled.mesh());
    //! [fill]
    std::cout << filled.quality().loops_left << " loops left\n";
    return refused.empty() && filled.quality().loops_left == 0;
}

int main(int argc, char **argv) {
    Mesh left, right;
    if (argc != 3 || !OpenMesh::IO::read_mesh(left, argv[1]) || !OpenMesh::IO::read_mesh(right, argv[2])) {
        std::cerr << "usage: openmesh left.obj right.obj\n";
        return 2;
    }
    const bool both = two_meshes(left, right), alone = one_mesh(left);
    return both && alone ? 0 : 1;
}
