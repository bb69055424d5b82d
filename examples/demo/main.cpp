// Stitches two open meshes: the two parts of a real closed mesh without a band, or the user's files. Prints a
// report, with CGAL as the judge, and writes the meshes and a showcase of them.
#include "coloured.hpp"
#include "cut.hpp"
#include "measure.hpp"

#include "../../cpp_tests/cpp/judge.hpp"

#include <gusset.hpp>
#include <gusset/openmesh.hpp>

#include <CLI/CLI.hpp>
#include <OpenMesh/Core/System/omstream.hh>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

namespace {
using gusset::Point3;
using gusset::openmesh::Input;
using Point = HostMesh::Point;

const page::Colour ivory{219, 203, 173}, slate{150, 170, 186}, gold{217, 154, 28}, blue{74, 128, 168};

std::string hex(const page::Colour &colour) {
    std::ostringstream text;
    text << '#' << std::hex << std::setfill('0');
    for (const int channel : colour) {
        text << std::setw(2) << channel;
    }
    return text.str();
}

struct Request {
    std::string whole, left, right, out = ".", title = "Two open meshes, joined";
    std::vector<double> point, normal, eye, near_eye;
    double width = 0;
    gusset::Meridians meridians = gusset::Meridians::continuation;
};

const std::map<std::string, gusset::Meridians> meridians{
    {"continuation", gusset::Meridians::continuation},
    {"area", gusset::Meridians::min_area},         {"index", gusset::Meridians::index},   {"arc", gusset::Meridians::arc_length}, {"greedy", gusset::Meridians::greedy},
    {"diagonal", gusset::Meridians::min_diagonal}, {"smooth", gusset::Meridians::smooth}, {"quad", gusset::Meridians::quad}};

std::string counted(std::size_t count, const char *one, const char *many) { return std::to_string(count) + ' ' + (count == 1 ? one : many); }

std::string said(const Verdict &verdict) {
    if (!verdict.is_mesh) {
        return "not an oriented two-manifold";
    }
    return std::string(verdict.closed ? "closed" : counted(verdict.boundary.size(), "boundary loop", "boundary loops")) +
           ", consistently oriented, " + counted(verdict.components, "component", "components") + ", " +
           counted(verdict.self_intersections, "self-intersection", "self-intersections") +
           (verdict.bounds_a_volume ? ", bounds a volume" : "");
}

void describe(const char *name, const HostMesh &mesh) {
    const Input input(mesh);
    std::cout << "  " << name << ": " << counted(mesh.n_vertices(), "vertex", "vertices") << ", " << counted(mesh.n_faces(), "face", "faces")
              << ", boundary loops:";
    for (const gusset::Loop loop : gusset::Boundary(input.view())) {
        std::cout << ' ' << loop.vertices.size();
    }
    std::cout << '\n';
}

/// How far the rims are from each other: the mean length of the meridians.
double gap(const gusset::Stitch &stitch) {
    const gusset::Indices places = stitch.meridians(), rim = stitch.rim(0), other = stitch.rim(1);
    double sum = 0;
    for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
        const Point3 a = stitch.mesh().position(rim[places[k] % rim.size()]), b = stitch.mesh().position(other[places[k + 1] % other.size()]);
        sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return sum / (0.5 * static_cast<double>(places.size()));
}

/// Compares the strip with the removed band: printed, and as the showcase's text and scale.
void compare(const HostMesh &original, const HostMesh &removed, const gusset::Stitch &stitch, page::Showcase &showcase) {
    const Input truth(removed);
    const Distances found = distances(stitch.strip(), truth.view());
    const double across = gap(stitch);
    Point low(1e300, 1e300, 1e300), high = -low;
    for (const auto v : original.vertices()) {
        low.minimize(original.point(v));
        high.maximize(original.point(v));
    }
    const double diagonal = (high - low).norm();
    std::cout << "the strip beside the surface that was removed; the gap is " << across << " wide on average\n";
    for (const auto &[name, distance] : {std::pair("mean   ", found.mean), std::pair("largest", found.max)}) {
        std::cout << "  " << name << " distance " << distance << ": " << 100 * distance / across << " % of the gap, "
                  << 100 * distance / diagonal << " % of the bounding diagonal\n";
    }
    std::ostringstream text;
    text << std::setprecision(2) << "A band of " << removed.n_faces() << " faces was taken out of a closed mesh, and the gap closed by a blend, "
         << "faired as a thin plate. The new surface is " << 100 * found.mean / across << " % of the gap away from the one that was removed, on average, and "
         << 100 * found.max / across << " % at most: " << 100 * found.mean / diagonal << " % and " << 100 * found.max / diagonal
         << " % of the bounding diagonal.";
    showcase.text = text.str();
    showcase.distance_limit = found.max;
    showcase.distance_shown = 100 * found.max / across;
    showcase.distance_unit = "% of the gap";
    // The strip's vertices in the result: its rims, and the last ones.
    std::vector<double> &at = showcase.bodies[0].distances;
    at.assign(stitch.mesh().vertex_count(), -1);
    std::size_t k = 0;
    for (const int side : {0, 1}) {
        for (const uint32_t v : stitch.rim(side)) {
            at[v] = found.at[k++];
        }
    }
    for (std::size_t v = at.size() - (found.at.size() - k); v < at.size(); ++v) {
        at[v] = found.at[k++];
    }
}

/// The colours of a mesh as the page has them.
void colour(const Joined &mesh, page::Body &body) {
    const auto byte = [](float channel) { return static_cast<uint8_t>(std::lround(255 * std::min(std::max(channel, 0.0f), 1.0f))); };
    const auto bytes = [&](const HostMesh::Color &c) { return page::Colour{byte(c[0]), byte(c[1]), byte(c[2])}; };
    if (mesh.has_vertex_colours) {
        for (const auto v : mesh.mesh.vertices()) {
            body.vertex_colours.push_back(bytes(mesh.mesh.color(v)));
        }
    } else {
        for (const auto f : mesh.mesh.faces()) {
            body.face_colours.push_back(bytes(mesh.mesh.color(f)));
        }
    }
}

Point3 point(const std::vector<double> &given, const Point3 &otherwise) {
    return given.size() == 3 ? Point3{given[0], given[1], given[2]} : otherwise;
}

/// The places to look from.
void aim(const Request &request, const gusset::Stitch &stitch, page::Showcase &showcase) {
    Point low(1e300, 1e300, 1e300), high = -low;
    for (const int side : {0, 1}) {
        for (const uint32_t v : stitch.rim(side)) {
            const Point3 p = stitch.mesh().position(v);
            low.minimize(Point(p[0], p[1], p[2]));
            high.maximize(Point(p[0], p[1], p[2]));
        }
    }
    const Point middle = (low + high) * 0.5;
    showcase.up = {0, 1, 0};
    showcase.eye = request.eye.empty() ? best_eye(stitch.mesh(), stitch.strip_faces().first) : point(request.eye, {});
    showcase.near_eye = point(request.near_eye, showcase.eye);
    showcase.near_centre = {middle[0], middle[1], middle[2]};
    showcase.near_radius = 0.5 * (high - low).norm();
}

int run(const Request &request) {
    std::cout.precision(3);
    Coloured left, right;
    HostMesh original;
    std::optional<Cut> cut;
    std::size_t intersections = 0;
    if (!request.whole.empty()) {
        original = read(request.whole).mesh;
        const Verdict before = judge(Input(original).view());
        std::cout << "the mesh: " << original.n_vertices() << " vertices, " << original.n_faces() << " faces\n  CGAL: " << said(before) << '\n';
        if (!before.is_mesh || !before.closed) {
            throw std::runtime_error("the mesh is not closed");
        }
        intersections = before.self_intersections;
        const Point3 at = point(request.point, {}), normal = point(request.normal, {0, 1, 0});
        cut = cut_in_two(original, {{at[0], at[1], at[2]}, {normal[0], normal[1], normal[2]}, request.width});
        if (!cut) {
            throw std::runtime_error("the band does not part the mesh in two with one boundary loop each");
        }
        std::cout << "a band of " << cut->removed.n_faces() << " faces is taken out\n";
        left.mesh = cut->left;
        right.mesh = cut->right;
    } else {
        left = read(request.left);
        right = read(request.right);
        std::cout << "two pieces\n";
    }
    describe("left ", left.mesh);
    describe("right", right.mesh);

    const Input a(left.mesh), b(right.mesh);
    gusset::StitchOptions options;
    options.meridians = request.meridians;
    options.finish = gusset::Finish::blend;
    const auto start = std::chrono::steady_clock::now();
    const gusset::Stitch stitch = gusset::stitch(a.view(), b.view(), options);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    const gusset_quality_report quality = stitch.quality();
    const auto [first, count] = stitch.strip_faces();
    std::cout << "stitched in " << time.count() << " ms" << (stitch.turned() ? "; the right piece was turned over" : "") << "\n  rims of "
              << stitch.rim(0).size() << " and " << stitch.rim(1).size() << " vertices, "
              << counted(stitch.mesh().vertex_count() - a.view().vertex_count() - b.view().vertex_count(), "new one", "new ones")
              << " between them, " << counted(count, "triangle", "triangles")
              << "\n  smallest angle " << quality.min_angle * 180 / M_PI << " degrees, largest aspect ratio " << quality.max_aspect << '\n';
    const Verdict verdict = judge(stitch.mesh());
    std::cout << "the result: " << stitch.mesh().vertex_count() << " vertices, " << stitch.mesh().face_count() << " faces\n  CGAL: " << said(verdict)
              << (intersections > 0 && verdict.self_intersections == intersections ? ", as many as in the mesh itself" : "") << '\n';

    const std::array<page::Colour, 3> paints{ivory, cut ? ivory : slate, gold};
    const Joined before = joined(left, right, stitch, paints, false), after = joined(left, right, stitch, paints, true);
    const std::string written = write(before.mesh, before.has_vertex_colours, request.out + "/before") + ", " +
                                write(after.mesh, after.has_vertex_colours, request.out + "/after");

    page::Showcase showcase;
    showcase.id = "demo";
    showcase.title = request.title;
    showcase.text = "Two open meshes, and the blend that joins them: triangles as fine as those round it, on a surface that bends as a thin plate.";
    showcase.paints = {{"left", hex(paints[0]), 0, 0.42}, {"right", hex(paints[1]), 0, 0.42}, {"joint", hex(gold), 0.4, 0.35, true}, {"removed", hex(blue), 0, 0.42}};
    std::vector<uint8_t> side(first, 0);
    for (const uint32_t f : stitch.face_map(1)) {
        side[f] = 1;
    }
    showcase.bodies.resize(cut ? 2 : 1);
    showcase.bodies[0].add(stitch.mesh(), [&, first = first](std::size_t f) { return f < first ? side[f] : uint8_t{2}; });
    showcase.states = {{"Pieces", 0, {2}}, {"Joined", 0}};
    showcase.pairs = {{0, 1}};
    if (after.is_coloured) {
        colour(after, showcase.bodies[0]);
    }
    if (cut) {
        showcase.bodies[1].add(Input(original).view(), [&](std::size_t f) { return cut->part[f] == 2 ? 3 : cut->part[f]; });
        showcase.states.push_back({"Original", 1});
        showcase.pairs.push_back({1, 2});
        compare(original, cut->removed, stitch, showcase);
        for (const auto f : cut->removed.faces()) {
            cut->removed.set_color(f, {0.29f, 0.5f, 0.66f, 1});
        }
        write(cut->removed, false, request.out + "/removed");
    }
    aim(request, stitch, showcase);
    page::write(request.out + "/showcase", {showcase});

    const bool good = verdict.is_mesh && (!cut || (verdict.closed && verdict.self_intersections <= intersections));
    std::cout << (good ? "good: " : "NOT GOOD: ") << written << '\n';
    return good ? 0 : 1;
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("Stitches two open meshes into one");
    Request request;
    auto *mesh = app.add_option("--mesh", request.whole, "a closed mesh to take a band out of and to stitch again")->check(CLI::ExistingFile);
    auto *left = app.add_option("--left", request.left, "an open mesh")->check(CLI::ExistingFile)->excludes(mesh);
    app.add_option("--right", request.right, "the other one")->check(CLI::ExistingFile)->needs(left);
    app.add_option("--point", request.point, "a point in the band's middle")->expected(3)->needs(mesh);
    app.add_option("--normal", request.normal, "the direction across the band")->expected(3)->needs(mesh);
    app.add_option("--width", request.width, "the band's width")->needs(mesh);
    app.add_option("--meridians", request.meridians, "how the rims are matched")->transform(CLI::CheckedTransformer(meridians));
    app.add_option("--eye", request.eye, "the direction to look from")->expected(3);
    app.add_option("--near-eye", request.near_eye, "the direction to look from for a close look")->expected(3);
    app.add_option("--title", request.title, "the heading of the showcase");
    app.add_option("--out", request.out, "the folder for the results")->check(CLI::ExistingDirectory);
    CLI11_PARSE(app, argc, argv);
    omlog().disable();
    try {
        if (request.whole.empty() && (request.left.empty() || request.right.empty())) {
            throw std::runtime_error("give --mesh, or --left and --right");
        }
        return run(request);
    } catch (const std::exception &error) {
        std::cerr << "demo: " << error.what() << '\n';
        return 1;
    }
}
