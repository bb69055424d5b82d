// Benchmarks of nets: ours and half-edge meshes of the same surface, in one process, by turns. The surface is a torus, closed both ways,
// in single precision; the meshes of the peers have each of its points once.
#include "timing.hpp"

#include <gusset.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CLI/CLI.hpp>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <nlohmann/json.hpp>

#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace {
using CgalKernel = CGAL::Simple_cartesian<double>;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;
using OpenMeshMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// A rotation by about 37 degrees and a translation.
constexpr double MOTION[12] = {0.8, -0.6, 0, 0.1, 0.48, 0.64, -0.6, 0.2, 0.36, 0.48, 0.8, -0.3};

void check(gusset_status status) {
    if (status != GUSSET_OK) {
        throw std::runtime_error(gusset_status_text(status));
    }
}

struct Context {
    explicit Context(uint32_t threads) {
        check(gusset_context_create(&handle));
        check(gusset_context_set_threads(handle, threads));
    }
    Context(const Context &) = delete;
    Context &operator=(const Context &) = delete;
    ~Context() { gusset_context_destroy(handle); }
    gusset_context *handle = nullptr;
};

using Net = std::unique_ptr<gusset_net, decltype(&gusset_net_destroy)>;

Net torus(std::size_t side) {
    gusset_net_primitive primitive{};
    primitive.struct_size = sizeof primitive;
    primitive.shape = GUSSET_NET_TORUS;
    primitive.scalar = GUSSET_F32;
    primitive.rows = primitive.columns = side;
    primitive.radius = 3;
    primitive.minor_radius = 1;
    gusset_net *net = nullptr;
    check(gusset_net_primitive_create(nullptr, &primitive, &net));
    return Net(net, &gusset_net_destroy);
}

gusset_net_view lent(gusset_net *net) {
    gusset_net_view arrays{};
    arrays.struct_size = sizeof arrays;
    check(gusset_net_edit(nullptr, net, &arrays));
    return arrays;
}

/// The points of a closed net and its quads, as others take them.
struct Quads {
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<uint32_t, 4>> faces;
};

Quads quads(std::size_t side) {
    const Net net = torus(side);
    const gusset_net_view arrays = lent(net.get());
    const auto *x = static_cast<float *>(arrays.x), *y = static_cast<float *>(arrays.y), *z = static_cast<float *>(arrays.z);
    const std::size_t n = side - 1;
    Quads made;
    made.points.reserve(n * n);
    made.faces.reserve(n * n);
    const auto at = [n](std::size_t i, std::size_t j) { return static_cast<uint32_t>(i % n * n + j % n); };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const std::size_t k = i * side + j;
            made.points.push_back({x[k], y[k], z[k]});
            made.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return made;
}

std::unique_ptr<OpenMeshMesh> openmesh(const Quads &quads, bool with_normals) {
    auto mesh = std::make_unique<OpenMeshMesh>();
    if (with_normals) {
        mesh->request_face_normals();
        mesh->request_vertex_normals();
    }
    mesh->reserve(quads.points.size(), 2 * quads.faces.size(), quads.faces.size());
    for (const auto &p : quads.points) {
        mesh->add_vertex({p[0], p[1], p[2]});
    }
    const auto v = [](uint32_t k) { return OpenMesh::VertexHandle(static_cast<int>(k)); };
    for (const auto &f : quads.faces) {
        mesh->add_face(v(f[0]), v(f[1]), v(f[2]), v(f[3]));
    }
    return mesh;
}

std::unique_ptr<CgalMesh> cgal(const Quads &quads) {
    auto mesh = std::make_unique<CgalMesh>();
    mesh->reserve(static_cast<CgalMesh::size_type>(quads.points.size()), static_cast<CgalMesh::size_type>(2 * quads.faces.size()),
                  static_cast<CgalMesh::size_type>(quads.faces.size()));
    for (const auto &p : quads.points) {
        mesh->add_vertex({p[0], p[1], p[2]});
    }
    using V = CgalMesh::Vertex_index;
    for (const auto &f : quads.faces) {
        mesh->add_face(V(f[0]), V(f[1]), V(f[2]), V(f[3]));
    }
    return mesh;
}

/// The contenders: names of our own begin with "gusset".
struct Contender {
    std::string name;
    std::function<void()> work;
};

class Bench {
public:
    Bench(int runs, std::string only) : runs_(runs), only_(std::move(only)) {}

    bool wants(const std::string &id) const { return id.find(only_) != std::string::npos; }

    /// The first contender against all others, by turns, in milliseconds.
    void compare(const std::string &id, const std::vector<Contender> &contenders) {
        std::vector<std::vector<double>> times(contenders.size());
        // Once for the memory to be there.
        for (const Contender &contender : contenders) {
            contender.work();
        }
        for (int run = 0; run < runs_; ++run) {
            for (std::size_t k = 0; k < contenders.size(); ++k) {
                times[k].push_back(milliseconds(contenders[k].work));
            }
        }
        for (std::size_t k = 1; k < contenders.size(); ++k) {
            enter(id, contenders[k].name, median(times[0]), median(times[k]), "ms");
        }
    }

    void enter(const std::string &id, const std::string &peer, double ours, double theirs, const char *unit) {
        std::printf("%-30s %-22s %10.3f %10.3f %-4s%9.2f\n", id.c_str(), peer.c_str(), ours, theirs, unit, theirs / ours);
        std::fflush(stdout);
        report_.push_back({{"id", id + "/" + peer},
                           {"ours", ours},
                           {"peer", theirs},
                           {"unit", unit},
                           {"ratio", theirs / ours},
                           {"runs", runs_},
                           {"quality", nlohmann::json::object()}});
    }

    void write(const std::string &path) const { std::ofstream(path) << report_.dump(2) << '\n'; }

private:
    int runs_;
    std::string only_;
    nlohmann::json report_ = nlohmann::json::array();
};

void affine(Bench &bench, const std::string &id, std::size_t side) {
    const Context one(1), automatic(0);
    const Net net = torus(side);
    gusset_operation operation{};
    operation.kind = GUSSET_OPERATION_MATRIX;
    std::memcpy(operation.values, MOTION, sizeof MOTION);
    const auto ours = [&](const Context &context) { check(gusset_net_transform(context.handle, net.get(), &operation, 1)); };
    const Quads given = quads(side);
    const auto open = openmesh(given, false);
    const auto surface = cgal(given);
    const auto &m = MOTION;
    const CgalKernel::Aff_transformation_3 moved(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]);
    std::vector<float> plain(3 * side * side, 1.0f);
    bench.compare(id, {
        {"gusset", [&] { ours(one); }},
        {"gusset-automatic", [&] { ours(automatic); }},
        {"openmesh", [&] {
             for (const auto v : open->vertices()) {
                 const OpenMeshMesh::Point p = open->point(v);
                 const auto row = [&](int k) {
                     return static_cast<float>(m[k]) * p[0] + static_cast<float>(m[k + 1]) * p[1] +
                            static_cast<float>(m[k + 2]) * p[2] + static_cast<float>(m[k + 3]);
                 };
                 open->set_point(v, {row(0), row(4), row(8)});
             }
         }},
        {"cgal", [&] {
             for (const auto v : surface->vertices()) {
                 surface->point(v) = moved.transform(surface->point(v));
             }
         }},
        {"bandwidth", [&] {
             for (float &value : plain) {
                 value *= 1.0000001f;
             }
         }},
    });
}

void normals(Bench &bench, const std::string &id, std::size_t side) {
    const Context one(1), automatic(0);
    const Net net = torus(side);
    const std::size_t count = side * side;
    std::vector<float> x(count), y(count), z(count), from(3 * count, 1.0f), to(3 * count);
    const auto ours = [&](const Context &context) {
        check(gusset_net_normals(context.handle, net.get(), x.data(), y.data(), z.data(), count, nullptr));
    };
    const Quads given = quads(side);
    const auto open = openmesh(given, true);
    const auto surface = cgal(given);
    const auto found = surface->add_property_map<CgalMesh::Vertex_index, CgalKernel::Vector_3>("v:normal").first;
    bench.compare(id, {
        {"gusset", [&] { ours(one); }},
        {"gusset-automatic", [&] { ours(automatic); }},
        {"openmesh", [&] { open->update_normals(); }},
        {"cgal", [&] { CGAL::Polygon_mesh_processing::compute_vertex_normals(*surface, found); }},
        {"memcpy", [&] { std::memcpy(to.data(), from.data(), from.size() * sizeof(float)); }},
    });
}

void concatenate(Bench &bench, const std::string &id) {
    const Context one(1), automatic(0);
    const Net a = torus(708), b = torus(708);
    const gusset_net *both[] = {a.get(), b.get()};
    const auto ours = [&](const Context &context) {
        gusset_net *joined = nullptr;
        check(gusset_net_concatenate_create(context.handle, both, 2, nullptr, &joined));
        gusset_net_destroy(joined);
    };
    const std::size_t bytes = 2 * 708 * 708 * 3 * sizeof(float);
    const std::vector<char> from(bytes, 1);
    bench.compare(id, {
        {"gusset", [&] { ours(one); }},
        {"gusset-automatic", [&] { ours(automatic); }},
        // Into new memory, as ours.
        {"memcpy", [&] {
             const std::unique_ptr<char, decltype(&std::free)> to(static_cast<char *>(std::malloc(bytes)), &std::free);
             std::memcpy(to.get(), from.data(), bytes);
             // Somebody might look at it, for all the compiler knows.
             asm volatile("" : : "r"(to.get()) : "memory");
         }},
    });
}

void classes(Bench &bench, const std::string &id) {
    const Context one(1);
    const std::size_t side = 1000, count = side * side;
    const Net net = torus(side);
    // Every seventh horizontal link is contracted: no description by sides says that.
    std::vector<uint8_t> matrix(2 * count);
    for (std::size_t k = 0; k < count; k += 7) {
        matrix[2 * (k / side) * side + k % side] = 1;
    }
    gusset_net_gluing gluing{};
    gluing.struct_size = sizeof gluing;
    gluing.matrix = matrix.data();
    check(gusset_net_set_gluing(nullptr, net.get(), &gluing));
    const Net closed = torus(side);
    std::vector<uint32_t> found(count), from(count, 1);
    const auto ours = [&](const Net &of) {
        std::size_t written = 0;
        check(gusset_net_classes(one.handle, of.get(), found.data(), count, &written));
    };
    bench.compare(id, {
        {"gusset", [&] { ours(net); }},
        {"gusset-sides", [&] { ours(closed); }},
        {"memcpy", [&] { std::memcpy(found.data(), from.data(), count * sizeof(uint32_t)); }},
    });
}

/// Bytes that are allocated now.
double allocated() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// Bytes that each contender keeps for a node of the torus.
void memory(Bench &bench, const std::string &id) {
    const std::size_t side = 1000;
    const auto held = [](const auto &make, double nodes) {
        const double before = allocated();
        const auto made = make();
        return (allocated() - before) / nodes;
    };
    const double distinct = static_cast<double>((side - 1) * (side - 1));
    const double ours = held([&] { return torus(side); }, static_cast<double>(side * side));
    const Quads given = quads(side);
    bench.enter(id, "openmesh", ours, held([&] { return openmesh(given, false); }, distinct), "B");
    bench.enter(id, "cgal", ours, held([&] { return cgal(given); }, distinct), "B");
    bench.enter(id, "triangles", ours, 12.0 + 2 * 3 * 4, "B");
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("Nets beside half-edge meshes; ratio = peer / ours");
    std::string only, out = "nets.json";
    int runs = 9;
    app.add_option("--only", only, "cases whose names contain this");
    app.add_option("--runs", runs, "runs of each; medians are reported")->check(CLI::Range(1, 1000));
    app.add_option("--out", out, "the report");
    CLI11_PARSE(app, argc, argv);
    try {
        Bench bench(runs, only);
        const auto run = [&](const std::string &id, const std::function<void(const std::string &)> &work) {
            if (bench.wants(id)) {
                work(id);
            }
        };
        for (const auto &[size, side] : {std::pair<std::string, std::size_t>{"1e6", 1000}, {"1e7", 3162}}) {
            run("net/affine-" + size, [&, side = side](const std::string &id) { affine(bench, id, side); });
            run("net/normals-" + size, [&, side = side](const std::string &id) { normals(bench, id, side); });
        }
        run("net/concat-1e6", [&](const std::string &id) { concatenate(bench, id); });
        run("net/classes-1e6", [&](const std::string &id) { classes(bench, id); });
        run("net/memory", [&](const std::string &id) { memory(bench, id); });
        bench.write(out);
    } catch (const std::exception &error) {
        std::cerr << "nets: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
