// Nets from C++: gluings, memory and copies, errors.
#include "nets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <thread>

namespace gluing_tests {

namespace {
using gusset::NetComplex;
using gusset::Gluing;
using gusset::GluingType;
using gusset::LocalGluing;
using gusset::Sides;
} // namespace

TEST_CASE("gluing and ungluing") {
    Net net = sheet(6, 7);
    CHECK(net.sides() == Sides::sheet);
    CHECK(gusset::NetGroups(net).empty());
    net.glue(LocalGluing::horizontal(0));
    CHECK(!net.sides());
    CHECK(net.classify_node(0) == GluingType::horizontal);
    CHECK(net.classify_node(20) == std::nullopt);
    net.glue(LocalGluing::star(16, gusset::Links::east | gusset::Links::south));
    CHECK(net.classify_node(16) == GluingType::east_south);
    const gusset::NetGroups groups(net);
    REQUIRE(groups.size() == 2);
    CHECK(std::vector<uint32_t>(groups[1].begin(), groups[1].end()) == std::vector<uint32_t>{16, 17, 23});
    CHECK_THROWS_AS(groups[2], gusset::Error);
    CHECK(net.classes()[23] == 16);
    CHECK(net.snap() == 3);
    CHECK(net.at(2, 3) == net.at(3, 2));
    CHECK(net.unglue(LocalGluing::horizontal(0), 0.5) == 2);
    CHECK(length(net.at(0, 0) - net.at(0, 1)) > 0.1);
    net.glue({LocalGluing::diagonal(24, gusset::Diagonal::falling), LocalGluing::horizontal(3)});
    CHECK(net.classify_cell(24) == GluingType::falling);
    CHECK(net.histogram().cells[static_cast<std::size_t>(GluingType::falling)] == 1);

    // All eighteen, each at a place of its own.
    for (uint32_t type = 0; type < 18; ++type) {
        Net glued = sheet(6, 7);
        glued.glue(LocalGluing::of_type(static_cast<GluingType>(type), 15));
        const auto found = type < 13 ? glued.classify_node(15) : glued.classify_cell(15);
        CHECK(found == static_cast<GluingType>(type));
    }
    // The counts of the histogram equal counts of single elements.
    for (const auto &[name, shape, euler] : closed_shapes()) {
        CAPTURE(name);
        const Net closed = Net::from_primitive(shape);
        const gusset::GluingHistogram histogram = closed.histogram();
        std::array<uint64_t, 18> nodes{}, cells{};
        uint64_t quads = 0;
        for (uint32_t node = 0; node < closed.node_count(); node += 7) {
            const auto found = closed.classify_node(node);
            if (found) {
                ++nodes[static_cast<std::size_t>(*found)];
                CHECK(nodes[static_cast<std::size_t>(*found)] <= histogram.nodes[static_cast<std::size_t>(*found)]);
            }
        }
        for (uint32_t cell = 0; cell < (closed.rows() - 1) * (closed.columns() - 1); ++cell) {
            const auto found = closed.classify_cell(cell);
            found ? ++cells[static_cast<std::size_t>(*found)] : ++quads;
        }
        CHECK(cells == histogram.cells);
        const NetComplex complex(closed);
        CHECK(quads + cells[0] + cells[1] >= complex.view().quad_count);
    }
}

TEST_CASE("gluing as the coordinates tell") {
    const Net sphere = Net::from_primitive(Primitive::sphere(1.0).with(9, 17));
    Net bare = sphere;
    bare.set_gluing(Sides::sheet);
    CHECK(NetComplex(bare).boundary_count() == 1);
    const gusset::NetValidation validation(bare);
    CHECK(validation.warnings().size() >= 32);
    bare.detect_gluing();
    CHECK(bare.classes() == sphere.classes());
    CHECK(NetComplex(bare).euler() == 2);
    bare.saturate();
    CHECK(bare.classes() == sphere.classes());
    // Several steps at once: what lies together, and a link besides, whose ends get one position.
    bare.set_gluing(Sides::sheet);
    const uint32_t link = 2 * (4 * 17 + 3);
    gusset::GlueOptions steps;
    steps.detect = true;
    steps.tolerance = 1e-9;
    steps.links = {link};
    steps.snap = true;
    CHECK(bare.glue(steps) == 1);
    CHECK(bare.at(4, 3) == bare.at(4, 4));
    CHECK(bare.classes()[4 * 17 + 4] == 4 * 17 + 3);
    CHECK(bare.classify_node(4 * 17 + 3) == GluingType::horizontal);

    // A seam says the same as sides.
    Gluing rows_closed(std::vector<gusset::Seam>{{0, 0, 1, 0, 0, 6, 1, 0, 5, 0}});
    Net seamed = sheet(5, 7, rows_closed), sided = sheet(5, 7, Sides::rows_closed);
    CHECK(seamed.classes() == sided.classes());
    seamed.saturate();
    CHECK(seamed.sides() == Sides::rows_closed);
    CHECK(seamed.seams().empty());
    Gluing matrix;
    matrix.matrix = sided.matrix();
    CHECK(sheet(5, 7, matrix).sides() == Sides::rows_closed);
    const gusset::NetValidation apart(sided);
    CHECK(!apart.is_valid());
    REQUIRE(apart.violations().size() == 5);
    CHECK(apart.violations()[0] == gusset::NetFindingKind::link_apart);
    CHECK(apart.violations()[0].distance == 6.0);
    CHECK(gusset::NetValidation(sided, 6.0).is_valid());
    CHECK(apart.findings().size() == apart.violations().size() + apart.warnings().size());
}

TEST_CASE("errors carry status and element") {
    const auto check = [](const Refusal &found, int32_t status, gusset_element element, uint64_t index) {
        CHECK(found.status == status);
        CHECK(found.element == element);
        CHECK(found.index == index);
        CHECK(found.has_sentence);
    };
    Net net = sheet(4, 4);
    const std::vector<LocalGluing> crossing{LocalGluing::diagonal(4, gusset::Diagonal::falling),
                                            LocalGluing::diagonal(4, gusset::Diagonal::rising)};
    check(refusal([&] { net.glue(crossing); }), GUSSET_ERROR_CROSSING_CELL, GUSSET_ELEMENT_CELL, 4);
    CHECK(net.sides() == Sides::sheet);
    check(refusal([&] { net.glue(LocalGluing::link(32)); }), GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_LINK, 32);
    check(refusal([&] { net.absorb(std::vector<uint32_t>{1, 77}); }), GUSSET_ERROR_NO_SUCH_ELEMENT, GUSSET_ELEMENT_LINK, 77);
    const Gluing leaves(std::vector<gusset::Seam>{{0, 0, 0, 1, 3, 0, 0, 1, 4, 0}, {0, 0, 0, 1, 3, 0, 0, 1, 5, 0}});
    check(refusal([&] { net.set_gluing(leaves); }), GUSSET_ERROR_BAD_SEAM, GUSSET_ELEMENT_SEAM, 1);
    check(refusal([&] { net.deform(gusset::Field::spherify({1.0, 2.0, 0.0}, 1.0)); }), GUSSET_ERROR_FIELD_UNDEFINED,
          GUSSET_ELEMENT_NODE, 9);
    CHECK(refusal([&] { sheet(1, 4); }).status == GUSSET_ERROR_NET_TOO_SMALL);
    CHECK(refusal([&] { net.classify_node(16); }).status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    CHECK(refusal([&] { net.bridge(0); }).status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    CHECK(refusal([&] { net.split(0); }).status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    CHECK(refusal([&] { Net::from_primitive(Primitive::sphere(-1.0)); }).status == GUSSET_ERROR_OUT_OF_RANGE);
    CHECK_THROWS_AS(net.at(4, 0), gusset::Error);
    CHECK_THROWS_AS(Net::from_points(2, 3, std::vector<Point3>(5)), gusset::Error);
    CHECK_THROWS_AS(net.coordinates<float>(), gusset::Error);
    Net gone = std::move(net);
    CHECK(refusal([&] { net.rows(); }).status == GUSSET_ERROR_NULL_ARGUMENT);
    CHECK(refusal([&] { NetComplex complex(net); }).status == GUSSET_ERROR_NULL_ARGUMENT);

    gusset::Context context;
    context.set_progress([](double, const char *) -> bool { throw std::runtime_error("enough"); });
    CHECK_THROWS_WITH(Net::from_primitive(Primitive::sphere(1.0).with(600, 600), context), "enough");
    context.set_progress(nullptr);
    context.cancel();
    CHECK(refusal([&] { NetComplex(gone, gusset::NetCells::all, context); }).status == GUSSET_ERROR_CANCELLED);
}

TEST_CASE("copies share and part") {
    const Net first = Net::from_primitive(Primitive::torus(2.0, 0.5));
    Net second = first;
    CHECK(first.coordinates<double>().x.data() == second.coordinates<double>().x.data());
    second.edit<double>().x(3, 4) += 1.0;
    CHECK(first.coordinates<double>().x.data() != second.coordinates<double>().x.data());
    CHECK(second.at(3, 4)[0] == first.at(3, 4)[0] + 1.0);
    CHECK(identical(first, Net::from_primitive(Primitive::torus(2.0, 0.5))));
    second.set_gluing(Sides::sheet);
    CHECK(first.sides() == Sides::torus);
    second = first;
    CHECK(identical(first, second));
    const Net *self = &second;
    second = *self;
    CHECK(identical(first, second));

    // Memory of the caller's is changed with the net; a copy is not.
    std::vector<double> x(12, 1.0), y(12, 2.0), z(12, 3.0);
    Net lent = Net::borrow(3, 4, x.data(), y.data(), z.data());
    const Net kept = lent;
    lent.transform(gusset::Operation::translate({1.0, 1.0, 1.0}));
    CHECK(x[0] == 2.0);
    CHECK(z[11] == 4.0);
    CHECK(kept.at(0, 0) == Point3{1.0, 2.0, 3.0});

    // Strides of all kinds.
    std::vector<float> wide(3 * 10, 0.0f);
    for (std::size_t k = 0; k < wide.size(); ++k) {
        wide[k] = static_cast<float>(k);
    }
    const Net strided = Net::from_matrices(3, 4, wide.data(), wide.data() + 1, wide.data() + 2, {}, 10);
    CHECK(strided.at(2, 3) == Point3{23.0, 24.0, 25.0});
    CHECK(!strided.is_double());
    std::vector<double> out(3 * 3 * 5, -1.0);
    const gusset::NetCoordinates<double> to{{out.data(), 3, 4, 5}, {out.data() + 15, 3, 4, 5}, {out.data() + 30, 3, 4, 5}};
    strided.read(to);
    CHECK(to.z(2, 3) == 25.0);
    CHECK(out[4] == -1.0);
    struct Vertex {
        std::array<float, 3> position;
        uint32_t colour;
        float operator[](std::size_t k) const { return position[k]; }
    };
    CHECK(strided.points<Vertex>()[7].position[1] == 14.0f);
    const std::vector<Vertex> vertices = strided.points<Vertex>();
    CHECK(identical(Net::from_points(3, 4, vertices), strided));

    // Const functions in many threads.
    std::vector<std::thread> threads;
    std::vector<double> volumes(4);
    for (double &volume : volumes) {
        threads.emplace_back([&] { volume = first.measure().volume; });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    CHECK(std::equal(volumes.begin() + 1, volumes.end(), volumes.begin()));
}

TEST_CASE("nets glued by chance") {
    std::mt19937 random(7);
    const auto pick = [&](std::size_t count) { return static_cast<uint32_t>(random() % count); };
    for (int round = 0; round < 1000; ++round) {
        CAPTURE(round);
        const std::size_t rows = 2 + pick(5), columns = 2 + pick(5);
        std::vector<Point3> points;
        for (std::size_t k = 0; k < rows * columns; ++k) {
            points.push_back({double(pick(1000)), double(pick(1000)), double(pick(1000))});
        }
        const std::array<Sides, 4> sides{Sides::sheet, Sides::tube, Sides::two_poles, Sides::torus};
        Net net = Net::from_points(rows, columns, points, sides[pick(4)]);
        for (uint32_t k = pick(6); k-- > 0;) {
            const uint32_t type = pick(18);
            const uint32_t element = pick(type < 13 ? rows * columns : (rows - 1) * (columns - 1));
            const Refusal refused = refusal([&] { net.glue(LocalGluing::of_type(static_cast<GluingType>(type), element)); });
            REQUIRE((refused.status == GUSSET_OK || refused.status == GUSSET_ERROR_CROSSING_CELL));
        }
        net.snap();
        REQUIRE(gusset::NetValidation(net).is_valid());

        // The mesh has the faces and wires of the complex.
        const NetComplex complex(net);
        const gusset::NetMesh mesh(net);
        uint64_t quads = 0;
        for (std::size_t f = 0; f < mesh.mesh().face_count(); ++f) {
            quads += mesh.mesh().face(f).size() == 4 ? 1 : 0;
        }
        REQUIRE(quads == complex.view().quad_count);
        REQUIRE(mesh.mesh().face_count() - quads == complex.view().triangle_count);
        REQUIRE(mesh.wires().size() == complex.wires().size());

        // Matrix and seams restore the gluing.
        Gluing again;
        again.matrix = net.matrix();
        again.seams = net.seams();
        Net copy = net;
        copy.set_gluing(Sides::sheet);
        copy.set_gluing(again);
        REQUIRE(identical(copy, net));
        REQUIRE(identical(net.turned(1).turned(-1), net));
        Net saturated = net;
        saturated.saturate();
        REQUIRE(saturated.classes() == net.classes());
        gusset::ConcatenateOptions options;
        options.direction = pick(2) == 0 ? gusset::Direction::right : gusset::Direction::down;
        options.equalise = static_cast<gusset::Replication>(pick(3));
        const Net torus = Net::from_primitive(Primitive::torus(2.0, 0.5).with(4 + pick(3), 4 + pick(3)));
        const auto [first, second] = gusset::concatenate(net, torus, options).split(0);
        REQUIRE(identical(first, net));
        REQUIRE(identical(second, torus));
    }
}

} // namespace gluing_tests
