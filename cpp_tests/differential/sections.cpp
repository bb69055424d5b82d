// Sections of meshes by planes, against CGAL's slicer. Vertices are points of an integer lattice, and planes have
// integer coefficients, so that both libraries get exactly the same plane and this file knows each vertex's side.
//
// CGAL draws an edge in the plane once, unless both its faces are in the plane. gusset draws it for each face below
// (InPlane::above) or above (InPlane::below). The truth is therefore:
// - No vertex in the plane: the same polylines.
// - Else: the segments of both rules together are CGAL's segments, without edges on a border whose face is in the plane.
//   The polylines of a rule are as many as CGAL's at a plane half a lattice unit below (above), without those that
//   shrink to a single vertex.
#include "../cpp/cgal_soup.hpp"
#include "../cpp/data.hpp"
#include "../cpp/judge.hpp"
#include "pieces.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace campaign {
namespace of_sections {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Slicer = CGAL::Polygon_mesh_slicer<CgalMesh, Kernel>;
using Polyline = std::vector<Kernel::Point_3>;
using Vector = std::array<int64_t, 3>;
using EdgeKey = std::pair<uint32_t, uint32_t>;
namespace PMP = CGAL::Polygon_mesh_processing;

constexpr std::size_t planes_per_case = 10;
/// Doubles hold halves of integers below this.
constexpr int64_t max_level = int64_t{1} << 51;
constexpr double relative_error = 1e-9;

Vector operator-(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
int64_t dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point as_doubles(const Vector &a) { return {double(a[0]), double(a[1]), double(a[2])}; }
EdgeKey edge_key(uint32_t a, uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// The plane of the points p with normal . p = level.
struct IntegerPlane {
    Vector point, normal;
    int64_t level() const { return dot(normal, point); }
    int64_t side(const Vector &p) const { return dot(normal, p) - level(); }
};

/// A mesh of triangles on the lattice, for both libraries.
class Model {
public:
    /// Moves the points of triangles to a lattice of 2^`bits` units. Nothing if the mesh is not manifold.
    static std::unique_ptr<Model> on_lattice(Soup soup, int bits) {
        auto model = std::make_unique<Model>();
        Point low = soup.points.at(0);
        double size = 0;
        for (const Point &p : soup.points) {
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], p[k]);
            }
        }
        for (const Point &p : soup.points) {
            for (std::size_t k = 0; k < 3; ++k) {
                size = std::max(size, p[k] - low[k]);
            }
        }
        model->size = std::ldexp(1, bits);
        for (Point &p : soup.points) {
            Vector place{};
            for (std::size_t k = 0; k < 3; ++k) {
                place[k] = std::llround((p[k] - low[k]) / size * model->size);
                p[k] = double(place[k]);
            }
            model->places.push_back(place);
        }
        auto [points, faces] = CgalSoup<Kernel::Point_3>(soup.view());
        if (!PMP::is_polygon_soup_a_polygon_mesh(faces)) {
            return nullptr;
        }
        PMP::polygon_soup_to_polygon_mesh(points, faces, model->cgal);
        model->closed = CGAL::is_closed(model->cgal);
        model->soup = std::move(soup);
        model->slicer.emplace(model->cgal);
        return model;
    }

    std::vector<Polyline> slice(const IntegerPlane &plane, double above) const {
        std::vector<Polyline> found;
        const Point n = as_doubles(plane.normal);
        (*slicer)(Kernel::Plane_3(n[0], n[1], n[2], -double(plane.level()) - above), std::back_inserter(found));
        return found;
    }

    Soup soup;
    std::vector<Vector> places;
    CgalMesh cgal;
    std::optional<Slicer> slicer;
    bool closed = false;
    double size = 0;
};

IntegerPlane random_plane(const Model &model, Random &random) {
    const auto near_unit = [&](int64_t most) {
        Vector n{};
        while (n == Vector{}) {
            for (int64_t &x : n) {
                x = int64_t(random.below(std::size_t(2 * most + 1))) - most;
            }
        }
        return n;
    };
    const auto face = model.soup.view().face(random.below(model.soup.face_count()));
    const Vector a = model.places[face[0]], b = model.places[face[1]], c = model.places[face[2]];
    const IntegerPlane through_vertex{a, near_unit(512)};
    IntegerPlane plane = through_vertex;
    switch (random.below(5)) {
    case 0: {
        Vector axis{};
        axis[random.below(3)] = random.one_in(2) ? 1 : -1;
        return {a, axis};
    }
    case 1: plane.normal = cross(b - a, near_unit(16)); break;
    case 2: plane.normal = cross(b - a, c - a); break;
    case 3:
        for (int64_t &x : plane.point) {
            x = random.below(std::size_t(model.size));
        }
        break;
    default: break;
    }
    return plane.normal == Vector{} || std::abs(plane.level()) >= max_level ? through_vertex : plane;
}

double distance(const Point &a, const Point &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Measures of a polyline.
struct Measures {
    bool closed;
    double length, area;
};

std::vector<Measures> measure(const std::vector<Polyline> &polylines, const Vector &normal) {
    const Point n = as_doubles(normal);
    const double length_of_normal = distance(n, {});
    std::vector<Measures> all;
    for (const Polyline &polyline : polylines) {
        Measures one{polyline.size() > 1 && polyline.front() == polyline.back(), 0, 0};
        const auto &first = polyline.front();
        for (std::size_t k = 1; k < polyline.size(); ++k) {
            one.length += std::sqrt((polyline[k] - polyline[k - 1]).squared_length());
            const auto twice = CGAL::cross_product(polyline[k - 1] - first, polyline[k] - first);
            one.area += (twice.x() * n[0] + twice.y() * n[1] + twice.z() * n[2]) / length_of_normal / 2;
        }
        one.area = one.closed ? one.area : 0;
        all.push_back(one);
    }
    return all;
}

/// The polylines as CGAL has them: closed ones repeat their first point. An open one may end where it begins, because vertices of
/// a border may coincide.
std::vector<Polyline> polylines_of(const gusset::MeshSections &sections) {
    std::vector<Polyline> all;
    for (const gusset::SectionPath &path : sections) {
        Polyline polyline;
        for (const Point &p : path.points) {
            polyline.emplace_back(p[0], p[1], p[2]);
        }
        if (path.is_closed()) {
            polyline.push_back(polyline.front());
        }
        all.push_back(std::move(polyline));
    }
    return all;
}

/// The lengths and areas that paths state equal the measures of their points.
void check_measures(Case &test, const gusset::MeshSections &sections, const std::vector<Measures> &measured, double size) {
    for (std::size_t k = 0; k < measured.size(); ++k) {
        const gusset::SectionPath path = sections[k];
        test.at_most(std::abs(path.path.length - measured[k].length), relative_error * size, "error of a length");
        test.at_most(path.is_closed() ? std::abs(path.path.area - measured[k].area) : std::abs(path.path.area), relative_error * size * size, "error of an area");
    }
}

void compare(Case &test, std::vector<Measures> ours, std::vector<Measures> theirs, double size) {
    if (!test.equal(ours.size(), theirs.size(), "polylines of a plane without vertices")) {
        return;
    }
    const auto sort_by = [&](double Measures::*field) {
        for (auto *list : {&ours, &theirs}) {
            std::sort(list->begin(), list->end(), [&](const Measures &a, const Measures &b) { return std::pair(a.closed, a.*field) < std::pair(b.closed, b.*field); });
        }
    };
    sort_by(&Measures::length);
    for (std::size_t k = 0; k < ours.size(); ++k) {
        test.equal(ours[k].closed, theirs[k].closed, "closedness of a polyline");
        test.at_most(std::abs(ours[k].length - theirs[k].length), relative_error * size, "difference of lengths");
    }
    sort_by(&Measures::area);
    for (std::size_t k = 0; k < ours.size(); ++k) {
        test.at_most(std::abs(ours[k].area - theirs[k].area), relative_error * size * size, "difference of areas");
    }
}

/// Adds the segments of sections, each as the pair of edges at its ends, with its length.
void collect_segments(const gusset::MeshSections &sections, std::map<std::pair<EdgeKey, EdgeKey>, double> &segments) {
    for (const gusset::SectionPath &path : sections) {
        const std::size_t count = path.size();
        for (std::size_t k = 0; k + (path.is_closed() ? 0 : 1) < count; ++k) {
            const std::size_t next = (k + 1) % count;
            const auto key = [&](std::size_t i) { return edge_key(path.edges[2 * i], path.edges[2 * i + 1]); };
            const EdgeKey from = key(k), to = key(next);
            segments[{std::min(from, to), std::max(from, to)}] = distance(path.points[k], path.points[next]);
        }
    }
}

/// The length of all edges on a border whose face is in the plane.
double border_length_in_plane(const Model &model, const IntegerPlane &plane) {
    std::map<EdgeKey, std::size_t> uses;
    double length = 0;
    for (std::size_t pass = 0; pass < 2; ++pass) {
        for (std::size_t f = 0; f < model.soup.face_count(); ++f) {
            const auto face = model.soup.view().face(f);
            const bool coplanar = std::all_of(face.begin(), face.end(), [&](uint32_t v) { return plane.side(model.places[v]) == 0; });
            for (std::size_t k = 0; k < face.size(); ++k) {
                const EdgeKey edge = edge_key(face[k], face[(k + 1) % face.size()]);
                if (pass == 0) {
                    ++uses[edge];
                } else if (coplanar && uses[edge] == 1) {
                    length += distance(model.soup.points[edge.first], model.soup.points[edge.second]);
                }
            }
        }
    }
    return length;
}

/// The vertices in the plane whose neighbours are all on the side of `sign`.
std::size_t count_peaks(const Model &model, const IntegerPlane &plane, int64_t sign) {
    std::map<uint32_t, bool> is_peak;
    for (std::size_t f = 0; f < model.soup.face_count(); ++f) {
        const auto face = model.soup.view().face(f);
        for (uint32_t v : face) {
            if (plane.side(model.places[v]) == 0) {
                bool &peak = is_peak.emplace(v, true).first->second;
                for (uint32_t u : face) {
                    peak = peak && (u == v || plane.side(model.places[u]) * sign > 0);
                }
            }
        }
    }
    return std::size_t(std::count_if(is_peak.begin(), is_peak.end(), [](const auto &one) { return one.second; }));
}

/// Points are on the plane and on their edges; each segment is in its face.
void check_sources(Case &test, const Model &model, const IntegerPlane &plane, const gusset::MeshSections &sections) {
    const Point n = as_doubles(plane.normal), o = as_doubles(plane.point);
    const double length_of_normal = distance(n, {});
    for (const gusset::SectionPath &path : sections) {
        for (std::size_t k = 0; k < path.size(); ++k) {
            const uint32_t a = path.edges[2 * k], b = path.edges[2 * k + 1];
            const Point &p = model.soup.points[a], &q = model.soup.points[b], &at = path.points[k];
            const double t = path.parameters[k];
            const Point placed{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
            test.at_most(distance(at, placed), 1e-12 * model.size, "distance of a point from its edge");
            double height = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                height += n[i] * (at[i] - o[i]);
            }
            test.at_most(std::abs(height) / length_of_normal, 1e-12 * model.size, "distance of a point from its plane");
            if (path.faces[k] == UINT32_MAX) {
                test.check(!path.is_closed() && k + 1 == path.size(), "a segment lacks its face");
                continue;
            }
            const auto face = model.soup.view().face(path.faces[k]);
            const auto has = [&](uint32_t v) { return std::find(face.begin(), face.end(), v) != face.end(); };
            const std::size_t next = (k + 1) % path.size();
            test.check(has(a) && has(b) && has(path.edges[2 * next]) && has(path.edges[2 * next + 1]), "a segment is not in its face");
        }
    }
}

void check_plane(Case &test, const Model &model, const IntegerPlane &plane) {
    const auto planes = gusset::CuttingPlanes::plane(as_doubles(plane.point), as_doubles(plane.normal));
    gusset::MeshSectionOptions options;
    const gusset::MeshSections above(model.soup.view(), planes, options);
    options.in_plane = gusset::InPlane::below;
    const gusset::MeshSections below(model.soup.view(), planes, options);
    const std::vector<Polyline> theirs = model.slice(plane, 0);
    for (const auto *sections : {&above, &below}) {
        check_sources(test, model, plane, *sections);
        check_measures(test, *sections, measure(polylines_of(*sections), plane.normal), model.size);
        for (const gusset::SectionPath &path : *sections) {
            test.check(path.is_closed() || !model.closed, "a closed mesh has an open polyline");
        }
    }
    std::set<uint32_t> used(model.soup.corners.begin(), model.soup.corners.end());
    if (std::none_of(used.begin(), used.end(), [&](uint32_t v) { return plane.side(model.places[v]) == 0; })) {
        test.note("planes without vertices");
        for (const auto *sections : {&above, &below}) {
            compare(test, measure(polylines_of(*sections), plane.normal), measure(theirs, plane.normal), model.size);
        }
        return;
    }
    std::map<std::pair<EdgeKey, EdgeKey>, double> segments;
    collect_segments(above, segments);
    collect_segments(below, segments);
    double ours = border_length_in_plane(model, plane), all_of_theirs = 0;
    for (const auto &[ends, length] : segments) {
        ours += length;
    }
    for (const Measures &one : measure(theirs, plane.normal)) {
        all_of_theirs += one.length;
    }
    test.note("planes through vertices");
    test.at_most(std::abs(ours - all_of_theirs), relative_error * model.size, "difference of the length of all segments");
    test.equal(above.size() + count_peaks(model, plane, -1), model.slice(plane, -0.5).size(), "polylines just below the plane");
    test.equal(below.size() + count_peaks(model, plane, 1), model.slice(plane, 0.5).size(), "polylines just above the plane");
}

/// Some heights become equal, so that many faces are horizontal.
void make_terraces(Soup &soup, Random &random) {
    const double step = random.real(0.1, 0.4);
    for (Point &p : soup.points) {
        p[2] = std::round(p[2] / step) * step;
    }
}

/// The meshes of the data folder that are manifold, on the lattice.
const std::vector<std::pair<std::string, std::unique_ptr<Model>>> &real_models() {
    static const auto models = [] {
        std::vector<std::pair<std::string, std::unique_ptr<Model>>> made;
        Random random(1);
        for (const DataFile &file : data_files()) {
            if (file.manifold && file.faces < 200'000) {
                auto model = Model::on_lattice(cut_to_triangles(read_soup(file.path), random, 1), 18);
                if (model != nullptr) {
                    made.emplace_back(file.name, std::move(model));
                }
            }
        }
        return made;
    }();
    return models;
}
} // namespace
} // namespace of_sections

void sections(Case &test) {
    using namespace of_sections;
    Random &random = test.random;
    Soup soup = random_shape(random, static_cast<Shape>(random.below(4)));
    if (random.one_in(3)) {
        make_terraces(soup, random);
    }
    soup = cut_to_triangles(soup, random, 1);
    const auto model = Model::on_lattice(random.one_in(3) ? compact(with_holes(soup, random)) : soup, 15);
    if (model == nullptr) {
        test.note("holes that touch");
        return;
    }
    for (std::size_t k = 0; k < planes_per_case; ++k) {
        check_plane(test, *model, random_plane(*model, random));
    }
}

void real_sections(Case &test) {
    using namespace of_sections;
    if (!data_folder()) {
        test.note("SKIPPED");
        return;
    }
    const auto &[name, model] = test.random.any(real_models());
    test.note(name);
    for (std::size_t k = 0; k < planes_per_case; ++k) {
        check_plane(test, *model, random_plane(*model, test.random));
    }
}
} // namespace campaign
