// Must not compile: the points of an exact kernel are not three doubles, and the adapter reports this.
#include <gusset/cgal.hpp>

#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>

int main() {
    // Exact, and of few headers.
    using Point = CGAL::Simple_cartesian<CGAL::MP_Float>::Point_3;
    CGAL::Surface_mesh<Point> mesh;
    return gusset::cgal::Input<Point>(mesh).view().face_count() != 0;
}
