// Nets, scenes and streams.
#include "row.hpp"
#include "shapes.hpp"

#include <cmath>
#include <limits>

namespace complexity {

namespace {
using gusset::Context;
using gusset::Net;

Net net_of(const Grid &grid) { return Net::from_points(grid.rows, grid.columns, grid.points); }

template <class Family, class Function>
std::function<Call(std::size_t)> on_net(Family family, Function function) {
    return [=](std::size_t n) {
        const auto net = std::make_shared<Net>(net_of(family(n)));
        return making([=](const Context &context) { return function(*net, context); });
    };
}

/// Groups in groups, n deep, two of each: 2^n instances of one net.
std::shared_ptr<gusset::Scene> deep(std::size_t n) {
    const auto scene = std::make_shared<gusset::Scene>();
    uint32_t below = scene->add(net_of(plane_grid(1)));
    for (std::size_t i = 0; i < n; ++i) {
        const uint32_t group = scene->add_group();
        scene->add_child(group, below);
        below = group;
    }
    return scene;
}
} // namespace

std::vector<Row> net_rows() {
    const auto flat = [](std::size_t n) { return plane_grid(n); };
    const auto rough = [](std::size_t n) { return random_grid(n, 1, 0.8); };
    const auto one = [](std::size_t n) { return point_grid(n); };
    const auto missing = [](std::size_t n) {
        Grid made = plane_grid(n);
        const double nothing = std::numeric_limits<double>::quiet_NaN();
        made.points.assign(made.points.size(), Point3{nothing, nothing, nothing});
        return made;
    };
    const auto encode = [](const Net &net, const Context &context) {
        return gusset::Stream(net, gusset::StreamOptions(), context);
    };
    const auto detect = [](Net &net, const Context &context) {
        net.detect_gluing(1.0, context);
        return 0;
    };
    const auto mesh = [](const Net &net, const Context &context) {
        return gusset::NetMesh(net, gusset::NetMeshOptions(), context);
    };
    const auto validate = [](const Net &net, const Context &context) { return gusset::NetValidation(net, 0.0, context); };
    const auto normals = [](const Net &net, const Context &context) { return net.normals<double>(context); };
    const auto resample = [](const Net &net, const Context &context) {
        return net.resampled(net.rows(), net.columns(), gusset::Interpolation::bicubic, context);
    };
    const auto decoded = [](auto family) {
        return [=](std::size_t n) {
            const auto stream = std::make_shared<gusset::Stream>(net_of(family(n)));
            return making([=](const Context &context) { return gusset::decode(stream->bytes(), context); });
        };
    };
    const auto emptied = [](auto take) {
        return [=](std::size_t n) -> Call {
            const auto scene = std::make_shared<gusset::Scene>();
            const uint32_t net = scene->add(net_of(plane_grid(1))), group = scene->add_group();
            const auto children = std::make_shared<std::vector<uint32_t>>();
            for (std::size_t i = 0; i < n; ++i) {
                children->push_back(scene->add_group());
                scene->add_child(children->back(), net);
                scene->add_child(group, children->back());
            }
            return [=](const Context &context) -> std::shared_ptr<void> {
                for (const uint32_t child : *children) {
                    take(*scene, group, child, context);
                }
                return nullptr;
            };
        };
    };
    return {
        {"net_encode_create", "rough", 256, 4000000, 1, 1, 0, on_net(rough, encode)},
        {"net_encode_create", "missing nodes", 1024, 4000000, 1, 1, 0, on_net(missing, encode)},
        {"net_decode_create", "rough", 1024, 4000000, 1, 1, 0, decoded(rough)},
        {"net_decode_create", "missing nodes", 4096, 4000000, 1, 1, 0, decoded(missing)},
        {"net_glue", "points in one", 1024, 4000000, 1, 1, 0, on_net(one, detect)},
        {"net_glue", "flat", 1024, 4000000, 1, 1, 0, on_net(flat, detect)},
        {"net_to_mesh", "points in one", 1024, 4000000, 1, 1, 0, on_net(one, mesh)},
        {"net_validation_create", "points in one", 1024, 4000000, 1, 1, 0, on_net(one, validate)},
        {"net_validation_create", "rough", 1024, 4000000, 1, 1, 0, on_net(rough, validate)},
        {"net_normals", "rough", 4096, 4000000, 1, 1, 0, on_net(rough, normals)},
        {"net_resample_create", "rough", 1024, 4000000, 1, 1, 0, on_net(rough, resample)},
        // Many calls, each of which is short.
        {"scene_remove_child", "all, first to last", 128, 20000, 2, 1, 0,
         emptied([](gusset::Scene &scene, uint32_t group, uint32_t child, const Context &context) { scene.remove_child(group, child, context); }),
         false, 1000},
        {"scene_remove", "all, first to last", 128, 20000, 2, 1, 0,
         emptied([](gusset::Scene &scene, uint32_t, uint32_t child, const Context &context) { scene.remove(child, context); }), false, 1000},
        {"scene_world_transforms", "deep", 128, 100000, 1, 1, 0,
         [](std::size_t n) {
             const auto scene = deep(n);
             return making([=](const Context &context) { return scene->instances(context); });
         }},
        {"scene_flatten_create", "deep", 128, 100000, 1, 1, 0,
         [](std::size_t n) {
             const auto scene = deep(n);
             return making([=](const Context &context) { return scene->flatten(std::nullopt, context); });
         }},
    };
}

} // namespace complexity
