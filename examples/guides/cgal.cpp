// The programs of docs/guides/cgal.md in one.
//! [includes]
#include <gusset.hpp>
#include <gusset/cgal.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
//! [includes]

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// An open pyramid, point up or point down.
static Mesh pyramid(double up) {
    Mesh mesh;
    const auto apex = mesh.add_vertex({0, 0, 2 * up});
    const auto a = mesh.add_vertex({1, 0, up}), b = mesh.add_vertex({0, up, up});
    const auto c = mesh.add_vertex({-1, 0, up}), d = mesh.add_vertex({0, -up, up});
    mesh.add_face(apex, a, b), mesh.add_face(apex, b, c), mesh.add_face(apex, c, d), mesh.add_face(apex, d, a);
    return mesh;
}

int main() {
    const Mesh left = pyramid(1), right = pyramid(-1);
    //! [stitch]
    // Points are read where CGAL keeps them: kernels whose points are three doubles side by side.
    const gusset::cgal::Input a(left), b(right);
    gusset::StitchOptions options;
    options.intersections = gusset::Intersections::report;
    const gusset::Stitch stitch = gusset::stitch(a.view(), b.view(), options);
    Mesh joined;
    const auto refused = gusset::cgal::append(joined, stitch.mesh());
    //! [stitch]

    //! [judge]
    // Checks of the result by gusset and by CGAL.
    const bool ours = stitch.intersections()->empty() && stitch.quality().loops_left == 0;
    const bool theirs = CGAL::is_closed(joined) && !CGAL::Polygon_mesh_processing::does_self_intersect(joined);
    //! [judge]

    //! [map]
    // The maps carry your own property over.
    auto piece = joined.add_property_map<Mesh::Face_index, int>("f:piece", 0).first;
    for (const int mesh : {0, 1}) {
        for (const uint32_t face : stitch.face_map(mesh)) {
            piece[Mesh::Face_index(face)] = mesh + 1; // what is left 0 is the strip
        }
    }
    //! [map]
    std::size_t strip = 0;
    for (const auto face : joined.faces()) {
        strip += piece[face] == 0 ? 1U : 0U;
    }

    //! [surface]
    // Queries that CGAL lacks: nearest points and sections of a smooth surface instead of triangles.
    std::vector<Kernel::Point_3> nodes;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 12; ++j) {
            nodes.emplace_back(i, j, 0.05 * (i - 6) * (j - 6));
        }
    }
    const gusset::Surface saddle(gusset::Sheet::borrow(12, 12, &nodes[0].x(), 0, 0));
    const gusset::NearestPoint nearest = saddle.nearest({5.5, 5.5, 3.0});
    //! [surface]
    std::cout << joined.number_of_faces() << " faces, " << strip << " of the strip; nearest " << nearest.distance << '\n';
    return ours && theirs && refused.empty() && nearest.is_found() ? 0 : 1;
}
