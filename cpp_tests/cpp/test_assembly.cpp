// Assembly of many pieces, and the faces of strips that cut others, with CGAL as judge.
#include "data.hpp"
#include "judge.hpp"
#include "soup.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <set>

namespace assembly_tests {

namespace {
using Lengths = std::vector<std::size_t>;
using Point = std::array<double, 3>;
using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

std::vector<gusset::MeshView> views(const std::vector<Soup> &pieces) {
    std::vector<gusset::MeshView> all;
    for (const Soup &piece : pieces) {
        all.push_back(piece.view());
    }
    return all;
}

Pairs pairs_of(gusset::Indices list) {
    Pairs pairs;
    for (std::size_t k = 0; k < list.size(); k += 2) {
        pairs.insert({list[k], list[k + 1]});
    }
    CHECK(pairs.size() == list.size() / 2);
    return pairs;
}

/// Compares the intersections that a stitch reports with CGAL's. Returns the number of pairs.
std::size_t check_cuts(const gusset::Stitch &stitch) {
    REQUIRE(stitch.intersections());
    const auto [first, count] = stitch.strip_faces();
    const Pairs ours = pairs_of(*stitch.intersections());
    CHECK((ours == intersecting_pairs(stitch.mesh(), first, count)));
    return ours.size();
}

/// Polygons as fans of triangles.
Soup fans(const Soup &soup) {
    Soup split;
    split.points = soup.points;
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        const auto face = soup.view().face(f);
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            split.add_face({face[0], face[k], face[k + 1]});
        }
    }
    return split;
}

Soup turned(Soup soup) {
    for (std::size_t f = 0; f < soup.face_count(); ++f) {
        std::reverse(soup.corners.begin() + soup.offsets[f], soup.corners.begin() + soup.offsets[f + 1]);
    }
    return soup;
}

/// A grid of cells over the unit square, closed round in the first direction, or in both.
Soup surface(uint32_t n, uint32_t m, bool both, const std::function<Point(double, double)> &at) {
    Soup soup;
    const uint32_t rows = both ? m : m + 1;
    for (uint32_t j = 0; j < rows; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            soup.points.push_back(at(double(i) / n, double(j) / m));
        }
    }
    for (uint32_t j = 0; j < m; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t k = (i + 1) % n, l = (j + 1) % rows;
            soup.add_face({j * n + i, j * n + k, l * n + k, l * n + i});
        }
    }
    return soup;
}

/// Pieces by the colours of the faces, each with its own vertices, moved a little towards their
/// middles.
std::vector<Soup> cut(const Soup &whole, double shrink, const std::function<int(Point)> &colour) {
    std::map<int, Soup> pieces;
    std::map<int, std::map<uint32_t, uint32_t>> numbers;
    for (std::size_t f = 0; f < whole.face_count(); ++f) {
        const auto corners = whole.view().face(f);
        Point centre{};
        for (uint32_t v : corners) {
            for (int k = 0; k < 3; ++k) {
                centre[k] += whole.points[v][k] / double(corners.size());
            }
        }
        const int c = colour(centre);
        std::vector<uint32_t> face;
        for (uint32_t v : corners) {
            const auto number = static_cast<uint32_t>(pieces[c].points.size());
            const auto [place, is_first] = numbers[c].insert({v, number});
            if (is_first) {
                pieces[c].points.push_back(whole.points[v]);
            }
            face.push_back(place->second);
        }
        pieces[c].add_face(face);
    }
    std::vector<Soup> list;
    for (auto &[c, piece] : pieces) {
        for (int k = 0; k < 3; ++k) {
            double middle = 0;
            for (const Point &p : piece.points) {
                middle += p[k] / double(piece.points.size());
            }
            for (Point &p : piece.points) {
                p[k] += shrink * (middle - p[k]);
            }
        }
        list.push_back(piece);
    }
    return list;
}

Soup torus(uint32_t n, uint32_t m) {
    return surface(n, m, true, [](double s, double t) {
        const double r = 2 + std::cos(2 * M_PI * t);
        return Point{r * std::cos(2 * M_PI * s), r * std::sin(2 * M_PI * s), std::sin(2 * M_PI * t)};
    });
}

/// The volume by the divergence theorem; negative if faces look inwards.
double volume(const gusset::MeshView &mesh) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            const Point a = mesh.position(face[0]), b = mesh.position(face[k]), c = mesh.position(face[k + 1]);
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3, l = (i + 2) % 3;
                sum += a[i] * (b[j] * c[l] - b[l] * c[j]) / 6;
            }
        }
    }
    return sum;
}

int octant(Point p) { return (p[0] > 0) + 2 * (p[1] > 0) + 4 * (p[2] > 0); }

/// The report fits the mesh: every face of a piece occurs once, and every other face and vertex is
/// made by one joint or hole. The mesh is one for CGAL, with the loops that the account says.
Verdict check_account(const gusset::Join &done, const std::vector<Soup> &pieces, bool intersections = true) {
    const gusset::MeshView mesh = done.mesh();
    const gusset_join_report parts = done.report();
    std::vector<int> faces(mesh.face_count()), vertices(mesh.vertex_count());
    REQUIRE(done.pieces().size() == pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const gusset_piece_map map = done.pieces()[k];
        REQUIRE(map.vertices.count == pieces[k].points.size());
        REQUIRE(map.faces.count == pieces[k].face_count());
        for (std::size_t v = 0; v < map.vertices.count; ++v) {
            vertices[map.vertices.data[v]] = 1;
            CHECK(mesh.position(map.vertices.data[v]) == pieces[k].points[v]);
        }
        for (std::size_t f = 0; f < map.faces.count; ++f) {
            faces[map.faces.data[f]] += 1;
        }
    }
    const auto made = [&](std::size_t first_v, std::size_t count_v, std::size_t first_f, std::size_t count_f) {
        std::for_each_n(vertices.begin() + long(first_v), count_v, [](int &n) { n += 1; });
        std::for_each_n(faces.begin() + long(first_f), count_f, [](int &n) { n += 1; });
    };
    for (const gusset_joint &joint : done.joints()) {
        made(joint.vertex_first, joint.vertex_count, joint.face_first, joint.face_count);
        CHECK((joint.outcome == GUSSET_JOINT_JOINED) == (joint.face_count > 0));
    }
    for (const gusset_hole &hole : done.holes()) {
        made(hole.vertex_first, hole.vertex_count, hole.face_first, hole.face_count);
    }
    const auto once = [](const std::vector<int> &list) {
        return std::all_of(list.begin(), list.end(), [](int n) { return n == 1; });
    };
    CHECK(once(faces));
    CHECK(once(vertices));
    const Verdict verdict = judge(mesh, intersections);
    CHECK(verdict.is_mesh);
    CHECK(verdict.boundary.size() == parts.loops_left);
    CHECK(parts.non_manifold_edges == 0);
    return verdict;
}

void check_closed(const Verdict &verdict, long euler) {
    CHECK(verdict.closed);
    CHECK(verdict.components == 1);
    CHECK(verdict.euler == euler);
}
} // namespace

TEST_CASE("cuts are those that CGAL finds") {
    const auto circle = [](double r, double x, double z) {
        return [=](double s, double t) {
            const double a = 2 * M_PI * s;
            return Point{x + r * (1 + 0.3 * t) * std::cos(a), r * std::sin(a), z + t + 0.3 * r * std::sin(5 * a)};
        };
    };
    const Soup low = fans(surface(31, 1, false, circle(1, 0, 0)));
    // Above it, at its height, through it, and beside it, wide and narrow.
    const std::vector<Soup> others = {
        surface(23, 1, false, circle(0.9, 0.1, 0.4)),  surface(30, 1, false, circle(1.0, 0.03, 0.2)),
        surface(17, 1, false, circle(0.5, 0.8, -0.2)), surface(60, 1, false, circle(1.3, 2.9, 0.1)),
        surface(5, 1, false, circle(0.2, 0.3, 0.7)),
    };
    std::size_t cuts = 0, faired = 0;
    for (const Soup &quads : others) {
        const Soup other = fans(quads);
        for (uint32_t rule = 0; rule < 8; ++rule) {
            for (uint32_t rows : {0u, 1u, 4u}) {
                gusset::StitchOptions options;
                options.meridians = static_cast<gusset::Meridians>(rule);
                options.row_count = rows;
                options.intersections = gusset::Intersections::report;
                CAPTURE(rule);
                CAPTURE(rows);
                const std::size_t straight = check_cuts(gusset::stitch(low.view(), other.view(), options));
                options.fairing = gusset::Fairing::thin_plate;
                const std::size_t smooth = check_cuts(gusset::stitch(low.view(), other.view(), options));
                CHECK(smooth <= straight);
                cuts += straight, faired += smooth;
            }
        }
    }
    // The inputs have intersections to compare, and fairing avoids some of them.
    CHECK(cuts > 1000);
    CHECK(faired < cuts);
}

TEST_CASE("a torus in sectors, apart, some inside out: closed, and outwards, or as the first piece faces") {
    const auto sectors = cut(torus(30, 20), 0.05, [](Point p) { return int(2.5 + 2.5 * std::atan2(p[1], p[0]) / M_PI); });
    REQUIRE(sectors.size() == 5);
    for (unsigned set : {0u, 1u, 6u, 21u, 31u}) {
        for (bool rows : {false, true}) {
            std::vector<Soup> pieces;
            for (std::size_t k = 0; k < sectors.size(); ++k) {
                pieces.push_back(set >> k & 1 ? turned(sectors[k]) : sectors[k]);
            }
            gusset::JoinOptions options;
            options.outward = set / 2 % 2 == 0 ? gusset::Outward::keep : gusset::Outward::closed;
            options.strip_options.rows = rows ? gusset::RowRule::mean_edge : gusset::RowRule::none;
            options.strip_options.meridians = rows ? gusset::Meridians::quad : gusset::Meridians::min_area;
            options.strip_options.cells = rows ? gusset::StripCells::quads : gusset::StripCells::triangles;
            options.strip_options.fairing = rows ? gusset::Fairing::thin_plate : gusset::Fairing::none;
            const gusset::Join done(views(pieces), options);
            const Verdict verdict = check_account(done, pieces);
            check_closed(verdict, 0);
            CHECK(verdict.self_intersections == 0);
            CHECK(verdict.bounds_a_volume);
            CHECK((volume(done.mesh()) > 0) == (set % 2 == 0 || options.outward == gusset::Outward::closed));
            CHECK(done.joints().size() == 5);
            CHECK(done.left().empty());
        }
    }
}

TEST_CASE("octants: sewn where they touch, joined and filled where they do not") {
    const Soup ball = surface(24, 12, false, [](double s, double t) {
        const double a = 2 * M_PI * s, b = 0.3 + (M_PI - 0.6) * t;
        return Point{1.2 * std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), -std::cos(b)};
    });
    for (double gap : {0.0, 0.03}) {
        const auto pieces = cut(ball, gap, octant);
        REQUIRE(pieces.size() == 8);
        gusset::JoinOptions options;
        options.fill = true;
        const gusset::Join done(views(pieces), options);
        const Verdict verdict = check_account(done, pieces);
        check_closed(verdict, 2);
        CHECK(verdict.self_intersections == 0);
        CHECK(verdict.bounds_a_volume);
        CHECK(done.joints().empty() == (gap == 0.0));
        CHECK((done.report().welded_vertices > 0) == (gap == 0.0));
        // Without filling the holes stay: the ends, and where gaps meet.
        options.fill = false;
        CHECK(!check_account(gusset::Join(views(pieces), options), pieces).closed);
    }
}

TEST_CASE("pairs, exclusions and widths through the wrapper") {
    const auto halves = cut(torus(24, 12), 0.06, [](Point p) { return p[1] > 0; });
    gusset::JoinOptions options;
    const gusset::Join joined(views(halves), options);
    CHECK(joined.joints().size() == 2);
    options.excluded = {{{0, 1}, {UINT32_MAX, UINT32_MAX}}};
    const gusset::Join apart(views(halves), options);
    CHECK(apart.joints().empty());
    options.excluded.clear();
    options.max_gap = 0.0;
    const gusset::Join open(views(halves), options);
    CHECK(check_account(open, halves).boundary == Lengths{12, 12, 12, 12});
    for (const gusset_left_loop &left : open.left()) {
        CHECK(left.reason == GUSSET_LEFT_TOO_FAR);
        CHECK((left.gap > 0 && left.allowed_gap == 0));
    }
    REQUIRE(open.left().size() == 4);
    // The loops of the first half come first; one of them is joined to each of the other half's.
    const auto vertex = [&](std::size_t loop, std::size_t piece) {
        const auto found = open.left()[loop].vertices.data[0];
        return piece == 0 ? found : found - static_cast<uint32_t>(halves[0].points.size());
    };
    for (std::size_t other : {2u, 3u}) {
        options.pairs = {{{0, 1}, {vertex(0, 0), vertex(other, 1)}}};
        const gusset::Join done(views(halves), options);
        const Verdict verdict = check_account(done, halves, false);
        CHECK(verdict.boundary == Lengths{12, 12});
        CHECK(verdict.euler == 0);
    }
    options.pairs = {{{0, 7}, {0, 0}}};
    CHECK_THROWS_AS(gusset::Join(views(halves), options), gusset::Error);
    CHECK_THROWS_AS(gusset::Join(views({})), gusset::Error);
}

TEST_SUITE_BEGIN("real meshes");

namespace {
/// The assembly of files of the data folder; nothing without data.
std::optional<std::pair<gusset::Join, Verdict>> assembled(const std::vector<std::string> &names,
                                                              const gusset::JoinOptions &options = {}) {
    const auto folder = data_folder();
    if (!folder) {
        return std::nullopt;
    }
    std::vector<Soup> pieces;
    for (const std::string &name : names) {
        pieces.push_back(read_soup(*folder + "/" + name));
    }
    gusset::Join done(views(pieces), options);
    const Verdict verdict = check_account(done, pieces);
    return std::pair(std::move(done), verdict);
}

/// Each loop of the result is a loop of the pieces that was left with its reason, or lies along a
/// joint.
void check_reasons(const gusset::Join &done) {
    CHECK(done.left().size() + done.joints().size() > 0);
    for (const gusset_left_loop &left : done.left()) {
        CHECK(left.vertices.count > 0);
        const bool tried = std::any_of(done.joints().begin(), done.joints().end(), [](const gusset_joint &joint) {
            return joint.outcome != GUSSET_JOINT_JOINED;
        });
        CHECK((left.reason != GUSSET_LEFT_NOT_JOINED || tried));
    }
}
} // namespace

TEST_CASE("surfaces cut along their borders") {
    const std::string pair = "pairs/combustor/";
    if (const auto found = assembled({pair + "walls.stl", pair + "inlet.stl", pair + "outlet.stl"})) {
        check_closed(found->second, 0);
        CHECK(found->first.mesh().vertex_count() == 1728);
        CHECK(found->first.mesh().face_count() == 3456);
        CHECK(found->second.bounds_a_volume);
    }
    if (const auto found = assembled({"meshes/boeing.off"})) {
        check_closed(found->second, -18);
        CHECK(found->first.mesh().vertex_count() == 1264);
        CHECK(found->first.mesh().face_count() == 2564);
    }
    if (const auto found = assembled({"pairs/mask_cone.off"})) {
        CHECK(found->first.mesh().vertex_count() == 1200);
        CHECK(found->second.boundary == Lengths{34, 30});
    }
    if (const auto found = assembled({"pairs/quads_to_stitch.off"})) {
        CHECK(found->first.mesh().vertex_count() == 15);
        CHECK(found->second.boundary == Lengths{12});
    }
    for (const char *name : {"pairs/deg_border.off", "pairs/non_manifold2.off"}) {
        if (const auto found = assembled({name})) {
            check_reasons(found->first);
        }
    }
}

TEST_CASE("garment: hem to waist, sleeves, neck and legs left") {
    const std::string pair = "pairs/garment_casualsuit04/";
    if (const auto found = assembled({pair + "top.obj", pair + "trousers.obj"})) {
        CHECK(found->second.boundary == Lengths{20, 20, 20, 18, 18});
        CHECK(found->second.components == 1);
        REQUIRE(found->first.joints().size() == 1);
        const gusset_joint joint = found->first.joints()[0];
        CHECK(joint.whole == 1);
        CHECK(std::set{joint.side[0].count, joint.side[1].count} == std::set<std::size_t>{26, 36});
        check_reasons(found->first);
    }
}

TEST_CASE("bunny: head and body") {
    const std::string pair = "pairs/bunny_cut/";
    gusset::JoinOptions options;
    options.strip_options.intersections = gusset::Intersections::report;
    if (const auto found = assembled({pair + "body.off", pair + "head.off"}, options)) {
        CHECK(found->second.components == 1);
        CHECK(found->second.boundary == Lengths{80, 42, 40, 39, 22});
        CHECK(found->second.self_intersections == 0);
        REQUIRE(found->first.joints().size() == 1);
        CHECK(found->first.joints()[0].intersections_known == 1);
        CHECK(found->first.joints()[0].intersections.count == 0);
    }
    options.strip_options.meridians = gusset::Meridians::quad;
    options.strip_options.rows = gusset::RowRule::mean_edge;
    options.strip_options.fairing = gusset::Fairing::thin_plate;
    options.fill = true;
    if (const auto found = assembled({pair + "body.off", pair + "head.off"}, options)) {
        check_closed(found->second, 2);
        CHECK(found->second.self_intersections == 0);
        CHECK(found->second.bounds_a_volume);
    }
}

TEST_CASE("body and hand: what is joined is valid, what is left has its reason") {
    const std::string pair = "pairs/body_hand/";
    if (const auto found = assembled({pair + "body_741_no_left_hand.obj", pair + "hand_hires.obj"})) {
        check_reasons(found->first);
        CHECK(found->second.components == (found->first.joints().size() == 1 ? 1 : 2));
        std::cout << "body_hand: " << found->first.joints().size() << " joints, " << found->second.boundary.size()
                  << " loops left\n";
    }
    // The gap is wider than the wrist: joined if it may be that wide. Mouth and eyes stay.
    gusset::JoinOptions options;
    options.max_gap = 0.4;
    options.extent = gusset::JoinExtent::whole_loops;
    if (const auto found = assembled({pair + "body_741_no_left_hand.obj", pair + "hand_hires.obj"}, options)) {
        REQUIRE(found->first.joints().size() == 1);
        CHECK(found->first.joints()[0].side[0].count == 6);
        CHECK(found->first.joints()[0].side[1].count == 52);
        CHECK(found->second.components == 1);
        CHECK(found->second.boundary == Lengths{12, 6, 6});
    }
}

TEST_CASE("cuts of real strips are those that CGAL finds") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    const std::vector<std::pair<std::string, std::string>> files = {
        {"/pairs/body_hand/body_741_no_left_hand.obj", "/pairs/body_hand/hand_hires.obj"},
        {"/pairs/garment_casualsuit04/top.obj", "/pairs/garment_casualsuit04/trousers.obj"},
        {"/pairs/bunny_cut/body.off", "/pairs/bunny_cut/head.off"},
    };
    for (const auto &[first, second] : files) {
        const Soup a = fans(read_soup(*folder + first)), b = fans(read_soup(*folder + second));
        for (auto rule : {gusset::Meridians::min_area, gusset::Meridians::index, gusset::Meridians::quad}) {
            gusset::StitchOptions options;
            options.meridians = rule;
            options.row_count = rule == gusset::Meridians::min_area ? 0 : 3;
            options.intersections = gusset::Intersections::report;
            const std::size_t straight = check_cuts(gusset::stitch(a.view(), b.view(), options));
            options.fairing = gusset::Fairing::thin_plate;
            const std::size_t faired = check_cuts(gusset::stitch(a.view(), b.view(), options));
            CHECK(faired <= straight);
            std::cout << first << ": " << straight << " pairs of faces cut each other, faired " << faired << "\n";
        }
    }
}

TEST_SUITE_END();

} // namespace assembly_tests
