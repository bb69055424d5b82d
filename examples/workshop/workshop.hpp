// Shared by all showcases of the workshop: numbers of meshes, properties that must hold, files of meshes, and text of
// a page.
#pragma once

#include "../page/showcase.hpp"
#include "../pictures/drawing.hpp"

#include <iomanip>
#include <iostream>
#include <stdexcept>

namespace workshop {
using gusset::MeshView;
using gusset::Point3;
using pictures::cross;
using pictures::dot;
using pictures::minus;

/// A property that must hold. A program ends with status(): 1 if anything did not.
class Claims {
public:
    void hold(bool holds, const std::string &what) {
        if (!holds) {
            std::cerr << "does not hold: " << what << '\n';
            broken_ = true;
        }
    }
    /// A closed surface to be printed or milled: every edge has two faces that agree, no vertex is a bow-tie.
    void closed(const MeshView &mesh, const std::string &what) {
        const gusset::Check check(mesh);
        hold(check.is_closed(), what + " is closed");
        hold(check.is_manifold(), what + " is manifold");
        hold(check.is_oriented(), what + " is oriented");
    }
    int status() const { return broken_ ? 1 : 0; }

private:
    bool broken_ = false;
};

/// Area, volume and its centre. Faces are cut into triangles from their first corners. The volume sums cones from a
/// vertex of the mesh, which loses less to rounding than cones from a far origin.
struct Measure {
    double area = 0, volume = 0;
    Point3 centre{};
};
inline Measure measure(const MeshView &mesh) {
    Measure sum;
    const Point3 apex = mesh.vertex_count() != 0 ? mesh.position(0) : Point3{};
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        const Point3 a = minus(mesh.position(face[0]), apex);
        for (std::size_t k = 2; k < face.size(); ++k) {
            const Point3 b = minus(mesh.position(face[k - 1]), apex), c = minus(mesh.position(face[k]), apex);
            const Point3 normal = cross(minus(b, a), minus(c, a));
            const double six = dot(a, cross(b, c));
            sum.area += std::sqrt(dot(normal, normal)) / 2;
            sum.volume += six / 6;
            for (std::size_t i = 0; i < 3; ++i) {
                sum.centre[i] += six / 24 * (a[i] + b[i] + c[i]);
            }
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        sum.centre[i] = sum.volume != 0 ? apex[i] + sum.centre[i] / sum.volume : NAN;
    }
    return sum;
}

/// V - E + F, of vertices that faces use.
inline long euler(const MeshView &mesh) {
    std::vector<uint8_t> used(mesh.vertex_count());
    std::vector<std::array<uint32_t, 2>> edges;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const uint32_t a = face[k], b = face[(k + 1) % face.size()];
            used[a] = 1;
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(edges.begin(), edges.end());
    const auto distinct = std::unique(edges.begin(), edges.end()) - edges.begin();
    return std::count(used.begin(), used.end(), 1) - distinct + static_cast<long>(mesh.face_count());
}

/// The smallest angle at a corner of faces `first` and after, in degrees.
inline double smallest_angle(const MeshView &mesh, std::size_t first = 0) {
    double least = 180;
    for (std::size_t f = first; f < mesh.face_count(); ++f) {
        const gusset::Indices face = mesh.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Point3 at = mesh.position(face[k]);
            const Point3 a = minus(mesh.position(face[(k + 1) % face.size()]), at);
            const Point3 b = minus(mesh.position(face[(k + face.size() - 1) % face.size()]), at);
            const Point3 normal = cross(a, b);
            least = std::min(least, 57.29577951308232 * std::atan2(std::sqrt(dot(normal, normal)), dot(a, b)));
        }
    }
    return least;
}

/// Writes an OFF file, if one was asked for.
inline void save(const MeshView &mesh, const std::string &file) {
    if (file.empty()) {
        return;
    }
    std::ofstream out(file);
    out << "OFF\n" << mesh.vertex_count() << ' ' << mesh.face_count() << " 0\n" << std::setprecision(17);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const Point3 p = mesh.position(v);
        out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        out << mesh.face(f).size();
        for (const uint32_t v : mesh.face(f)) {
            out << ' ' << v;
        }
        out << '\n';
    }
    if (!out.flush()) {
        throw std::runtime_error("cannot write " + file);
    }
}

/// Writes a picture, if one was asked for.
inline void save(pictures::Drawing &drawing, const std::string &file) {
    if (!file.empty() && !drawing.write(file)) {
        throw std::runtime_error("cannot write " + file);
    }
}

/// Writes what a page shows, if it was asked for: NAME.json and NAME.bin for scripts/page.py.
inline void save(const page::Showcase &shown, const std::string &name) {
    if (!name.empty()) {
        page::write(name, {shown});
    }
}

/// One text of parts; of numbers three digits.
template <class... Parts>
std::string said(const Parts &...parts) {
    std::ostringstream out;
    out << std::setprecision(3);
    (out << ... << parts);
    return out.str();
}

/// A curve of a page through points.
inline page::Curve line(std::vector<Point3> points, bool closed, const char *colour, double radius) {
    return {std::move(points), closed, colour, radius};
}

/// The borders of a mesh.
inline void add_borders(page::Body &body, const MeshView &mesh, const char *colour, double radius) {
    const gusset::Boundary borders(mesh);
    for (const gusset::Loop border : borders) {
        std::vector<Point3> points;
        for (const uint32_t v : border.vertices) {
            points.push_back(mesh.position(v));
        }
        body.curves.push_back(line(std::move(points), true, colour, radius));
    }
}

/// 100 (a / b - 1).
inline double percent(double a, double b) { return 100 * (a / b - 1); }
} // namespace workshop
