// Builds a small scene of nets: shapes, deformed by fields, joined, put into groups; prints what surfaces they are, and writes
// the whole as one mesh and as a picture that the library's own perspective has projected.
//   scene scene.obj scene.svg [--time 0.5]     (fields may depend on the time: here the columns twist up from 0 to 1)
#include <gusset.hpp>
#include <gusset/openmesh.hpp>

#include <CLI/CLI.hpp>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {
using gusset::Axis;
using gusset::Field;
using gusset::Net;
using gusset::Operation;
using gusset::Point3;
using gusset::Primitive;
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

Point3 minus(const Point3 &a, const Point3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point3 &a, const Point3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point3 unit(const Point3 &a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? Point3{a[0] / length, a[1] / length, a[2] / length} : a;
}

struct Part {
    std::string name, colour;
    Net net;
    Point3 place;
};

/// A bottle of two tubes, one above the other, with other numbers of columns: the bridge between them is a tube too.
Net bottle() {
    Net body = Net::from_primitive(Primitive::tube(0.42, 1.0).with(9, 33));
    Net neck = Net::from_primitive(Primitive::tube(0.16, 0.5).with(6, 17));
    neck.transform(Operation::translate({0, 0, 1.05}));
    gusset::ConcatenateOptions below;
    below.direction = gusset::Direction::down;
    Net joined = gusset::concatenate(body, neck, below);
    joined.transform(Operation::translate({0, 0, 0.5}));
    return joined;
}

/// A ground of hills: the host moves each node of a sheet.
Net hills() {
    Net ground = Net::from_primitive(Primitive::plane(8, 5).with(41, 65));
    const auto nodes = ground.edit<double>();
    for (std::size_t i = 0; i < nodes.x.rows(); ++i) {
        for (std::size_t j = 0; j < nodes.x.columns(); ++j) {
            const double x = nodes.x(i, j), distance = std::max(0.0, std::hypot(0.36 * x, nodes.y(i, j)) - 1.25);
            nodes.z(i, j) = 0.14 * distance * (1 + std::sin(2.3 * x) * std::cos(2.9 * nodes.y(i, j)));
        }
    }
    return ground;
}

std::vector<Part> parts(double time) {
    Net column = Net::from_primitive(Primitive::box({0.5, 0.5, 1.6}, {4, 4, 14}));
    column.transform(Operation::translate({0, 0, 0.8}));
    // Twisted more and more from time 0 to time 1, and tapered.
    const Field fields[] = {Field::taper(Axis::z, -0.25), Field::twist(Axis::z, 2.0).with_keys({{0, 0}, {1, 1}}, gusset::Easing::smooth)};
    column.deform(fields, time);

    Net ball = Net::from_primitive(Primitive::box({1, 1, 1}, {8, 8, 8}));
    // A cube blown up to a ball, nine parts in ten.
    ball.deform(Field::spherify({0, 0, 0}, 0.6).with_strength(0.9));
    ball.transform(Operation::translate({0, 0, 0.6}));

    Net ring = Net::from_primitive(Primitive::torus(0.5, 0.17).with(17, 41));
    const Operation upright[] = {Operation::rotate({1, 0, 0}, 1.2), Operation::translate({0, 0, 0.62})};
    ring.transform(upright);

    Net horn = Net::from_primitive(Primitive::cone(0.35, 2.0).with(25, 29));
    horn.transform(Operation::translate({0, 0, 1.0}));
    horn.deform(Field::bend(Axis::z, 0.9));

    return {{"twisted column", "#b3400e", column, {-2.7, 0, 0}}, {"cube to ball", "#2f6db5", ball, {-1.2, -0.2, 0}},
            {"ring", "#8a5fb0", ring, {0.1, 0, 0}},             {"bottle", "#2e8b57", bottle(), {1.4, -0.1, 0}},
            {"bent cone", "#c2932b", horn, {2.35, 0.2, 0}},        {"hills", "#8f948a", hills(), {0, 0, 0}}};
}

/// One line about a net.
void print(const std::string &name, const Net &net) {
    // The cells of hidden bridges are not there.
    const gusset::NetComplex complex(net, gusset::NetCells::present);
    const gusset_net_complex_view report = complex.view();
    const gusset_net_measure_report measures = net.measure();
    std::cout << std::left << std::setw(15) << name << std::right << std::setw(4) << net.rows() << " x " << std::left << std::setw(4)
              << net.columns() << std::right << std::setw(6) << report.vertex_count << " vertices" << std::setw(6)
              << report.quad_count << " quads" << std::setw(5) << report.triangle_count << " triangles, chi " << std::setw(2)
              << report.euler << ", " << complex.boundary_count() << " rims, ";
    if (complex.is_closed()) {
        std::cout << "closed, volume " << std::setprecision(4) << measures.volume << '\n';
    } else {
        std::cout << "open, area " << std::setprecision(4) << measures.area << '\n';
    }
}

struct DrawnFace {
    double depth;
    std::string path;
};

/// The faces of a net, projected from the eye onto the plane through `aim`, farthest first.
void draw(const Part &part, Net net, const Point3 &eye, const Point3 &aim, std::vector<DrawnFace> &out) {
    const Point3 view = unit(minus(eye, aim)), right = unit(cross({0, 0, 1}, view)), up = cross(view, right);
    const Point3 light = unit({-1.0, -1.6, 2.2});
    const bool closed = gusset::NetComplex(net).is_closed();
    const gusset::NetMesh solid(net);
    net.deform(Field::perspective(eye, aim, view));
    const gusset::NetMesh flat(net);
    for (std::size_t f = 0; f < solid.mesh().face_count(); ++f) {
        const gusset::Indices corners = solid.mesh().face(f);
        std::vector<Point3> points;
        for (uint32_t v : corners) {
            points.push_back(solid.mesh().position(v));
        }
        const Point3 normal = unit(cross(minus(points[2], points[0]), minus(points.back(), points[1])));
        const Point3 to_eye = minus(eye, points[0]);
        const double front = dot(normal, to_eye) >= 0 ? 1.0 : -1.0;
        if (closed && front < 0) {
            continue; // The back of a closed surface is not seen; open ones are seen from both sides.
        }
        const double shade = 0.45 + 0.55 * std::max(0.0, front * dot(normal, light));
        double depth = 0;
        std::ostringstream path;
        path << std::fixed << std::setprecision(1) << "<path d=\"";
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Point3 at = minus(flat.mesh().position(corners[k]), aim);
            path << (k == 0 ? 'M' : 'L') << 460 + 116 * dot(at, right) << ' ' << 240 - 116 * dot(at, up);
            depth += std::sqrt(dot(minus(eye, points[k]), minus(eye, points[k]))) / static_cast<double>(corners.size());
        }
        const int red = std::stoi(part.colour.substr(1, 2), nullptr, 16), green = std::stoi(part.colour.substr(3, 2), nullptr, 16),
                  blue = std::stoi(part.colour.substr(5, 2), nullptr, 16);
        const auto lit = [&](int channel) { return static_cast<int>(std::lround(channel * shade)); };
        path << "Z\" fill=\"rgb(" << lit(red) << ',' << lit(green) << ',' << lit(blue) << ")\"/>\n";
        out.push_back({depth, path.str()});
    }
}

bool write_picture(const std::string &file, const std::vector<Part> &all) {
    const Point3 eye{1.2, -7.5, 3.6}, aim{0, 0, 0.7};
    // The last part is the ground, which all others stand on: it is drawn first.
    std::vector<DrawnFace> ground, faces;
    for (const Part &part : all) {
        Net net = part.net;
        net.transform(Operation::translate(part.place));
        draw(part, std::move(net), eye, aim, &part == &all.back() ? ground : faces);
    }
    const auto farther = [](const DrawnFace &a, const DrawnFace &b) { return a.depth > b.depth; };
    std::stable_sort(ground.begin(), ground.end(), farther);
    std::stable_sort(faces.begin(), faces.end(), farther);
    std::ofstream out(file);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 480\" stroke=\"#fff\" stroke-width=\"0.4\" "
           "stroke-linejoin=\"round\">\n<rect width=\"100%\" height=\"100%\" rx=\"8\" stroke=\"none\" fill=\"#f6f4ee\"/>\n";
    for (const auto *drawn : {&ground, &faces}) {
        for (const DrawnFace &face : *drawn) {
            out << face.path;
        }
    }
    out << "</svg>\n";
    return out.good();
}
} // namespace

int main(int argc, char **argv) {
    std::string obj, svg;
    double time = 1;
    CLI::App app{"Builds, deforms and joins nets of quads, and draws them."};
    app.add_option("obj", obj, "The scene as one mesh")->required();
    app.add_option("svg", svg, "The scene as a picture")->required();
    app.add_option("--time", time, "From 0 to 1");
    CLI11_PARSE(app, argc, argv);
    try {
        const std::vector<Part> all = parts(time);
        gusset::Scene scene;
        const uint32_t root = scene.add_group();
        for (const Part &part : all) {
            print(part.name, part.net);
            // A group for each, so that it can be moved as a whole.
            const uint32_t group = scene.add_group(), net = scene.add(part.net);
            scene.set_transform(group, gusset::translation(part.place));
            scene.add_child(group, net);
            scene.add_child(root, group);
        }
        // All in one net, whose bridges are hidden, and apart again.
        const Net flat = scene.flatten();
        print("all in one net", flat);
        const gusset::Scene apart = gusset::Scene::unflatten(flat);
        std::cout << apart.report().nets << " nets again\n";

        Mesh mesh;
        const gusset::NetMesh quads(flat);
        if (!gusset::openmesh::append(mesh, quads.mesh()).empty()) {
            std::cerr << "OpenMesh takes two-manifolds only\n";
            return 1;
        }
        if (!OpenMesh::IO::write_mesh(mesh, obj) || !write_picture(svg, all)) {
            std::cerr << "cannot write\n";
            return 1;
        }
    } catch (const gusset::Error &error) {
        std::cerr << error.what() << " (status " << error.status() << ")\n";
        return 1;
    }
    return 0;
}
