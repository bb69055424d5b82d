// Nets as streams, from C++.
#include <gusset.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

namespace net_stream_tests {

namespace {
using gusset::Net;
using gusset::Primitive;

bool same_bits(const Net &a, const Net &b) {
    const auto left = a.coordinates<float>(), right = b.coordinates<float>();
    const std::size_t size = sizeof(float) * a.columns();
    for (std::size_t i = 0; i < a.rows(); ++i) {
        if (std::memcmp(left.x.row(i).data(), right.x.row(i).data(), size) != 0 ||
            std::memcmp(left.y.row(i).data(), right.y.row(i).data(), size) != 0 ||
            std::memcmp(left.z.row(i).data(), right.z.row(i).data(), size) != 0) {
            return false;
        }
    }
    return a.matrix() == b.matrix();
}
} // namespace

TEST_CASE("streams come back") {
    const Net torus = Net::from_primitive(Primitive::torus(2, 0.5).with(65, 129).with(gusset::Scalar::f32));
    for (const auto mode : {gusset::StreamMode::lossless, gusset::StreamMode::raw}) {
        gusset::StreamOptions options;
        options.mode = mode;
        const gusset::Stream stream(torus, options);
        CHECK(same_bits(gusset::decode(stream.bytes()), torus));
        CHECK(gusset::inspect(stream.bytes()).columns == 129);
    }
    const gusset::Stream small(torus);
    const gusset::StreamReport info = gusset::inspect(small.bytes());
    CHECK(info.bits == 14);
    // Less than 14 bits for each of three coordinates, by far.
    CHECK(small.bytes().size() < 65 * 129 * 3);
    const Net back = gusset::decode(small.bytes());
    CHECK(back.sides() == gusset::Sides::torus);
    for (std::size_t i = 0; i < back.rows(); ++i) {
        for (std::size_t j = 0; j < back.columns(); ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(std::abs(back.at(i, j)[k] - torus.at(i, j)[k]) <= 0.5 * info.step[k] + 1e-6);
            }
        }
    }
}

TEST_CASE("scenes come back, and share the nets that they shared") {
    gusset::Scene scene;
    const Net wheel = Net::from_primitive(Primitive::torus(1, 0.2).with(gusset::Scalar::f32));
    const uint32_t axle = scene.add_group();
    for (const double side : {-1.0, 1.0}) {
        const uint32_t entry = scene.add(wheel);
        scene.set_transform(entry, gusset::Transform{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, side}});
        scene.add_child(axle, entry);
    }
    gusset::StreamOptions options;
    options.mode = gusset::StreamMode::lossless;
    const gusset::Stream stream(scene, options), alone(wheel, options);
    CHECK(stream.bytes().size() < alone.bytes().size() + 500);
    const gusset::Scene back = gusset::decode_scene(stream.bytes());
    CHECK(back.children(axle) == scene.children(axle));
    CHECK(back.entry(2).transform.rows[11] == 1.0);
    CHECK(same_bits(back.flatten(), scene.flatten()));
    CHECK_THROWS_AS(gusset::decode_scene(alone.bytes()), gusset::Error);
    CHECK_THROWS_AS(gusset::decode_scene(stream.bytes(), 10), gusset::Error);
}

TEST_CASE("streams that arrive in pieces, and damaged ones") {
    const Net ball = Net::from_primitive(Primitive::sphere(1).with(200, 101).with(gusset::Scalar::f32));
    gusset::StreamOptions options;
    options.rows_per_block = 50;
    const gusset::Stream stream(ball, options);
    const gusset::Bytes bytes = stream.bytes();
    gusset::StreamDecoder decoder;
    std::size_t rows = 0;
    for (std::size_t at = 0; at < bytes.size(); at += 100) {
        const std::size_t now = decoder.push({bytes.data() + at, std::min<std::size_t>(100, bytes.size() - at)});
        CHECK(now >= rows);
        if (now > rows && now < 200) {
            CHECK(decoder.preview().rows() == now);
        }
        rows = now;
    }
    CHECK(rows == 200);
    CHECK(same_bits(decoder.finish(), gusset::decode(bytes)));

    std::vector<uint8_t> damaged(bytes.begin(), bytes.end());
    damaged[damaged.size() / 2] ^= 1;
    try {
        gusset::decode(damaged);
        FAIL("taken");
    } catch (const gusset::Error &error) {
        CHECK(error.status() == GUSSET_ERROR_BAD_STREAM);
        CHECK(error.report().element == GUSSET_ELEMENT_BYTE);
    }
    gusset::StreamDecoder careful(1000);
    CHECK_THROWS_AS(careful.push(bytes), gusset::Error);
}

} // namespace net_stream_tests
