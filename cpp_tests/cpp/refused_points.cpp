// Must not compile: a std::vector is as large as three doubles, but its coordinates are elsewhere.
#include <gusset.hpp>

int main() {
    const std::vector<std::vector<double>> points(3, std::vector<double>(3));
    const std::vector<uint32_t> corners{0, 1, 2};
#if defined(AS_NODES)
    return gusset::NodesView(1, 3, points).get().rows != 0;
#elif defined(AS_NET)
    return gusset::Net::from_points(1, 3, points).rows() != 0;
#elif defined(AS_CURVE)
    return gusset::Curve::from_controls(points, corners, false).is_closed();
#else
    return gusset::MeshView::triangles(points, corners).face_count() != 0;
#endif
}
