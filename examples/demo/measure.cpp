#include "measure.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

namespace {
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Point point(const gusset::MeshView &mesh, uint32_t v) {
    const gusset::Point3 p = mesh.position(v);
    return {p[0], p[1], p[2]};
}

/// The faces from one on, as fans of triangles; those without area are left out.
Triangles triangles(const gusset::MeshView &mesh, std::size_t first = 0) {
    Triangles all;
    for (std::size_t f = first; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        for (std::size_t k = 2; k < face.size(); ++k) {
            const Kernel::Triangle_3 triangle(point(mesh, face[0]), point(mesh, face[k - 1]), point(mesh, face[k]));
            if (triangle.squared_area() > 0) {
                all.push_back(triangle);
            }
        }
    }
    return all;
}
} // namespace

Distances distances(const gusset::MeshView &from, const gusset::MeshView &to) {
    const Triangles surface = triangles(to);
    const Tree tree(surface.begin(), surface.end());
    const auto distance = [&](const Point &p) { return std::sqrt(tree.squared_distance(p)); };
    Distances found{{}, 0, 0};
    for (uint32_t v = 0; v < from.vertex_count(); ++v) {
        found.at.push_back(distance(point(from, v)));
        found.max = std::max(found.max, found.at.back());
    }
    // The middles of 16 equal triangles of each.
    constexpr int n = 4;
    double area = 0;
    for (const auto &triangle : triangles(from)) {
        const double weight = std::sqrt(triangle.squared_area()) / (n * n);
        const Vector a = (triangle[1] - triangle[0]) / n, b = (triangle[2] - triangle[0]) / n;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; i + j < n; ++j) {
                for (const double third : {1.0 / 3, 2.0 / 3}) {
                    if (third > 0.5 && i + j + 1 == n) {
                        continue;
                    }
                    const double d = distance(triangle[0] + (i + third) * a + (j + third) * b);
                    found.mean += weight * d;
                    found.max = std::max(found.max, d);
                    area += weight;
                }
            }
        }
    }
    found.mean /= area > 0 ? area : 1;
    return found;
}

gusset::Point3 best_eye(const gusset::MeshView &mesh, std::size_t first) {
    const Triangles whole = triangles(mesh), wanted = triangles(mesh, first);
    const Tree tree(whole.begin(), whole.end());
    const double size = std::sqrt((Point(tree.bbox().xmax(), tree.bbox().ymax(), tree.bbox().zmax()) -
                                   Point(tree.bbox().xmin(), tree.bbox().ymin(), tree.bbox().zmin())).squared_length());
    const std::size_t step = std::max<std::size_t>(1, wanted.size() / 200);
    gusset::Point3 best{0, 0, 1};
    double most = -1;
    for (const double tilt : {0.2, 0.0, 0.45, -0.2}) {
        for (int k = 0; k < 16; ++k) {
            const double turn = k * 3.14159265358979 / 8;
            const Vector eye(std::sin(turn) * std::cos(tilt), std::sin(tilt), std::cos(turn) * std::cos(tilt));
            double seen = 0;
            for (std::size_t t = 0; t < wanted.size(); t += step) {
                const Kernel::Triangle_3 &triangle = wanted[t];
                const Vector normal = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
                const double front = std::abs(normal * eye);
                const Point start = CGAL::centroid(triangle) + 1e-4 * size * eye;
                if (!tree.do_intersect(Kernel::Segment_3(start, start + 2 * size * eye))) {
                    seen += front;
                }
            }
            if (seen > most) {
                most = seen;
                best = {eye.x(), eye.y(), eye.z()};
            }
        }
    }
    return best;
}
