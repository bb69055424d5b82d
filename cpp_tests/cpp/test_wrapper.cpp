// gusset.hpp by itself: exceptions that carry the report, callbacks that throw, cancel from another
// thread, ownership.
#include "soup.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace wrapper_tests {

namespace {
Soup square() {
    Soup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    soup.add_face({0, 1, 2, 3});
    return soup;
}

/// A sheet large enough to be at work for a while.
Soup sheet(uint32_t n) {
    Soup soup;
    for (uint32_t j = 0; j <= n; ++j) {
        for (uint32_t i = 0; i <= n; ++i) {
            soup.points.push_back({double(i), double(j), 0.0});
        }
    }
    for (uint32_t j = 0; j < n; ++j) {
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t v = j * (n + 1) + i;
            soup.add_face({v, v + 1, v + n + 2, v + n + 1});
        }
    }
    return soup;
}
} // namespace

TEST_CASE("versions") {
    CHECK(std::string(gusset::version()) == GUSSET_VERSION_STRING);
    CHECK(gusset::abi() == 1);
}

TEST_CASE("an error carries the status, a sentence and the element") {
    Soup soup = square();
    soup.points[2][1] = NAN;
    try {
        const gusset::Boundary boundary(soup.view());
        FAIL("not refused");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_NOT_FINITE);
        CHECK(error.report().element == GUSSET_ELEMENT_VERTEX);
        CHECK(error.report().index == 2);
        CHECK(std::isnan(error.report().value));
        CHECK(std::string(error.what()).find("vertex 2") != std::string::npos);
    }
    CHECK_THROWS_AS(gusset::Boundary(square().view())[1], gusset::Error);
}

TEST_CASE("a callback that throws: its exception comes out, and the context goes on") {
    const Soup soup = square();
    gusset::Context context;
    context.set_progress([](double, const char *) -> bool { throw std::out_of_range("mine"); });
    CHECK_THROWS_AS(gusset::Boundary(soup.view(), {}, context), std::out_of_range);
    context.set_progress([](double, const char *) { return false; });
    try {
        const gusset::Boundary boundary(soup.view(), {}, context);
        FAIL("not cancelled");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_CANCELLED);
    }
    double last = -1.0;
    context.set_progress([&](double fraction, const char *stage) {
        CHECK(fraction >= last);
        CHECK(stage != nullptr);
        last = fraction;
        return true;
    });
    CHECK(gusset::Boundary(soup.view(), {}, context).size() == 1);
    CHECK(last == 1.0);
    context.set_progress(nullptr);
    CHECK(gusset::Boundary(soup.view(), {}, context).size() == 1);
}

TEST_CASE("a context that runs a call refuses all else, and loses nothing") {
    const Soup soup = square();
    gusset::Context context;
    int refused = 0;
    const std::string kept(100, 'x');
    context.set_progress([&context, &refused, &soup, kept](double, const char *) {
        const auto busy = [&](auto &&work) {
            try {
                work();
            } catch (const gusset::Error &error) {
                refused += error.status() == GUSSET_ERROR_CONTEXT_BUSY;
            }
        };
        busy([&] { context.set_progress(nullptr); });
        busy([&] { context.set_log(nullptr); });
        busy([&] { context.set_threads(2); });
        busy([&] { gusset::Boundary(soup.view(), {}, context); });
        return kept.size() == 100;
    });
    CHECK(gusset::Boundary(soup.view(), {}, context).size() == 1);
    CHECK(refused > 0);
    CHECK(refused % 4 == 0);

    // From two threads: each call is made, refused, or thrown out of by its own callback.
    context.set_progress([](double, const char *) -> bool { throw std::out_of_range("mine"); });
    std::atomic<int> others{0};
    const auto loop = [&] {
        for (int i = 0; i < 300; ++i) {
            try {
                gusset::Boundary(soup.view(), {}, context);
                ++others;
            } catch (const std::out_of_range &) {
            } catch (const gusset::Error &error) {
                others += error.status() != GUSSET_ERROR_CONTEXT_BUSY;
            }
        }
    };
    std::thread other(loop);
    loop();
    other.join();
    CHECK(others == 0);

    gusset::Context moved = std::move(context);
    CHECK_THROWS_AS(gusset::Boundary(soup.view(), {}, context), gusset::Error);
    CHECK_THROWS_AS(context.set_threads(1), gusset::Error);
}

TEST_CASE("a log callback that throws stops the call too") {
    Soup a = square(), b = square();
    for (auto &p : b.points) {
        p[2] = 1.0;
    }
    // Both face up: as sides of one box the second is inside out, and turning it over is noted.
    gusset::Context context;
    std::string noted;
    context.set_log([&](const char *message) { noted = message; });
    CHECK(gusset::stitch(a.view(), b.view(), {}, context).turned());
    CHECK(noted.find("turned") != std::string::npos);
    context.set_log([](const char *) { throw std::length_error("mine"); });
    CHECK_THROWS_AS(gusset::stitch(a.view(), b.view(), {}, context), std::length_error);
}

TEST_CASE("a context calls functions of the C interface by itself") {
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<uint32_t> corners{0, 1, 2};
    const gusset::MeshView triangle = gusset::MeshView::triangles(points, corners);
    const gusset::Context context;
    gusset_boundary *boundary = context.result(gusset_boundary_create, &triangle.get(), nullptr);
    auto loops = gusset::detail::sized<gusset_boundary_view>();
    CHECK(gusset_boundary_get_view(boundary, &loops) == GUSSET_OK);
    CHECK(loops.loop_count == 1);
    gusset_boundary_destroy(boundary);
    CHECK_THROWS_AS(context.result(gusset_boundary_create, nullptr, nullptr), gusset::Error);
}

TEST_CASE("cancel from another thread, while the call runs") {
    const Soup soup = sheet(600);
    gusset::Context context;
    std::atomic<bool> running{false};
    context.set_progress([&](double, const char *) {
        running = true;
        // Until the other thread has cancelled: the call cannot end before that.
        while (context.progress() >= 0.0 && running) {
            std::this_thread::yield();
        }
        return true;
    });
    std::thread other([&] {
        while (!running) {
            std::this_thread::yield();
        }
        context.cancel();
        running = false;
    });
    try {
        const gusset::Boundary boundary(soup.view(), {}, context);
        FAIL("not cancelled");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_CANCELLED);
    }
    other.join();
    context.set_progress(nullptr);
    CHECK_THROWS_AS(gusset::Boundary(soup.view(), {}, context), gusset::Error);
    context.reset();
    CHECK(gusset::Boundary(soup.view(), {}, context)[0].vertices.size() == 2400);
}

TEST_CASE("the same bytes for any number of threads") {
    const Soup soup = sheet(400);
    std::vector<uint32_t> reference;
    for (uint32_t threads : {1u, 2u, 3u, 7u, 0u}) {
        gusset::Context context;
        context.set_threads(threads);
        const gusset::Boundary boundary(soup.view(), {}, context);
        REQUIRE(boundary.size() == 1);
        std::vector<uint32_t> vertices(boundary[0].vertices.begin(), boundary[0].vertices.end());
        if (reference.empty()) {
            reference = vertices;
        }
        CHECK(vertices == reference);
    }
}

TEST_CASE("results move, and outlive what they were made from") {
    auto make = [] {
        gusset::Context context;
        const Soup soup = square();
        gusset::Boundary boundary(soup.view(), {}, context);
        return boundary;
    };
    gusset::Boundary boundary = make();
    gusset::Boundary moved = std::move(boundary);
    CHECK(boundary.size() == 0);
    CHECK(moved[0].vertices.size() == 4);
    gusset::Context context, other = std::move(context);
    CHECK(gusset::Boundary(square().view(), {}, other).size() == 1);
}

TEST_CASE("the steps by themselves") {
    using Points = std::vector<std::array<double, 3>>;
    const Points a{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, b{{4, 0, 0}, {5, 0, 0}, {5, 1, 0}, {4, 1, 0}};
    const gusset::Facing facing(a, b);
    CHECK(facing.arc(0)[0] == 1);
    CHECK(facing.arc(0)[1] == 2);
    CHECK(facing.arc(1)[0] == 3);
    CHECK(facing.view().centre[1][0] == 4.5);
    CHECK(facing.view().distances[0][0] == -0.5);
    CHECK_THROWS_AS(gusset::Facing(a, Points{}), gusset::Error);
    CHECK(gusset::meridians_index(5, 3) == std::vector<uint32_t>{0, 1, 1, 2, 2, 3});
    CHECK_THROWS_AS(gusset::meridians_index(3, 5), gusset::Error);
}

TEST_CASE("strips that belong to no mesh, and arcs that are given") {
    const std::vector<gusset::Point3> a = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, b = {{0, 1, 0}, {2, 1, 0}};
    const gusset::Strip strip(a, b);
    // From (0, 0) to (2, 1) one place at a time: three triangles.
    CHECK(strip.start() == std::array<uint32_t, 2>{0, 0});
    REQUIRE(strip.meridians().size() == 8);
    CHECK(strip.meridians()[6] == 2);
    CHECK(strip.meridians()[7] == 1);
    double area = 0;
    const gusset_mesh_view mesh = strip.mesh().get();
    CHECK(mesh.face_count == 3);
    const auto *corners = static_cast<const uint32_t *>(mesh.face_corners);
    for (std::size_t k = 0; k < 3 * mesh.face_count; k += 3) {
        const auto at = [&](std::size_t c) { const uint32_t v = corners[k + c]; return v < 3 ? a[v] : b[v - 3]; };
        const gusset::Point3 p = at(0), q = at(1), r = at(2);
        area += 0.5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    }
    CHECK(area == doctest::Approx(2.0));
    gusset::StripOptions quads;
    quads.row_count = 2;
    quads.cells = gusset::StripCells::quads;
    quads.meridians = gusset::Meridians::index;
    const gusset::Strip rows(a, a, quads);
    CHECK(rows.mesh().face_count() == 6);
    CHECK(rows.matrix().size() == 4 * 3);
    CHECK(rows.parents().size() == 2 * 6);
    CHECK(rows.weights()[5] == doctest::Approx(2.0 / 3.0));

    // The right side of one square and the left side of another, and no more of either.
    Soup left = square(), right = square();
    for (auto &point : right.points) {
        point[0] += 3;
    }
    gusset::StitchOptions options;
    options.extent = gusset::StitchExtent::arcs;
    const std::vector<uint32_t> loop = {0, 1, 2, 3};
    options.arc_a = {1, 2};
    options.arc_b = {3, 2};
    const gusset::Stitch stitch = gusset::stitch(left.view(), loop, right.view(), loop, options);
    CHECK(stitch.quality().area == doctest::Approx(2.0));
    CHECK(!stitch.is_closed_band());
}

TEST_CASE("closed results face outwards if that is wanted") {
    // Two pyramids without their bases, apex to apex away from each other, all faces looking inwards.
    Soup up, down;
    up.points = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    down.points = {{0, 0, -2}, {1, 0, -1}, {0, -1, -1}, {-1, 0, -1}, {0, 1, -1}};
    for (uint32_t k = 0; k < 4; ++k) {
        up.add_face({0, 1 + (k + 1) % 4, 1 + k});
        down.add_face({0, 1 + (k + 1) % 4, 1 + k});
    }
    // The first pyramid's first face: as it was given, or turned over.
    const auto second = [](const gusset::MeshView &mesh) { return mesh.face(0)[1]; };
    for (const bool outwards : {false, true}) {
        const uint32_t expected = outwards ? 1 : 2;
        gusset::FillOptions filling;
        filling.outward = outwards ? gusset::Outward::closed : gusset::Outward::keep;
        const gusset::Fill fill(up.view(), filling);
        CHECK(second(fill.mesh()) == expected);
        CHECK(fill.turned_outwards().size() == (outwards ? fill.mesh().face_count() : 0));
        gusset::StitchOptions stitching;
        stitching.outward = filling.outward;
        const gusset::Stitch stitch = gusset::stitch(up.view(), down.view(), stitching);
        CHECK(second(stitch.mesh()) == expected);
        CHECK(stitch.turned_outwards().size() == (outwards ? stitch.mesh().face_count() : 0));
        gusset::JoinOptions assembling;
        assembling.max_gap = 3.0;
        assembling.outward = outwards ? gusset::Outward::closed : gusset::Outward::keep;
        const std::vector<gusset::MeshView> pieces{up.view(), down.view()};
        const gusset::Join assembly(pieces, assembling);
        CHECK(second(assembly.mesh()) == expected);
        CHECK(assembly.report().turned.count == (outwards ? 8 : 0));
    }
    // By default filling and stitching keep orientations, and joining turns outwards.
    const gusset::Fill kept(up.view());
    CHECK(second(kept.mesh()) == 2);
    const gusset::Stitch joined = gusset::stitch(up.view(), down.view());
    CHECK(second(joined.mesh()) == 2);
    gusset::JoinOptions wide;
    wide.max_gap = 3.0;
    const std::vector<gusset::MeshView> both{up.view(), down.view()};
    const gusset::Join turned(both, wide);
    CHECK(second(turned.mesh()) == 1);
}

TEST_CASE("views of any point type") {
    struct Vertex {
        float x, y, z;
        uint32_t colour;
        const float &operator[](std::size_t i) const { return (&x)[i]; }
    };
    const std::vector<Vertex> points{{0, 0, 0, 1}, {1, 0, 0, 2}, {0, 1, 0, 3}};
    const std::vector<uint32_t> corners{0, 1, 2};
    const auto view = gusset::MeshView::triangles(points, corners);
    CHECK(view.get().position_stride == 16);
    CHECK(view.position(1)[0] == 1.0);
    CHECK(gusset::Boundary(view)[0].length == doctest::Approx(2.0 + std::sqrt(2.0)));
    CHECK(gusset::MeshView::uniform(points, corners, 3).face_count() == 1);
    const float raw[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(gusset::Boundary(gusset::MeshView::triangles(raw, corners))[0].vertices.size() == 3);
    CHECK(gusset::MeshView::triangles(gusset::Span<const Vertex>(points), corners).vertex_count() == 3);
    CHECK_THROWS_AS(gusset::MeshView::uniform(gusset::Span<const Vertex>(points), corners, 2), gusset::Error);
    const std::vector<uint32_t> wrong_offsets{0, 4};
    CHECK_THROWS_AS(gusset::MeshView::polygons(points, gusset::Offsets(wrong_offsets), gusset::Corners(corners)), gusset::Error);
}

} // namespace wrapper_tests
