#include <gusset.hpp>
#include <gusset/openmesh.hpp>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <iostream>

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

int main(int argc, char **argv) {
    Mesh left, right, joined;
    if (argc != 4 || !OpenMesh::IO::read_mesh(left, argv[1]) || !OpenMesh::IO::read_mesh(right, argv[2])) {
        std::cerr << "usage: stitch left.obj right.obj joined.obj\n";
        return 2;
    }
    try {
        // Positions are read where OpenMesh keeps them.
        const gusset::openmesh::Input a(left), b(right);
        for (const gusset::Loop loop : gusset::Boundary(a.view())) {
            std::cout << "left has a loop of " << loop.vertices.size() << " vertices\n";
        }
        gusset::Context context;
        context.set_progress([](double fraction, const char *stage) {
            std::cout << static_cast<int>(100 * fraction) << " % " << stage << '\n';
            return true; // false cancels
        });
        // The two loops that lie nearest to each other; or name them: stitch(view, loop, view, loop).
        const gusset::Stitch stitch = gusset::stitch(a.view(), b.view(), {}, context);
        std::cout << stitch.quality().loops_left << " loops left\n";
        if (!gusset::openmesh::append(joined, stitch.mesh()).empty()) {
            std::cerr << "OpenMesh takes two-manifolds only\n";
            return 1;
        }
    } catch (const gusset::Error &error) {
        std::cerr << error.what() << " (status " << error.status() << ")\n";
        return 1;
    }
    return OpenMesh::IO::write_mesh(joined, argv[3]) ? 0 : 1;
}
