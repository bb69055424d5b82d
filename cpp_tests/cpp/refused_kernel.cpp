// Must not compile: an exact kernel's points are no three doubles, and the adapter says so.
#include <gusset/cgal.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

int main() {
    CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> mesh;
    return gusset::cgal::Input<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>(mesh).view().face_count() != 0;
}
