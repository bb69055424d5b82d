// Attributes carried over by the wrapper, for each kind of result; fields on real meshes.
#include "data.hpp"
#include "soup.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace attributes_tests {

namespace {
using gusset::Domain;
using gusset::Rule;
using Uv = std::array<double, 2>;

/// A field that is linear in space.
double field(const gusset::Point3 &p) {
    return 0.7 * p[0] - 1.3 * p[1] + 0.4 * p[2];
}

double reach(const Soup &soup) {
    double far = 0;
    for (const auto &p : soup.points) {
        far = std::max({far, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    }
    return far;
}

/// Checks any result: weights sum to 1, linear fields of vertices and corners hold within 1e-6 of the meshes' size, or
/// within what the distance of merged vertices allows, and integers of faces come from sources.
void check_fields(const gusset::Origins &origins, const gusset::MeshView &made, const std::vector<Soup> &pieces,
                  double merged_distance = 0) {
    std::vector<std::vector<double>> vertices, corners;
    std::vector<std::vector<uint32_t>> faces;
    double size = 1e-300;
    uint32_t face = 0;
    for (const Soup &soup : pieces) {
        vertices.emplace_back(), corners.emplace_back(), faces.emplace_back();
        for (const auto &p : soup.points) {
            vertices.back().push_back(field(p));
        }
        for (const uint32_t v : soup.corners) {
            corners.back().push_back(vertices.back()[v]);
        }
        for (std::size_t f = 0; f < soup.face_count(); ++f) {
            faces.back().push_back(face++);
        }
        size = std::max(size, reach(soup));
    }
    const auto spans = [](const auto &lists) {
        using Value = typename std::decay_t<decltype(lists)>::value_type::value_type;
        return std::vector<gusset::Span<const Value>>(lists.begin(), lists.end());
    };
    const std::vector<double> at = origins.apply(Domain::vertices, Rule::linear, spans(vertices));
    REQUIRE(at.size() == made.vertex_count());
    double worst = 0;
    for (std::size_t v = 0; v < at.size(); ++v) {
        worst = std::max(worst, std::abs(at[v] - field(made.position(v))));
    }
    const double allowed = std::max(1e-6 * size, 2 * merged_distance); // the gradient of the field is 1.53 long
    CHECK(worst <= allowed);
    const std::vector<double> of_corners = origins.apply(Domain::corners, Rule::linear, spans(corners));
    const std::vector<uint32_t> numbers = origins.apply(Domain::faces, Rule::nearest, spans(faces));
    REQUIRE(numbers.size() == made.face_count());
    std::size_t corner = 0;
    worst = 0;
    for (std::size_t f = 0; f < made.face_count(); ++f) {
        CHECK(numbers[f] < face);
        for (const uint32_t v : made.face(f)) {
            worst = std::max(worst, std::abs(of_corners[corner++] - field(made.position(v))));
        }
    }
    CHECK(corner == of_corners.size());
    CHECK(worst <= allowed);
    for (const Domain domain : {Domain::vertices, Domain::corners, Domain::faces}) {
        const gusset::Indices offsets = origins.offsets(domain);
        const auto weights = origins.weights(domain);
        for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
            double sum = 0;
            for (uint32_t e = offsets[k]; e < offsets[k + 1]; ++e) {
                sum += weights[e];
                CHECK(weights[e] > 0);
            }
            CHECK(std::abs(sum - 1) < 1e-9);
        }
    }
}

/// A half of a globe, open below, its rim at the height z.
Soup bowl(uint32_t n, double z, double turn) {
    Soup soup;
    soup.points.push_back({0, 0, turn * (z + 1)});
    for (uint32_t ring = 1; ring <= 3; ++ring) {
        for (uint32_t i = 0; i < n; ++i) {
            const double angle = turn * 6.283185307179586 * (i + 0.25 * ring) / n;
            soup.points.push_back({ring * std::cos(angle), ring * std::sin(angle), turn * (z + 1 - ring / 3.0)});
        }
    }
    for (uint32_t i = 0; i < n; ++i) {
        soup.add_face({0, 1 + i, 1 + (i + 1) % n});
        for (uint32_t ring = 0; ring < 2; ++ring) {
            const uint32_t a = 1 + ring * n + i, b = 1 + ring * n + (i + 1) % n;
            soup.add_face({a, a + n, b + n, b});
        }
    }
    return soup;
}
} // namespace

TEST_CASE("linear fields on every kind of result") {
    const Soup up = bowl(24, 1, 1), down = bowl(17, 1, -1);
    gusset::StitchOptions options;
    options.row_count = 2;
    const gusset::Stitch stitch = gusset::stitch(up.view(), down.view(), options);
    check_fields(stitch.origins(), stitch.mesh(), {up, down});

    gusset::FillOptions fine;
    fine.refine = gusset::FillRefinement::rim_density;
    const gusset::Fill fill(up.view(), fine);
    check_fields(fill.origins(), fill.mesh(), {up});

    gusset::JoinOptions all;
    all.strip_options = options;
    all.fill = true;
    all.fill_options = fine;
    const std::vector<gusset::MeshView> pieces{up.view(), down.view()};
    const gusset::Join assembly(pieces, all);
    check_fields(assembly.origins(), assembly.mesh(), {up, down});

    // Faces with vertices of their own.
    Soup apart;
    for (std::size_t f = 0; f < up.face_count(); ++f) {
        std::vector<uint32_t> face;
        for (const uint32_t v : up.view().face(f)) {
            face.push_back(static_cast<uint32_t>(apart.points.size()));
            apart.points.push_back(up.points[v]);
        }
        if (f % 3 == 1) {
            std::reverse(face.begin(), face.end());
        }
        apart.add_face(face);
    }
    const gusset::Weld weld(apart.view());
    check_fields(weld.origins(), weld.mesh(), {apart});
    const gusset::Sew sew(apart.view());
    check_fields(sew.origins(), sew.mesh(), {apart});
    const Soup welded = copy_of(weld.mesh());
    const gusset::Orient orient(welded.view());
    CHECK(orient.turned_faces() > 0);
    check_fields(orient.origins(), orient.mesh(), {welded});
}

TEST_CASE("values of any type, and mistakes") {
    const Soup up = bowl(12, 1, 1), down = bowl(12, 1, -1);
    const gusset::Stitch stitch = gusset::stitch(up.view(), down.view());
    const gusset::Origins origins = stitch.origins();
    CHECK(origins.starts(Domain::faces)[2] == up.face_count() + down.face_count());
    const std::vector<std::array<uint8_t, 4>> red(up.points.size(), {200, 0, 0, 255});
    const auto some = origins.apply<std::array<uint8_t, 4>>(Domain::vertices, Rule::linear, {red, {}});
    CHECK(some.front() == red.front());
    CHECK(some.back() == std::array<uint8_t, 4>{});
    CHECK_THROWS_AS((origins.apply<std::array<uint8_t, 4>>(Domain::vertices, Rule::linear, {red})), gusset::Error);
    CHECK_THROWS_AS((origins.apply<std::array<uint8_t, 4>>(Domain::faces, Rule::linear, {red, {}})), gusset::Error);
}

TEST_CASE("meshes of nets and of sheets") {
    const gusset::Net net = gusset::Net::from_primitive(gusset::Primitive::sphere(1.0).with(9, 17));
    const gusset::NetMesh mesh(net);
    const gusset::Origins origins = mesh.origins();
    std::vector<double> nodes(9 * 17);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        nodes[k] = static_cast<double>(k % 17) / 16;
    }
    const std::vector<double> u = origins.apply<double>(Domain::corners, Rule::linear, {nodes});
    // No face runs back from the last column to the first.
    std::size_t corner = 0;
    for (std::size_t f = 0; f < mesh.mesh().face_count(); ++f) {
        const std::size_t count = mesh.mesh().face(f).size();
        const auto [low, high] = std::minmax_element(u.begin() + static_cast<std::ptrdiff_t>(corner), u.begin() + static_cast<std::ptrdiff_t>(corner + count));
        CHECK(*high - *low < 1.5 / 16);
        corner += count;
    }
}

TEST_SUITE_BEGIN("real meshes");

TEST_CASE("linear fields on real meshes") {
    const auto folder = data_folder();
    if (!folder) {
        return;
    }
    std::size_t tried = 0;
    for (const DataFile &file : data_files()) {
        if (file.faces > 200000) {
            continue;
        }
        const Soup soup = read_soup(file.path);
        INFO(file.name);
        const gusset::Fill fill(soup.view());
        check_fields(fill.origins(), fill.mesh(), {soup});
        const std::vector<gusset::MeshView> pieces{soup.view()};
        gusset::JoinOptions rows;
        rows.strip_options.rows = gusset::RowRule::mean_edge;
        const gusset::Join assembly(pieces, rows);
        check_fields(assembly.origins(), assembly.mesh(), {soup}, gusset::Weld(soup.view()).tolerance());
        ++tried;
    }
    CHECK(tried > 10);
    MESSAGE(tried, " meshes filled and assembled");
}

TEST_SUITE_END();

} // namespace attributes_tests
