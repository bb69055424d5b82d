// The programs of docs/guides/cpp.md in one.
#include <gusset.hpp>

#include <array>
#include <atomic>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using Point = std::array<double, 3>;

struct Mesh {
    std::vector<Point> points;
    std::vector<uint32_t> corners;
};

// A dome: rings of `sides` vertices from the pole down, open below; `up` is 1, or -1 for one that hangs.
static Mesh dome(uint32_t sides, double up) {
    Mesh mesh{{{0, 0, 1.5 * up}}, {}};
    for (uint32_t ring = 1; ring <= 8; ++ring) {
        for (uint32_t i = 0; i < sides; ++i) {
            const double polar = 1.4 * ring / 8.0, longitude = up * 6.283185307179586 * i / sides;
            mesh.points.push_back({std::sin(polar) * std::cos(longitude), std::sin(polar) * std::sin(longitude),
                                   up * (0.5 + std::cos(polar))});
        }
    }
    for (uint32_t i = 0; i < sides; ++i) {
        mesh.corners.insert(mesh.corners.end(), {0, 1 + i, 1 + (i + 1) % sides});
    }
    for (uint32_t ring = 0; ring < 7; ++ring) {
        for (uint32_t i = 0; i < sides; ++i) {
            const uint32_t a = 1 + ring * sides + i, b = 1 + ring * sides + (i + 1) % sides;
            mesh.corners.insert(mesh.corners.end(), {a, a + sides, b + sides, a, b + sides, b});
        }
    }
    return mesh;
}

static void stitching(const Mesh &left, const Mesh &right) {
    //! [stitch]
    // Any containers whose elements begin with three floats or doubles, without a copy.
    const auto a = gusset::MeshView::triangles(left.points, left.corners);
    const auto b = gusset::MeshView::triangles(right.points, right.corners);
    for (const gusset::Loop loop : gusset::Boundary(a)) {
        std::cout << "a loop of " << loop.vertices.size() << " vertices\n";
    }
    gusset::StitchOptions options;
    options.finish = gusset::Finish::blend; // new vertices on a smooth surface; the default is a strip
    const gusset::Stitch stitch = gusset::stitch(a, b, options);
    std::cout << stitch.mesh().face_count() << " faces, " << stitch.quality().loops_left << " loops left\n";
    //! [stitch]
}

static void steering(const Mesh &left, const Mesh &right) {
    const auto a = gusset::MeshView::triangles(left.points, left.corners);
    const auto b = gusset::MeshView::triangles(right.points, right.corners);
    //! [errors]
    try {
        const std::vector<uint32_t> beyond = {0, 1, 99999};
        gusset::Boundary(gusset::MeshView::triangles(left.points, beyond));
    } catch (const gusset::Error &error) {
        // The message, the status, and the report with the element and its value.
        std::cout << error.what() << " (" << error.status() << "), corner " << error.report().index << '\n';
    }
    //! [errors]

    //! [progress]
    gusset::Context context;
    context.set_progress([](double fraction, const char *stage) {
        if (fraction > 2.0) {
            throw std::runtime_error(stage); // leaves the call, which is cancelled
        }
        return true; // false cancels, too
    });
    gusset::stitch(a, b, {}, context);
    // Another thread may cancel the running call and all later ones, and read progress():
    std::thread other([&] { context.cancel(); });
    other.join();
    try {
        gusset::stitch(a, b, {}, context);
    } catch (const gusset::Error &error) {
        std::cout << (error.status() == GUSSET_ERROR_CANCELLED ? "cancelled\n" : "something else\n");
    }
    context.reset(); // later calls run again
    //! [progress]
}

static void many_pieces(const Mesh &left, const Mesh &right) {
    //! [assembly]
    const std::vector<gusset::MeshView> pieces = {gusset::MeshView::triangles(left.points, left.corners),
                                                  gusset::MeshView::triangles(right.points, right.corners)};
    gusset::JoinOptions options;
    options.max_gap = 2.0; // in the unit of the points
    options.fill = true;   // fill the remaining holes
    const gusset::Join whole(pieces, options);
    for (const gusset_joint &joint : whole.joints()) {
        std::cout << "a gap of " << joint.gap << (joint.outcome == GUSSET_JOINT_JOINED ? ", joined\n" : ", left\n");
    }
    std::cout << whole.report().loops_left << " loops left\n";
    //! [assembly]

    //! [left]
    gusset::JoinOptions narrow;
    narrow.max_gap = 0.5;
    const gusset::Join apart(pieces, narrow);
    for (const gusset_left_loop &loop : apart.left()) {
        const auto reason = static_cast<gusset::LeftReason>(loop.reason);
        std::cout << "left, a loop of " << loop.vertices.count << " vertices: " << text(reason) << '\n';
    }
    //! [left]
}

static void curves() {
    //! [outline]
    const std::vector<std::array<double, 2>> points = {{0, 0}, {2, 1}, {4, 0}, {3, 2}, {2, 4}, {1, 2}};
    const gusset::Outline outline(gusset::Outlines(points, true)); // closed
    const gusset::Curve curve = outline.curve_copy();
    std::cout << "length " << curve.length() << ", area " << curve.measure().area << '\n';
    const gusset::CurveForm svg = curve.exported(gusset::CurveFormat::svg);
    std::cout << "<path d=\"" << svg.text() << "\"/>\n";
    //! [outline]
}

static void containers() {
    const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 3, 0}};
    //! [containers]
    const std::vector<std::array<int, 3>> rows = {{0, 1, 2}, {0, 2, 3}}; // or std::vector<int>, or std::span<const uint32_t>
    const auto triangles = gusset::MeshView::triangles(points, rows);
    // A quad and a triangle. The types Offsets and Corners tell the two arrays apart.
    const std::vector<int> offsets = {0, 4, 7}, corners = {0, 1, 2, 3, 3, 2, 4};
    const auto polygons = gusset::MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(corners));
    // The arrays of a result, without a copy.
    const gusset::Triangulation split(polygons);
    const gusset::Span<const Point> positions = split.mesh().positions();
    const gusset::Indices vertices = split.mesh().corners(); // three for each triangle
    //! [containers]
    std::cout << triangles.face_count() << " and " << vertices.size() / 3 << " triangles on " << positions.size() << " points\n";
}

static void surfaces() {
    //! [surface]
    // Nodes of a vase, closed in its second direction: the last column repeats the first.
    std::vector<Point> nodes;
    for (int row = 0; row <= 12; ++row) {
        for (int column = 0; column <= 24; ++column) {
            const double angle = 6.283185307179586 * (column % 24) / 24.0, radius = 1.0 + 0.3 * std::sin(0.5 * row);
            nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.25 * row});
        }
    }
    gusset::NodesOptions options;
    options.closed_v = true;
    const gusset::Surface vase(gusset::Sheet::from_nodes(13, 25, nodes, options));
    const gusset::NearestPoint nearest = vase.nearest({3, 0, 1.5});
    std::cout << "nearest at distance " << nearest.distance << ", proved from " << nearest.bound << '\n';
    for (const gusset::SurfacePath &ring : vase.section({0, 0, 1.6}, {0, 0, 1})) {
        std::cout << "a ring of " << ring.size() << " points on the surface\n";
    }
    //! [surface]
}

static void nets() {
    //! [net]
    gusset::Net net = gusset::Net::from_primitive(gusset::Primitive::torus(2.0, 0.5));
    net.deform(gusset::Field::twist(gusset::Axis::z, 0.5));
    const gusset::NetMesh closed(net); // usable wherever a mesh is expected
    std::cout << closed.mesh().face_count() << " quads, closed: " << gusset::Check(closed.mesh()).is_closed() << '\n';
    //! [net]
}

int main() {
    const Mesh left = dome(40, 1.0), right = dome(31, -1.0);
    stitching(left, right);
    steering(left, right);
    many_pieces(left, right);
    containers();
    curves();
    surfaces();
    nets();
}
