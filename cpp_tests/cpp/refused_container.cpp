// Must not compile: containers that a view cannot borrow, and arrays that are not named.
#include <gusset/eigen.hpp>

#include <list>

int main() {
    const std::vector<std::array<double, 3>> points(3);
    const std::vector<uint32_t> corners{0, 1, 2}, offsets{0, 3};
#if defined(AS_LIST)
    const std::list<std::array<double, 3>> list(points.begin(), points.end());
    return gusset::MeshView::triangles(list, corners).face_count() != 0;
#elif defined(AS_LONG)
    const std::vector<int64_t> wide{0, 1, 2};
    return gusset::MeshView::triangles(points, wide).face_count() != 0;
#elif defined(AS_NESTED)
    const std::vector<std::vector<int>> nested{{0, 1, 2}};
    return gusset::MeshView::triangles(points, nested).face_count() != 0;
#elif defined(AS_QUADS)
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 0}};
    return gusset::MeshView::triangles(points, quads).face_count() != 0;
#elif defined(AS_MATRIX)
    const Eigen::MatrixXd matrix(3, 3);
    return gusset::MeshView::triangles(matrix, corners).face_count() != 0;
#elif defined(AS_STRUCT)
    struct Point {
        double x, y, z;
    };
    const std::vector<Point> structs(3);
    return gusset::MeshView::triangles(structs, corners).face_count() != 0;
#elif defined(AS_SWAPPED)
    return gusset::MeshView::polygons(points, gusset::Corners(corners), gusset::Offsets(offsets)).face_count() != 0;
#else
    return gusset::MeshView::polygons(points, offsets, corners).face_count() != 0;
#endif
}
