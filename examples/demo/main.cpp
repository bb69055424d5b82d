// Stitches two open meshes: the two halves of a real closed mesh that it cuts itself, or the user's own files. Prints a
// report, with CGAL as the judge, and writes meshes and the camera for pictures of them.
#include "cut.hpp"

#include "../../cpp_tests/cpp/judge.hpp"

#include <gusset.hpp>
#include <gusset/openmesh.hpp>

#include <CLI/CLI.hpp>
#include <OpenMesh/Core/System/omstream.hh>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

namespace {
using Point = HostMesh::Point;
using OpenMesh::IO::Options;

const HostMesh::Color grey(0.5f, 0.5f, 0.48f, 1.0f), blue(0.3f, 0.4f, 0.55f, 1.0f), orange(0.8f, 0.3f, 0.03f, 1.0f);

HostMesh read(const std::string &path) {
    HostMesh mesh;
    if (!OpenMesh::IO::read_mesh(mesh, path)) {
        throw std::runtime_error("cannot read " + path);
    }
    return mesh;
}

void write(const HostMesh &mesh, const std::string &path) {
    if (!OpenMesh::IO::write_mesh(mesh, path, Options(Options::FaceColor), 17)) {
        throw std::runtime_error("cannot write " + path);
    }
}

void paint(HostMesh &mesh, std::size_t first, std::size_t last, HostMesh::Color colour) {
    for (std::size_t f = first; f < last; ++f) {
        mesh.set_color(OpenMesh::FaceHandle(static_cast<int>(f)), colour);
    }
}

/// Both pieces in one mesh, and after that the result.
HostMesh coloured(const HostMesh &left, const HostMesh &right, const gusset::Stitch *stitch) {
    HostMesh mesh;
    std::vector<uint32_t> refused;
    if (stitch != nullptr) {
        refused = gusset::openmesh::append(mesh, stitch->mesh());
    } else {
        refused = gusset::openmesh::append(mesh, gusset::openmesh::Input(left).view());
        const auto more = gusset::openmesh::append(mesh, gusset::openmesh::Input(right).view());
        refused.insert(refused.end(), more.begin(), more.end());
    }
    if (!refused.empty()) {
        throw std::runtime_error("OpenMesh refuses " + std::to_string(refused.size()) + " faces");
    }
    paint(mesh, 0, left.n_faces(), grey);
    paint(mesh, left.n_faces(), left.n_faces() + right.n_faces(), blue);
    paint(mesh, left.n_faces() + right.n_faces(), mesh.n_faces(), orange);
    return mesh;
}

/// The smallest box round some points.
struct Box {
    Point low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
    void add(const Point &p) {
        low.minimize(p);
        high.maximize(p);
    }
    Point centre() const { return (low + high) * 0.5; }
    double size() const { return (high - low).norm(); }
};

std::string camera(const Box &box, const Point &towards, const Point &up, double distance) {
    const Point to = box.centre(), from = to + towards * (distance * box.size());
    std::ostringstream text;
    text << "--camera-position=" << from[0] << ',' << from[1] << ',' << from[2] << " --camera-focal-point=" << to[0] << ','
         << to[1] << ',' << to[2] << " --camera-view-up=" << up[0] << ',' << up[1] << ',' << up[2];
    return text.str();
}

/// f3d's options for two pictures: the whole, and the strip from near by. Both look from where the least of the mesh stands
/// in front of the strip, along the slab (or, for the user's own pieces, from anywhere).
void write_cameras(const std::string &path, const HostMesh &mesh, const gusset::Stitch &stitch, const Point &normal) {
    Box whole, strip;
    for (auto v : mesh.vertices()) {
        whole.add(mesh.point(v));
    }
    for (int side : {0, 1}) {
        for (uint32_t v : stitch.rim(side)) {
            strip.add(mesh.point(OpenMesh::VertexHandle(static_cast<int>(v))));
        }
    }
    Point best(0, 0, 1);
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < 16; ++i) {
        for (int j = -1; j <= 1; ++j) {
            const double turn = i * M_PI / 8.0, tilt = j * M_PI / 6.0;
            const Point towards(std::sin(turn) * std::cos(tilt), std::sin(tilt), std::cos(turn) * std::cos(tilt));
            if (std::abs(towards | normal) > 0.5) {
                continue;
            }
            double front = std::numeric_limits<double>::lowest(), strip_front = front;
            for (auto v : mesh.vertices()) {
                front = std::max(front, towards | mesh.point(v));
            }
            for (uint32_t v : stitch.rim(0)) {
                strip_front = std::max(strip_front, towards | mesh.point(OpenMesh::VertexHandle(static_cast<int>(v))));
            }
            if (front - strip_front < least) {
                least = front - strip_front;
                best = towards;
            }
        }
    }
    std::ofstream(path) << camera(whole, best, {0, 1, 0}, 1.6) << '\n' << camera(strip, best, {0, 1, 0}, 1.8) << '\n';
}

std::string said(const Verdict &verdict) {
    if (!verdict.is_mesh) {
        return "not an oriented two-manifold";
    }
    return std::string(verdict.closed ? "closed" : std::to_string(verdict.boundary.size()) + " boundary loops") +
           ", consistently oriented, " + std::to_string(verdict.components) +
           (verdict.components == 1 ? " component, " : " components, ") + std::to_string(verdict.self_intersections) +
           " self-intersections" + (verdict.bounds_a_volume ? ", bounds a volume" : "");
}

void describe(const char *name, const HostMesh &mesh) {
    const gusset::openmesh::Input input(mesh);
    const gusset::Boundary boundary(input.view());
    std::cout << "  " << name << ": " << mesh.n_vertices() << " vertices, " << mesh.n_faces() << " faces, boundary loops:";
    for (const gusset::Loop loop : boundary) {
        std::cout << ' ' << loop.vertices.size();
    }
    std::cout << '\n';
}

int run(const std::string &whole, const std::string &a, const std::string &b, const std::string &out) {
    HostMesh left, right;
    Point normal(0, 0, 0);
    std::size_t intersections = 0;
    if (!whole.empty()) {
        const HostMesh mesh = read(whole);
        const Verdict before = judge(gusset::openmesh::Input(mesh).view());
        std::cout << "the mesh: " << mesh.n_vertices() << " vertices, " << mesh.n_faces() << " faces\n  CGAL: " << said(before)
                  << '\n';
        if (!before.is_mesh || !before.closed) {
            throw std::runtime_error("the mesh is not closed");
        }
        intersections = before.self_intersections;
        auto cut = cut_in_two(mesh);
        if (!cut) {
            throw std::runtime_error("no slab leaves two shells with one loop each");
        }
        std::cout << "cut in two: " << cut->removed << " faces removed\n";
        left = std::move(cut->left);
        right = std::move(cut->right);
        normal = cut->normal;
    } else {
        left = read(a);
        right = read(b);
        std::cout << "two pieces\n";
    }
    describe("left ", left);
    describe("right", right);

    const gusset::openmesh::Input input_a(left), input_b(right);
    const auto start = std::chrono::steady_clock::now();
    const gusset::Stitch stitch = gusset::stitch(input_a.view(), input_b.view());
    const auto time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start);
    const gusset_quality_report quality = stitch.quality();
    std::cout << "stitched in " << time.count() << " ms" << (stitch.turned() ? "; the right piece was turned over" : "")
              << "\n  rims of " << stitch.rim(0).size() << " and " << stitch.rim(1).size() << " vertices, "
              << stitch.strip_faces().second << " new triangles\n  strip: area " << quality.area << ", longest edge "
              << quality.max_edge << ", smallest angle " << quality.min_angle * 180.0 / M_PI << " degrees, largest aspect ratio "
              << quality.max_aspect << '\n';
    const Verdict verdict = judge(stitch.mesh());
    std::cout << "the result: " << stitch.mesh().vertex_count() << " vertices, " << stitch.mesh().face_count()
              << " faces\n  CGAL: " << said(verdict) << '\n';

    const HostMesh before = coloured(left, right, nullptr), after = coloured(left, right, &stitch);
    write(before, out + "/before.obj");
    write(after, out + "/after.obj");
    write_cameras(out + "/cameras.txt", after, stitch, normal);
    const bool good = verdict.is_mesh && (whole.empty() || (verdict.closed && verdict.self_intersections <= intersections));
    std::cout << (good ? "good: " : "NOT GOOD: ") << out << "/before.obj, " << out << "/after.obj\n";
    return good ? 0 : 1;
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("Stitches two open meshes into one");
    std::string whole, a, b, out = ".";
    auto *mesh = app.add_option("--mesh", whole, "a closed mesh to cut in two and to stitch again")->check(CLI::ExistingFile);
    auto *left = app.add_option("--left", a, "an open mesh")->check(CLI::ExistingFile)->excludes(mesh);
    app.add_option("--right", b, "the other one")->check(CLI::ExistingFile)->needs(left);
    app.add_option("--out", out, "the folder for the results")->check(CLI::ExistingDirectory);
    CLI11_PARSE(app, argc, argv);
    omlog().disable();
    try {
        if (whole.empty() && (a.empty() || b.empty())) {
            throw std::runtime_error("give --mesh, or --left and --right");
        }
        return run(whole, a, b, out);
    } catch (const std::exception &error) {
        std::cerr << "demo: " << error.what() << '\n';
        return 1;
    }
}
