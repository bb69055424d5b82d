// Benchmarks: ours and the peers in turn, on the same arrays, in one run. Prints a table and writes a report.
#include "mesh.hpp"
#include "timing.hpp"

#include <gusset.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CLI/CLI.hpp>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>

namespace {
using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// Loops and edges that a contender found. All contenders must find the same numbers.
struct Found {
    std::size_t loops = 0, edges = 0;
    bool operator==(const Found &other) const { return loops == other.loops && edges == other.edges; }
};

gusset::MeshView view(const Triangles &mesh) { return gusset::MeshView::triangles(mesh.points, mesh.corners); }

Found by_gusset(const Triangles &mesh, gusset::Survey survey) {
    gusset::BoundaryOptions options;
    options.survey = survey;
    const gusset::Boundary boundary(view(mesh), options);
    Found found{boundary.walk_count(), 0};
    for (const gusset::Loop loop : boundary) {
        found.edges += loop.half_edges.size();
    }
    return found;
}

std::size_t winged_by_gusset(const Triangles &mesh) {
    const gusset::Winged winged(view(mesh));
    return winged.edges().size();
}

OpenMeshMesh openmesh(const Triangles &mesh) {
    OpenMeshMesh built;
    built.reserve(mesh.points.size(), mesh.points.size() + mesh.face_count(), mesh.face_count());
    for (const auto &p : mesh.points) {
        built.add_vertex({p[0], p[1], p[2]});
    }
    const auto v = [&](std::size_t c) { return OpenMesh::VertexHandle(static_cast<int>(mesh.corners[c])); };
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
        built.add_face(v(c), v(c + 1), v(c + 2));
    }
    return built;
}

Found by_openmesh(const Triangles &mesh) {
    const OpenMeshMesh built = openmesh(mesh);
    Found found;
    std::vector<bool> seen(built.n_halfedges());
    for (auto start : built.halfedges()) {
        if (!built.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())]) {
            continue;
        }
        ++found.loops;
        OpenMesh::HalfedgeHandle h = start;
        do {
            seen[static_cast<std::size_t>(h.idx())] = true;
            ++found.edges;
            h = built.next_halfedge_handle(h);
        } while (h != start);
    }
    return found;
}

std::size_t edges_by_openmesh(const Triangles &mesh) { return openmesh(mesh).n_edges(); }

template <class CgalMesh>
CgalMesh cgal(const Triangles &mesh) {
    CgalMesh built;
    built.reserve(mesh.points.size(), mesh.points.size() + mesh.face_count(), mesh.face_count());
    for (const auto &p : mesh.points) {
        built.add_vertex({p[0], p[1], p[2]});
    }
    const auto v = [&](std::size_t c) { return typename CgalMesh::Vertex_index(mesh.corners[c]); };
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
        built.add_face(v(c), v(c + 1), v(c + 2));
    }
    return built;
}

Found by_cgal(const Triangles &mesh) {
    const CgalMesh built = cgal<CgalMesh>(mesh);
    std::vector<CgalMesh::Halfedge_index> cycles;
    CGAL::Polygon_mesh_processing::extract_boundary_cycles(built, std::back_inserter(cycles));
    Found found{cycles.size(), 0};
    for (auto start : cycles) {
        const auto round = CGAL::halfedges_around_face(start, built);
        found.edges += static_cast<std::size_t>(std::distance(round.begin(), round.end()));
    }
    return found;
}

std::size_t edges_by_cgal(const Triangles &mesh) { return cgal<CgalMesh>(mesh).number_of_edges(); }

/// One pass over the index: the hardware's limit.
uint32_t pure_read(const Triangles &mesh) {
    uint32_t sum = 0;
    for (uint32_t v : mesh.corners) {
        sum += v;
    }
    return sum;
}

class Bench {
public:
    Bench(int runs, std::string only) : runs_(runs), only_(std::move(only)) {}

    bool wants(const std::string &id) const { return id.find(only_) != std::string::npos; }

    /// Runs ours and the peers by turns and enters the medians; with a number of values, how many a second.
    template <class Result>
    void compare(const std::string &id, const std::string &what, const std::function<Result()> &ours,
                 const std::map<std::string, std::function<Result()>> &peers, double values = 0) {
        std::vector<double> own;
        std::map<std::string, std::vector<double>> others;
        bool agree = true;
        for (int run = 0; run < runs_; ++run) {
            Result mine{};
            own.push_back(milliseconds([&] { mine = ours(); }));
            for (const auto &[name, peer] : peers) {
                Result theirs{};
                others[name].push_back(milliseconds([&, &peer = peer] { theirs = peer(); }));
                agree = agree && (name == "read" || theirs == mine);
            }
        }
        for (auto &[name, times] : others) {
            const double mine = median(own), theirs = median(times);
            std::printf("%-30s %-22s %10.2f %10.2f ms  %9.2f   %s%s\n", id.c_str(), name.c_str(), mine, theirs, theirs / mine,
                        what.c_str(), agree ? "" : "  RESULTS DIFFER");
            std::fflush(stdout);
            nlohmann::json quality = {{"same_result", agree}};
            if (values > 0) {
                quality["values_per_second"] = std::round(1000 * values / mine);
            }
            report_.push_back({{"id", id + "/" + name},
                               {"ours", mine},
                               {"peer", theirs},
                               {"unit", "ms"},
                               {"ratio", theirs / mine},
                               {"quality", quality}});
        }
    }

    void write(const std::string &path) const { std::ofstream(path) << report_.dump(2) << '\n'; }

private:
    int runs_;
    std::string only_;
    nlohmann::json report_ = nlohmann::json::array();
};

void boundary(Bench &bench, const std::string &name, const std::string &file) {
    if (!bench.wants("boundary-full/" + name) && !bench.wants("boundary/" + name) && !bench.wants("winged/" + name)) {
        return;
    }
    const Triangles mesh = read_triangles(file);
    const std::string what = std::to_string(mesh.face_count()) + " triangles, all loops from the arrays";
    if (bench.wants("boundary-full/" + name)) {
        bench.compare<Found>("boundary-full/" + name, what + ", and everything unusual",
                             [&] { return by_gusset(mesh, gusset::Survey::whole_mesh); },
                             {{"openmesh", [&] { return by_openmesh(mesh); }}, {"cgal", [&] { return by_cgal(mesh); }}});
    }
    if (bench.wants("boundary/" + name)) {
        static volatile uint32_t sink;
        bench.compare<Found>("boundary/" + name, what, [&] { return by_gusset(mesh, gusset::Survey::boundary_only); },
                             {{"openmesh", [&] { return by_openmesh(mesh); }},
                              {"cgal", [&] { return by_cgal(mesh); }},
                              {"read", [&] {
                                   sink = pure_read(mesh);
                                   return Found{};
                               }}});
    }
    if (bench.wants("winged/" + name)) {
        bench.compare<std::size_t>("winged/" + name, std::to_string(mesh.face_count()) + " triangles, table of edges",
                                   [&] { return winged_by_gusset(mesh); },
                                   {{"openmesh", [&] { return edges_by_openmesh(mesh); }},
                                    {"cgal", [&] { return edges_by_cgal(mesh); }}});
    }
}

/// The heights of planes; as in bench/sections.py.
std::vector<double> section_heights(std::size_t count) {
    std::vector<double> heights;
    for (std::size_t k = 0; k < count; ++k) {
        heights.push_back(-0.8 + 1.6 * (static_cast<double>(k) + 0.5) / static_cast<double>(count) + 1e-5 * std::sqrt(2.0));
    }
    return heights;
}

/// Ours from the arrays, the peer from its mesh, with its tree. Points are counted as edges.
void sections(Bench &bench, const std::string &file) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Sliced = CGAL::Surface_mesh<Kernel::Point_3>;
    const Triangles mesh = read_triangles(file);
    const Sliced built = cgal<Sliced>(mesh);
    for (const std::size_t count : {std::size_t{1}, std::size_t{100}}) {
        const std::string id = "section/" + std::to_string(count) + "-1M";
        if (!bench.wants(id + "/cgal")) {
            continue;
        }
        const std::vector<double> heights = section_heights(count);
        const auto ours = [&] {
            Found found;
            for (const gusset::SectionPath &path : gusset::MeshSections(view(mesh), gusset::CuttingPlanes::stack({0, 0, 0}, {0, 0, 1}, heights))) {
                found.edges += path.size();
                ++found.loops;
            }
            return found;
        };
        const auto theirs = [&] {
            const CGAL::Polygon_mesh_slicer<Sliced, Kernel> slicer(built);
            Found found;
            for (const double height : heights) {
                std::vector<std::vector<Kernel::Point_3>> polylines;
                slicer(Kernel::Plane_3(0, 0, 1, -height), std::back_inserter(polylines));
                for (const auto &polyline : polylines) {
                    found.edges += polyline.size() - 1;
                    ++found.loops;
                }
            }
            return found;
        };
        bench.compare<Found>(id, std::to_string(mesh.face_count()) + " triangles, polylines of " + std::to_string(count) + " planes", ours, {{"cgal", theirs}});
    }
}

/// A grid of n x n quads.
struct Grid {
    std::vector<std::array<float, 3>> points;
    std::vector<uint32_t> corners;

    Grid(uint32_t n, float y) {
        for (uint32_t v = 0; v < (n + 1) * (n + 1); ++v) {
            points.push_back({static_cast<float>(v % (n + 1)), static_cast<float>(v / (n + 1)) + y, 0.0F});
        }
        for (uint32_t f = 0; f < n * n; ++f) {
            const uint32_t v = f / n * (n + 1) + f % n;
            corners.insert(corners.end(), {v, v + 1, v + n + 2, v + n + 1});
        }
    }
};

/// Carries vertex normals, corner texture coordinates and face integers over when two grids of half a million faces
/// are joined. The peer copies as many bytes on one thread.
void attributes(Bench &bench) {
    using Normal = std::array<float, 3>;
    using Uv = std::array<float, 2>;
    const uint32_t n = 700;
    const Grid a(n, 0.0F), b(n, static_cast<float>(n) + 1.5F);
    const gusset::StitchOptions arcs = [] {
        gusset::StitchOptions options;
        options.extent = gusset::StitchExtent::open_arcs;
        return options;
    }();
    const gusset::Stitch stitch =
        gusset::stitch(gusset::MeshView::uniform(a.points, a.corners, 4), gusset::MeshView::uniform(b.points, b.corners, 4), arcs);
    const gusset::Origins origins = stitch.origins();
    const std::vector<Normal> normals(a.points.size(), Normal{0, 0, 1});
    std::vector<Uv> uv;
    for (std::size_t c = 0; c < a.corners.size(); ++c) {
        uv.push_back({a.points[a.corners[c]][0] / n, a.points[a.corners[c]][1] / n});
    }
    const std::vector<uint32_t> numbers(n * n, 7);
    const std::size_t vertices = origins.size(gusset::Domain::vertices), corners = origins.size(gusset::Domain::corners),
                      faces = origins.size(gusset::Domain::faces);
    std::vector<Normal> to_vertices(vertices);
    std::vector<Uv> to_corners(corners);
    std::vector<uint32_t> to_faces(faces);
    const gusset::Context context;
    const auto carry = [&](gusset::Domain domain, gusset::Rule rule, uint32_t type, uint32_t components, const void *from, std::size_t count,
                           void *to, std::size_t room) {
        gusset_channel channel{sizeof channel, static_cast<uint32_t>(domain), type, components, static_cast<uint32_t>(rule), 0, 0};
        const gusset_channel_values given[2] = {{from, count, 0}, {from, count, 0}};
        context.call(gusset_attributes_apply, origins.get(), &channel, +given, std::size_t{2}, to, room, std::size_t{0});
    };
    const double values = static_cast<double>(3 * vertices + 2 * corners + faces);
    bench.compare<std::size_t>(
        "attributes/apply", "normals, texture coordinates and numbers of a million faces",
        [&] {
            carry(gusset::Domain::vertices, gusset::Rule::normal, GUSSET_VALUE_F32, 3, normals.data(), normals.size(), to_vertices.data(), vertices);
            carry(gusset::Domain::corners, gusset::Rule::texture, GUSSET_VALUE_F32, 2, uv.data(), uv.size(), to_corners.data(), corners);
            carry(gusset::Domain::faces, gusset::Rule::nearest, GUSSET_VALUE_U32, 1, numbers.data(), numbers.size(), to_faces.data(), faces);
            return vertices;
        },
        {{"limit", [&] {
              for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
                  std::copy_n(normals.data(), normals.size(), to_vertices.data() + half * normals.size());
                  std::copy_n(uv.data(), uv.size(), to_corners.data() + half * uv.size());
                  std::copy_n(numbers.data(), numbers.size(), to_faces.data() + half * numbers.size());
              }
              return vertices;
          }}},
        values);
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("Benchmarks against OpenMesh and CGAL; ratio = peer / ours");
    std::vector<std::string> meshes;
    std::string only, out = "report.json", sliced;
    int runs = 7;
    app.add_option("--mesh", meshes, "name=file: the cases boundary/name, boundary-full/name and winged/name");
    app.add_option("--sections", sliced, "file: the cases section/1-1M and section/100-1M");
    app.add_option("--only", only, "cases whose names contain this");
    app.add_option("--runs", runs, "runs of each; medians are reported")->check(CLI::Range(1, 1000));
    app.add_option("--out", out, "the report");
    CLI11_PARSE(app, argc, argv);
    try {
        Bench bench(runs, only);
        std::printf("%-30s %-22s %10s %10s     %9s\n", "case", "peer", "ours", "peer", "ratio");
        if (bench.wants("meridians/index-100000")) {
            // The paper's double loop, with its bounds and braces mended, beside the closed form.
            const auto literal = [] {
                const int64_t n = 10'000, m = 8'000;
                std::vector<uint32_t> row;
                for (int64_t i = 0; i <= n; ++i) {
                    int64_t j = 0;
                    while (j < m && std::abs(m * i - n * (j + 1)) <= std::abs(m * i - n * j)) {
                        ++j;
                    }
                    row.push_back(static_cast<uint32_t>(j));
                }
                return row;
            };
            bench.compare<std::vector<uint32_t>>("meridians/index-10000", "segments 10000 x 8000, the rule by index",
                                                 [] { return gusset::meridians_index(10'000, 8'000); },
                                                 {{"literal", literal}});
            bench.compare<std::vector<uint32_t>>("meridians/index-100000", "segments 100000 x 80000, the rule by index",
                                                 [] { return gusset::meridians_index(100'000, 80'000); },
                                                 {{"closed-form", [] {
                                                       std::vector<uint32_t> row(100'001);
                                                       for (uint64_t i = 0; i < row.size(); ++i) {
                                                           row[i] = static_cast<uint32_t>((160'000 * i + 100'000) / 200'000);
                                                       }
                                                       return row;
                                                   }}});
        }
        if (bench.wants("attributes/apply/limit")) {
            attributes(bench);
        }
        if (!sliced.empty()) {
            sections(bench, sliced);
        }
        for (const std::string &given : meshes) {
            const std::size_t equals = given.find('=');
            if (equals == std::string::npos) {
                throw std::runtime_error(given + " is not name=file");
            }
            boundary(bench, given.substr(0, equals), given.substr(equals + 1));
        }
        bench.write(out);
    } catch (const std::exception &error) {
        std::cerr << "bench: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
