// STL files, of text and binary: triangles by their corners' positions. Points that are exactly equal are one vertex.
#include "../attributes.hpp"
#include "../failure.hpp"
#include "bytes.hpp"
#include "formats.hpp"
#include "scanner.hpp"
#include "triangles.hpp"
#include "writer.hpp"

#include <cmath>
#include <unordered_map>

namespace {
constexpr std::size_t header_size = 80, facet_size = 50;

struct Hash {
    std::size_t operator()(const Point &p) const {
        std::size_t hash = 0;
        for (const double x : p) {
            // -0 is equal to 0.
            hash = (hash ^ std::hash<double>()(x + 0.0)) * 0x9E3779B97F4A7C15U;
        }
        return hash;
    }
};

/// Vertices by their positions.
class Vertices {
public:
    explicit Vertices(Mesh &mesh_) : mesh(mesh_) {}
    uint32_t of(const Point &point) {
        const auto [place, is_new] = known.emplace(point, static_cast<uint32_t>(mesh.points.size()));
        if (is_new) {
            mesh.points.push_back(point);
        }
        return place->second;
    }

private:
    Mesh &mesh;
    std::unordered_map<Point, uint32_t, Hash> known;
};

bool is_binary(const std::string &text) {
    if (text.size() < header_size + 4) {
        return false;
    }
    const auto count = number_at<uint32_t>(text, header_size);
    return text.size() == header_size + 4 + facet_size * static_cast<std::size_t>(count) ||
           text.compare(0, 5, "solid") != 0;
}

Mesh read_binary(const std::string &path, const std::string &text) {
    const std::size_t count = number_at<uint32_t>(text, header_size);
    const std::size_t held = (text.size() - header_size - 4) / facet_size;
    if (held < count) {
        throw Failure(Exit::file, path + ": the file ends in " + Element{"facet", held}.text() + "; it announces " +
                                      std::to_string(count));
    }
    Mesh mesh;
    Vertices vertices(mesh);
    bool marked = false;
    for (std::size_t f = 0; f < count; ++f) {
        const std::size_t start = header_size + 4 + facet_size * f;
        std::vector<uint32_t> face;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Point point;
            for (std::size_t k = 0; k < 3; ++k) {
                // The normal comes first.
                point[k] = static_cast<double>(number_at<float>(text, start + 12 + 12 * corner + 4 * k));
            }
            face.push_back(vertices.of(point));
        }
        mesh.add_face(face);
        marked = marked || number_at<uint16_t>(text, start + 48) != 0;
    }
    if (marked) {
        mesh.unread.emplace_back("the attribute bytes of facets");
    }
    return mesh;
}

Mesh read_text(const std::string &path, const std::string &text) {
    Scanner scanner(path, text);
    Mesh mesh;
    Vertices vertices(mesh);
    std::size_t solids = 0;
    const auto expect = [&](const char *wanted) {
        const Element of{"facet", mesh.face_count()};
        const auto word = scanner.word();
        if (word != wanted) {
            scanner.fail(of, word.empty() ? "the file ends there"
                                          : "\"" + std::string(word) + "\" where \"" + wanted + "\" must be");
        }
    };
    for (auto word = scanner.word(); !word.empty(); word = scanner.word()) {
        if (word == "solid" || word == "endsolid") {
            solids += word == "solid" ? 1 : 0;
            // Its name.
            static_cast<void>(scanner.rest_of_line());
            continue;
        }
        if (solids == 0 || word != "facet") {
            scanner.fail(solids == 0 ? "it does not begin with \"solid\", and is no binary STL file"
                                     : "\"" + std::string(word) + "\" where \"facet\" or \"endsolid\" must be");
        }
        const Element of{"facet", mesh.face_count()};
        expect("normal");
        for (int k = 0; k < 3; ++k) {
            // It follows from the corners, and may be anything.
            if (scanner.word().empty()) {
                scanner.fail(of, "the file ends there");
            }
        }
        expect("outer");
        expect("loop");
        std::vector<uint32_t> face;
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            Point point;
            for (double &x : point) {
                x = scanner.number(of);
            }
            face.push_back(vertices.of(point));
        }
        expect("endloop");
        expect("endfacet");
        mesh.add_face(face);
    }
    if (solids == 0) {
        throw Failure(Exit::file, path + ": the file is empty");
    }
    if (solids > 1) {
        mesh.unread.push_back("the division into " + std::to_string(solids) + " solids");
    }
    return mesh;
}

Point single(const Point &p) {
    return {static_cast<double>(static_cast<float>(p[0])), static_cast<double>(static_cast<float>(p[1])),
            static_cast<double>(static_cast<float>(p[2]))};
}

/// Of length 1, or 0 where the triangle has no area.
Point normal_of(const Point &a, const Point &b, const Point &c) {
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double &x : n) {
        x = length > 0 ? x / length : 0;
    }
    return n;
}

void write_facet(Writer &out, const std::array<Point, 3> &corners, bool text) {
    const Point normal = normal_of(corners[0], corners[1], corners[2]);
    if (!text) {
        for (const Point &p : {normal, corners[0], corners[1], corners[2]}) {
            for (const double x : p) {
                out.raw(static_cast<float>(x));
            }
        }
        out.raw(uint16_t{0});
        return;
    }
    out << "facet normal " << normal[0] << ' ' << normal[1] << ' ' << normal[2] << "\nouter loop\n";
    for (const Point &p : corners) {
        out << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    out << "endloop\nendfacet\n";
}

Losses losses_of(const Mesh &mesh, bool text, std::size_t polygons, std::size_t left_out) {
    Losses losses;
    for (const std::string &name : attribute_names(mesh)) {
        losses.push_back(name + ", which STL files do not hold");
    }
    if (polygons > 0) {
        losses.push_back(number_of(polygons, "face") + " of more than three corners: cut into triangles");
    }
    if (left_out > 0) {
        losses.push_back(number_of(left_out, "face") + " of fewer than three corners");
    }
    if (!text && !is_single(mesh.points)) {
        losses.emplace_back("digits of positions: binary STL files have single precision");
    }
    std::vector<bool> used(mesh.points.size());
    for (const uint32_t v : mesh.corners) {
        used[v] = true;
    }
    std::unordered_map<Point, uint32_t, Hash> places;
    std::size_t unused = 0, equal = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        if (!used[v]) {
            ++unused;
        } else if (!places.emplace(text ? mesh.points[v] : single(mesh.points[v]), 0).second) {
            ++equal;
        }
    }
    if (unused > 0) {
        losses.push_back(number_of(unused, "vertex", "vertices") + " that no face uses");
    }
    if (equal > 0) {
        losses.push_back("the difference between " + number_of(equal, "vertex", "vertices") +
                         " and others at the same positions");
    }
    return losses;
}
} // namespace

Mesh read_stl(const std::string &path) {
    const std::string text = load(path);
    return is_binary(text) ? read_binary(path, text) : read_text(path, text);
}

Losses write_stl(const std::string &path, const Mesh &mesh, bool text) {
    std::size_t triangles = 0, polygons = 0, left_out = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t degree = mesh.degree(f);
        triangles += degree < 3 ? 0 : degree - 2;
        polygons += degree > 3 ? 1 : 0;
        left_out += degree < 3 ? 1 : 0;
    }
    Writer out(path);
    if (text) {
        out << "solid gusset\n";
    } else {
        std::string header = "gusset";
        header.resize(header_size, ' ');
        out << header;
        out.raw(static_cast<uint32_t>(triangles));
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t degree = mesh.degree(f);
        const std::size_t start = degree > 3 ? fan_corner(mesh, f) : 0;
        const auto point = [&](std::size_t k) {
            return mesh.points[mesh.corners[mesh.offsets[f] + (start + k) % degree]];
        };
        for (std::size_t k = 1; k + 1 < degree; ++k) {
            write_facet(out, {point(0), point(k), point(k + 1)}, text);
        }
    }
    if (text) {
        out << "endsolid gusset\n";
    }
    out.finish();
    return losses_of(mesh, text, polygons, left_out);
}
