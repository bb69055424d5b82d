// Nets from C++: moved, deformed, enlarged, joined, taken apart, and in scenes.
#include "judge.hpp"
#include "nets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

namespace scene_tests {

namespace {
using gusset::Axis;
using gusset::BridgeMode;
using gusset::Direction;
using gusset::Field;
using gusset::ConcatenateOptions;
using gusset::NetMesh;
using gusset::Operation;
using gusset::Replication;
using gusset::Scene;
using gusset::Transform;

Net torus() { return Net::from_primitive(Primitive::torus(2.0, 0.5).with(9, 17)); }
Net plane() { return Net::from_primitive(Primitive::plane(2.0, 1.0).with(5, 9)); }

Point3 image(const Transform &map, const Point3 &p) {
    const double *m = map.rows;
    Point3 out{};
    for (std::size_t k = 0; k < 3; ++k) {
        out[k] = m[4 * k] * p[0] + m[4 * k + 1] * p[1] + m[4 * k + 2] * p[2] + m[4 * k + 3];
    }
    return out;
}
/// First b, then a.
Transform product(const Transform &a, const Transform &b) {
    Transform out{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            double sum = j == 3 ? a.rows[4 * i + 3] : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += a.rows[4 * i + k] * b.rows[4 * k + j];
            }
            out.rows[4 * i + j] = sum;
        }
    }
    return out;
}
template <class Map>
double deviation(const Net &after, const Net &before, Map &&map) {
    double worst = 0.0;
    for (std::size_t i = 0; i < before.rows(); ++i) {
        for (std::size_t j = 0; j < before.columns(); ++j) {
            worst = std::max(worst, length(after.at(i, j) - map(before.at(i, j))));
        }
    }
    return worst;
}
/// Calls move(node, x, y, z) for each node; glued nodes are not made equal.
template <class Move>
void each_node(Net &net, Move &&move) {
    const auto nodes = net.edit<double>();
    for (std::size_t i = 0; i < nodes.x.rows(); ++i) {
        for (std::size_t j = 0; j < nodes.x.columns(); ++j) {
            move(i * nodes.x.columns() + j, nodes.x(i, j), nodes.y(i, j), nodes.z(i, j));
        }
    }
}
template <class... Steps>
Net moved(Net net, const Steps &...steps) {
    const std::vector<Operation> operations{steps...};
    net.transform(operations);
    return net;
}
Net deformed(Net net, const Field &field, double time = 0.0) {
    net.deform(field, time);
    return net;
}
} // namespace

TEST_CASE("spatial operations") {
    const Net net = torus();
    const auto test = [&](const Operation &operation, auto &&map) {
        CHECK(deviation(moved(net, operation), net, map) < 1e-14);
    };
    test(Operation::translate({1, 2, 3}), [](Point3 p) { return Point3{p[0] + 1, p[1] + 2, p[2] + 3}; });
    test(Operation::rotate({0, 0, 2}, pi / 2, {1, 0, 5}), [](Point3 p) { return Point3{1 - p[1], p[0] - 1, p[2]}; });
    test(Operation::rotate_as_printed({0, 0, 2}, pi / 2, {1, 0, 5}), [](Point3 p) { return Point3{1 + p[1], 1 - p[0], p[2]}; });
    test(Operation::scale(3.0), [](Point3 p) { return Point3{3 * p[0], 3 * p[1], 3 * p[2]}; });
    test(Operation::compress(Axis::y, 0.5), [](Point3 p) { return Point3{0.5 * p[0], p[1], 0.5 * p[2]}; });
    test(Operation::stretch({1, 2, 3}), [](Point3 p) { return Point3{p[0], 2 * p[1], 3 * p[2]}; });
    const Transform map{{1, 2, 0, 3, 0, 1, 0, 1, 0.5, 0, 1, 0}};
    test(Operation::matrix(map), [&](Point3 p) { return image(map, p); });
    CHECK(identical(moved(net, Operation::matrix(gusset::identity())), net));
    CHECK(distance(moved(net, Operation::matrix(gusset::translation({1, 2, 3}))),
                   moved(net, Operation::translate({1, 2, 3}))) == 0.0);
    // The first one first.
    CHECK(deviation(moved(net, Operation::translate({1, 0, 0}), Operation::scale(2.0)), net,
                    [](Point3 p) { return Point3{2 * p[0] + 2, 2 * p[1], 2 * p[2]}; }) < 1e-14);

    // A mirror leaves the outside outside.
    const Net mirrored = moved(net, Operation::stretch({-1.0, 1.0, 2.0}));
    CHECK(mirrored.is_reversed() != net.is_reversed());
    CHECK(mirrored.measure().volume == doctest::Approx(2 * net.measure().volume).epsilon(1e-12));
    const NetMesh mirrored_mesh(mirrored);
    CHECK(judge(mirrored_mesh.mesh()).bounds_a_volume);
    CHECK(refusal([&] { moved(net, Operation::rotate({0, 0, 0}, 1.0)); }).status == GUSSET_ERROR_OUT_OF_RANGE);
}

TEST_CASE("fields of deformation") {
    const Net net = torus();
    const auto test = [&](const Field &field, auto &&map) {
        CHECK(deviation(deformed(net, field), net, map) < 1e-13);
        CHECK(identical(deformed(net, field.with_strength(0.0)), net));
    };
    const Transform map{{1, 2, 0, 3, 0, 1, 0, 1, 0.5, 0, 1, 0}};
    test(Field::affine(map), [&](Point3 p) { return image(map, p); });
    test(Field::twist(Axis::z, 0.7, 0.25), [](Point3 p) {
        const double a = 0.7 * (p[2] - 0.25);
        return Point3{std::cos(a) * p[0] - std::sin(a) * p[1], std::sin(a) * p[0] + std::cos(a) * p[1], p[2]};
    });
    test(Field::taper(Axis::x, 0.1, 1.0), [](Point3 p) {
        const double s = 1 + 0.1 * (p[0] - 1.0);
        return Point3{p[0], s * p[1], s * p[2]};
    });
    test(Field::shear(Axis::x, Axis::z, 0.3), [](Point3 p) { return Point3{p[0] + 0.3 * p[2], p[1], p[2]}; });
    test(Field::bend(Axis::x, 0.2), [](Point3 p) {
        if (p[0] <= 0) {
            return p;
        }
        const double r = 5.0 - p[1], a = 0.2 * p[0];
        return Point3{r * std::sin(a), 5.0 - r * std::cos(a), p[2]};
    });
    test(Field::spherify({0, 0, 0.1}, 2.0), [](Point3 p) {
        const double s = 2.0 / length({p[0], p[1], p[2] - 0.1});
        return Point3{s * p[0], s * p[1], 0.1 + s * (p[2] - 0.1)};
    });
    test(Field::parallel({0, 0, 1}, {0, 0, 2}, {1, 0, 1}), [](Point3 p) { return Point3{p[0] + 1 - p[2], p[1], 1.0}; });
    test(Field::perspective({0, 0, 10}, {0, 0, 0}, {0, 0, 1}), [](Point3 p) {
        const double s = 10.0 / (10.0 - p[2]);
        return Point3{s * p[0], s * p[1], 0.0};
    });
    test(Field::projection({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.1, 1}), [](Point3 p) {
        const double w = 1 - 0.1 * p[2];
        return Point3{p[0] / w, p[1] / w, p[2] / w};
    });
    test(Field::lattice({-9, -9, -9}, {9, 9, 9}, {3, 3, 3}, std::vector<Point3>(27, {0, 0.5, 0})),
         [](Point3 p) { return Point3{p[0], p[1] + 0.5, p[2]}; });
    CHECK_THROWS_AS(Field::lattice({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, std::vector<Point3>(26)), gusset::Error);
    CHECK(refusal([&] { deformed(net, Field::lattice({0, 0, 0}, {1, 1, 1}, {99, 3, 3}, {})); }).status != GUSSET_OK);
    // The axes after z are x and y: x becomes the arc, from the y axis on, and y the height above the cylinder.
    CHECK(deviation(deformed(plane(), Field::wrap_cylinder(Axis::z, 3.0)), plane(), [](Point3 p) {
              return Point3{(3 + p[1]) * std::sin(p[0] / 3), (3 + p[1]) * std::cos(p[0] / 3), p[2]};
          }) < 1e-13);
    const Net ring = deformed(plane(), Field::wrap_torus(Axis::z, 3.0, 1.0));
    for (std::size_t k = 0; k < ring.node_count(); ++k) {
        const Point3 p = ring.points()[k];
        REQUIRE(std::hypot(std::hypot(p[0], p[1]) - 3.0, p[2]) == doctest::Approx(1.0).epsilon(1e-12));
    }

    // Half the strength, at half the time.
    const Field twist = Field::twist(Axis::z, 1.0);
    const Field animated = twist.with_keys({{0.0, 0.0}, {2.0, 1.0}});
    CHECK(distance(deformed(net, animated, 1.0), deformed(net, twist.with_strength(0.5))) < 1e-14);
    CHECK(distance(deformed(net, animated.with_strength(0.5), 9.0), deformed(net, twist.with_strength(0.5))) < 1e-14);
    CHECK(identical(deformed(net, twist.with_keys({{0.0, 0.0}, {2.0, 1.0}}, gusset::Easing::hold), 1.0), net));
    CHECK(distance(deformed(net, twist.with_keys({{0.0, 0.0}, {2.0, 1.0}}, gusset::Easing::smooth), 1.0),
                   deformed(net, twist.with_strength(0.5))) < 1e-14);
    const std::vector<Field> both{Field::shear(Axis::x, Axis::z, 0.3), twist};
    Net one = net, listed = net;
    one.deform(both);
    listed.deform({both[0], both[1]});
    CHECK(identical(one, listed));
    listed.transform({Operation::scale(2.0), Operation::scale(0.5)});
    CHECK(identical(one, listed));
    CHECK(distance(one, deformed(deformed(net, both[0]), both[1])) < 1e-14);
}

TEST_CASE("what a deformation does") {
    const Net net = torus();
    const std::vector<Field> fields{Field::shear(Axis::x, Axis::z, 0.4), Field::affine({{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}})};
    const gusset::NetAnalysis analysis(net, fields);
    CHECK(analysis.is_soft());
    CHECK(analysis.determinants().size() == 8 * 16);
    for (double determinant : analysis.determinants()) {
        CHECK(determinant == doctest::Approx(8.0).epsilon(1e-12));
    }
    Net after = net;
    after.deform(fields);
    CHECK(after.measure().volume == doctest::Approx(8 * net.measure().volume).epsilon(1e-12));
    const gusset::NetAnalysis doubled(net, moved(net, Operation::scale(2.0)));
    CHECK(doubled.determinants().empty());
    CHECK(doubled.links()[0] == doctest::Approx(2.0));
    CHECK(doubled.cells()[0] == doctest::Approx(4.0));

    // Everything beyond x = 0.25 pressed onto it.
    Net hard = plane();
    each_node(hard, [](std::size_t, double &x, double &, double &) { x = std::min(x, 0.25); });
    const gusset::NetAnalysis pressed(plane(), hard);
    CHECK(!pressed.is_soft());
    REQUIRE(pressed.contracted().size() == 15);
    CHECK(pressed.torn().empty());
    CHECK(pressed.star(0) == gusset::GluingType::horizontal);
    CHECK_THROWS_AS(pressed.star(15), gusset::Error);
    hard.absorb(pressed.contracted());
    CHECK(gusset::NetValidation(hard).is_valid());
    CHECK(hard.snap() == 0);
    const gusset::NetComplex complex(hard);
    CHECK(complex.view().quad_count == 4 * 5);
    CHECK(hard.measure().area == doctest::Approx(1.25));

    Net torn = net;
    torn.edit<double>().z(0, 3) += 0.1;
    const gusset::NetAnalysis pulled(net, torn);
    CHECK(!pulled.torn().empty());
}

TEST_CASE("a function of the caller's") {
    Net net = torus();
    each_node(net, [](std::size_t, double &, double &, double &z) { z *= 2; });
    CHECK(net.snap() == 0);
    CHECK(net.measure().volume == doctest::Approx(2 * torus().measure().volume));
    // Different for each copy of a glued node: they are made equal.
    each_node(net, [](std::size_t node, double &x, double &, double &) { x += 1e-3 * static_cast<double>(node); });
    CHECK(!gusset::NetValidation(net).is_valid());
    CHECK(net.snap() > 0);
    CHECK(gusset::NetValidation(net).is_valid());
    CHECK_THROWS_AS(net.edit<float>(), gusset::Error);

    Net sphere = Net::from_primitive(Primitive::sphere(1.0).with(33, 65));
    sphere.displace(0.5);
    CHECK(distance(sphere, Net::from_primitive(Primitive::sphere(1.5).with(33, 65))) < 1e-9);
}

TEST_CASE("enlarged, turned, and made smaller") {
    std::vector<Net> nets{plane(), torus(), Net::from_primitive(Primitive::sphere(1.0).with(6, 9)),
                          Net::from_primitive(Primitive::moebius(2.0, 1.0).with(4, 11))};
    for (const auto &[name, shape, euler] : closed_shapes()) {
        nets.push_back(Net::from_primitive(shape));
    }
    for (const Net &net : nets) {
        CHECK(identical(net.transposed().transposed(), net));
        CHECK(identical(net.turned(1).turned(-1), net));
        CHECK(identical(net.turned(1).turned(3), net));
        for (Direction direction : {Direction::right, Direction::down}) {
            CHECK(identical(net.flipped(direction).flipped(direction), net));
        }
        CHECK(net.transposed().at(3, 1) == net.at(1, 3));
        CHECK(net.turned(1).at(0, 0) == net.at(0, net.columns() - 1));
        CHECK(net.transposed().measure().volume == doctest::Approx(net.measure().volume).epsilon(1e-12));
        CHECK(identical(net.part(0, net.rows(), 0, net.columns()), net));
        CHECK(net.part(1, 3, 2, 2).at(0, 1) == net.at(1, 3));
    }
    for (const Net &net : {plane(), torus()}) {
        for (Replication which : {Replication::uniform, Replication::first, Replication::last, Replication::at,
                                  Replication::at_poles}) {
            gusset::NetCopyOptions options;
            options.rows = net.rows() + 4;
            options.columns = net.columns() + 3;
            options.row_replication = options.column_replication = which;
            options.row_index = 2;
            const Net larger = net.copied(options);
            CHECK(larger.rows() == options.rows);
            CHECK(larger.columns() == options.columns);
            CHECK(gusset::NetComplex(larger).euler() == gusset::NetComplex(net).euler());
            CHECK(larger.measure().area == doctest::Approx(net.measure().area).epsilon(1e-12));
            CHECK(identical(larger.compacted(), net));
        }
    }
    const Net fine = plane().resampled(9, 17, gusset::Interpolation::bilinear);
    CHECK(distance(fine, Net::from_primitive(Primitive::plane(2.0, 1.0).with(9, 17))) < 1e-15);
    CHECK(plane().resampled(9, 17).measure().area == doctest::Approx(2.0));
    const gusset::DecimatedNet corners = plane().decimated(1e-9);
    CHECK(corners.rows == std::vector<uint32_t>{0, 4});
    CHECK(corners.columns == std::vector<uint32_t>{0, 8});
    CHECK(corners.deviation <= 1e-9);
    CHECK(corners.net.measure().area == doctest::Approx(2.0));
    const auto levels = Net::from_primitive(Primitive::torus(2.0, 0.5).with(17, 33)).pyramid();
    REQUIRE(levels.size() > 2);
    for (std::size_t k = 1; k < levels.size(); ++k) {
        // Closed rows and columns keep five nodes.
        const Net &fine_level = levels[k - 1], &level = levels[k];
        const std::size_t row_step = fine_level.rows() > 5 ? 2 : 1, column_step = fine_level.columns() > 5 ? 2 : 1;
        CHECK(level.rows() == (fine_level.rows() - 1) / row_step + 1);
        CHECK(level.columns() == (fine_level.columns() - 1) / column_step + 1);
        CHECK(level.at(1, 1) == fine_level.at(row_step, column_step));
    }

    const gusset::NetPlanarity flat = torus().planarity(1e-9);
    CHECK(flat.summary.worst < 1e-12);
    CHECK(flat.summary.above == 0);
    CHECK(flat.cells.size() == 8 * 16);
    const std::vector<double> saddle{0, 0, 0, 0, 1, 2, 0, 2, 4};
    const gusset::NetPlanarity bent = Net::from_heights(3, 3, saddle.data()).planarity(1e-9);
    CHECK(bent.summary.above == 4);
    CHECK(*std::max_element(bent.cells.begin(), bent.cells.end()) == bent.summary.worst);
    CHECK(bent.cells[bent.summary.worst_cell] == bent.summary.worst);
}

TEST_CASE("what was joined comes apart again, bit for bit") {
    const Net sphere = Net::from_primitive(Primitive::sphere(1.0).with(9, 17));
    const Net tube = Net::from_primitive(Primitive::tube(1.0, 2.0).with(5, 13));
    const Net box = Net::from_primitive(Primitive::box({1, 2, 3}, {3, 4, 5}));
    const Net klein = Net::from_primitive(Primitive::klein(2.0, 0.5).with(9, 11));
    const std::vector<Net> nets{plane(), torus(), sphere, tube, box, klein};
    for (Direction direction : {Direction::right, Direction::down}) {
        for (BridgeMode mode : {BridgeMode::keep, BridgeMode::hide}) {
            for (Replication equalise : {Replication::uniform, Replication::first, Replication::last, Replication::at_poles}) {
                for (const Net &first : nets) {
                    for (const Net &second : nets) {
                        ConcatenateOptions options;
                        options.direction = direction;
                        options.mode = mode;
                        options.equalise = equalise;
                        options.turn = true;
                        options.properties = {1.0, 2.0, 3.0, 4};
                        const Net joined = gusset::concatenate(first, second, options);
                        REQUIRE(joined.bridge_count() == 1);
                        REQUIRE(joined.bridge(0).properties.user == 4);
                        REQUIRE(joined.bridge(0).mode == mode);
                        REQUIRE(joined.bridge(0).direction == direction);
                        const auto [one, other] = joined.split(0);
                        REQUIRE(identical(one, first));
                        // Nets that are the other way round were flipped along the side.
                        const Direction along = direction == Direction::right ? Direction::down : Direction::right;
                        REQUIRE(identical(other, first.is_reversed() == second.is_reversed() ? second : second.flipped(along)));
                    }
                }
            }
        }
    }

    ConcatenateOptions down;
    down.direction = Direction::down;
    down.mode = BridgeMode::hide;
    const Net three = gusset::concatenate(std::vector<Net>{torus(), sphere, tube}, down);
    CHECK(three.bridge_count() == 2);
    const gusset::NetComplex complex(three, gusset::NetCells::present);
    CHECK(complex.view().component_count == 3);
    const NetMesh three_mesh(three);
    CHECK(judge(three_mesh.mesh(), false).components == 3);
    CHECK(three.measure().area == doctest::Approx(torus().measure().area + sphere.measure().area + tube.measure().area));
    const std::vector<const Net *> twice{&sphere, &sphere};
    CHECK(identical(gusset::concatenate(twice), gusset::concatenate({&sphere, &sphere})));
    CHECK(gusset::concatenate(twice).columns() == 2 * sphere.columns());

    // Two halves of a tube, welded: one tube, and a mesh like any other.
    const Net lower = Net::from_primitive(Primitive::tube(1.0, 2.0).with(5, 13));
    const Net upper = moved(lower, Operation::translate({0, 0, 2}));
    down.mode = BridgeMode::weld;
    down.tolerance = 1e-12;
    const bool lower_ends_high = lower.at(4, 0)[2] > lower.at(0, 0)[2];
    const Net &first = lower_ends_high ? lower : upper, &second = lower_ends_high ? upper : lower;
    Net whole = gusset::concatenate(first, second, down);
    CHECK(whole.bridge(0).kind == gusset::BridgeKind::tube);
    CHECK(gusset::NetComplex(whole).boundary_count() == 2);
    const NetMesh whole_mesh(whole);
    const Verdict verdict = judge(whole_mesh.mesh());
    CHECK(verdict.is_mesh);
    CHECK(verdict.components == 1);
    CHECK(verdict.euler == 0);
    CHECK(verdict.self_intersections == 0);
    whole.set_bridge(0, BridgeMode::hide, 0.0, gusset::BridgeProperties{5.0, 0.0, 0.0, 9});
    CHECK(whole.bridge(0).properties.tension == 5.0);
    const NetMesh split_mesh(whole);
    CHECK(judge(split_mesh.mesh(), false).components == 2);
    CHECK(identical(whole.split(0).first, first));
    whole.set_bridge(0, BridgeMode::keep);
    CHECK(whole.bridge(0).properties.user == 9);

    const Refusal apart = refusal([&] { gusset::concatenate(second, first, down); });
    CHECK(apart.status == GUSSET_ERROR_SIDES_DIFFER);
    CHECK(apart.element == GUSSET_ELEMENT_SIDE_PLACE);
    CHECK(refusal([&] { gusset::concatenate(std::vector<Net>{}); }).status == GUSSET_ERROR_EMPTY_SCENE);
    const Net single = Net::from_primitive(Primitive::sphere(1.0).with(gusset::Scalar::f32));
    CHECK(refusal([&] { gusset::concatenate(single, sphere); }).status == GUSSET_ERROR_MIXED_SCALARS);
}

TEST_CASE("scenes") {
    Scene scene;
    const Net net = torus();
    const uint32_t ring = scene.add(net), flat = scene.add(plane()), pair = scene.add_group(), all = scene.add_group();
    scene.add_child(pair, ring);
    scene.add_child(pair, flat);
    scene.add_child(all, pair);
    scene.add_child(all, pair);
    const Transform turn{{0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3}}, shift = gusset::translation({10, 0, 0});
    scene.set_transform(pair, turn);
    scene.set_transform(flat, shift);
    scene.set_transform(all, gusset::translation({0, 0, 100}));

    CHECK(scene.children(pair) == std::vector<uint32_t>{ring, flat});
    CHECK(scene.children(all) == std::vector<uint32_t>{pair, pair});
    const gusset::SceneEntry entry = scene.entry(pair);
    CHECK(entry.kind == gusset::SceneEntryKind::group);
    CHECK(entry.child_count == 2);
    CHECK(entry.visible);
    CHECK(entry.transform.rows[3] == 1.0);
    CHECK(scene.entry(ring).kind == gusset::SceneEntryKind::net);
    const gusset_scene_report counts = scene.report();
    CHECK(counts.instances == 7);
    CHECK(counts.net_instances == 4);
    CHECK(counts.nets == 2);
    CHECK(counts.groups == 2);
    CHECK(counts.levels == 3);

    const auto instances = scene.instances();
    REQUIRE(instances.size() == 7);
    for (const gusset::SceneInstance &instance : instances) {
        Transform world = scene.entry(instance.entry).transform;
        for (uint32_t up = instance.parent; up != UINT32_MAX; up = instances[up].parent) {
            world = product(scene.entry(instances[up].entry).transform, world);
        }
        CHECK(std::equal(world.rows, world.rows + 12, instance.world.rows));
        CHECK(instance.visible == 1);
    }

    const auto placed = [&] {
        std::vector<Net> nets;
        for (const gusset::SceneInstance &instance : scene.instances()) {
            if (instance.visible && scene.entry(instance.entry).kind == gusset::SceneEntryKind::net) {
                nets.push_back(moved(scene.net(instance.entry), Operation::matrix(instance.world)));
            }
        }
        return nets;
    };
    for (const bool hidden : {false, true}) {
        scene.set_visible(flat, !hidden);
        const std::vector<Net> wanted = placed();
        CHECK(wanted.size() == (hidden ? 2 : 4));
        const Net whole = scene.flatten();
        CHECK(whole.bridge_count() == wanted.size() - 1);
        const gusset::NetComplex complex(whole, gusset::NetCells::present);
        CHECK(complex.view().component_count == wanted.size());
        const Scene back = Scene::unflatten(whole);
        const auto children = back.children(0);
        REQUIRE(children.size() == wanted.size());
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            CHECK(distance(back.net(children[k]), wanted[k]) < 1e-12);
            CHECK(back.net(children[k]).classes() == wanted[k].classes());
        }
        CHECK(identical(back.flatten(), whole));
    }
    scene.set_visible(flat, true);
    ConcatenateOptions right;
    right.mode = BridgeMode::keep;
    const Net wide = scene.flatten(right);
    CHECK(Scene::unflatten(wide, Direction::right).children(0).size() == 4);

    // The scene has the net as it was.
    Net changed = scene.net(ring);
    changed.transform(Operation::scale(2.0));
    CHECK(identical(scene.net(ring), net));

    const Refusal cycle = refusal([&] { scene.add_child(pair, all); });
    CHECK(cycle.status == GUSSET_ERROR_SCENE_CYCLE);
    CHECK(cycle.element == GUSSET_ELEMENT_ENTRY);
    const Refusal none = refusal([&] { scene.add_child(99, ring); });
    CHECK(none.status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    CHECK(none.element == GUSSET_ELEMENT_ENTRY);
    CHECK(none.index == 99);
    CHECK(refusal([&] { scene.net(pair); }).status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    CHECK(refusal([&] { scene.children(ring); }).status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    scene.remove_child(all, pair);
    CHECK(scene.report().instances == 4);
    scene.remove(pair);
    CHECK(refusal([&] { scene.entry(pair); }).status == GUSSET_ERROR_NO_SUCH_ELEMENT);
    CHECK(scene.report().instances == 3);
    CHECK(refusal([&] { Scene().flatten(); }).status == GUSSET_ERROR_EMPTY_SCENE);

    // Mirrored nets are reversed: the whole still faces outwards.
    Scene mirror;
    const uint32_t twice = mirror.add_group(), other = mirror.add_group(), part = mirror.add(net);
    mirror.add_child(twice, part);
    mirror.add_child(other, part);
    mirror.set_transform(other, {{-1, 0, 0, 9, 0, 1, 0, 0, 0, 0, 1, 0}});
    const Net whole = mirror.flatten();
    CHECK(whole.measure().volume == doctest::Approx(2 * net.measure().volume).epsilon(1e-12));
    const NetMesh whole_mesh(whole);
    CHECK(judge(whole_mesh.mesh()).bounds_a_volume);
}

} // namespace scene_tests
