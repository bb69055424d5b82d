// Meshes: boundaries, welding, joining, filling.
#include "row.hpp"
#include "shapes.hpp"

namespace complexity {

namespace {
/// A call on a mesh that is made beforehand.
template <class Shape, class Function>
std::function<Call(std::size_t)> on_mesh(Shape shape, Function function) {
    return [=](std::size_t n) {
        const auto mesh = std::make_shared<const Mesh>(shape(n));
        return making([=](const gusset::Context &context) { return function(mesh->view(), context); });
    };
}

/// Two shells, joined along their first loops.
template <class Rim>
std::function<Call(std::size_t)> joined(Rim rim, gusset::StitchOptions options = {}) {
    return [=](std::size_t n) {
        const auto a = std::make_shared<const Mesh>(shell(rim(n, 0.0), {0, 0, -0.5}));
        const auto b = std::make_shared<const Mesh>(shell(rim(n, 1.0), {0, 0, 0.5}));
        const auto loop = std::make_shared<std::vector<uint32_t>>();
        for (uint32_t i = 0; i < n; ++i) {
            loop->push_back(i);
        }
        return making([=](const gusset::Context &context) {
            return gusset::stitch(a->view(), *loop, b->view(), *loop, options, context);
        });
    };
}

/// One face, split into triangles.
template <class Rim>
std::function<Call(std::size_t)> triangulated(Rim rim) {
    return [=](std::size_t n) {
        const auto points = std::make_shared<const std::vector<Point3>>(rim(n, 0.0));
        const auto corners = std::make_shared<std::vector<uint32_t>>();
        for (uint32_t i = 0; i < points->size(); ++i) {
            corners->push_back(i);
        }
        return making([=](const gusset::Context &context) {
            return gusset::Triangulation(gusset::MeshView::uniform(*points, *corners, uint32_t(corners->size())), context);
        });
    };
}

/// A shell, whose first loop is filled.
template <class Rim>
std::function<Call(std::size_t)> filled(Rim rim) {
    return [=](std::size_t n) {
        const auto mesh = std::make_shared<const Mesh>(shell(rim(n, 0.0), {0, 0, -0.5}));
        const auto loop = std::make_shared<std::vector<uint32_t>>();
        for (uint32_t i = 0; i < n; ++i) {
            loop->push_back(i);
        }
        return making([=](const gusset::Context &context) {
            const gusset::Indices loops[] = {*loop};
            return gusset::Fill(mesh->view(), loops, gusset::FillOptions(), context);
        });
    };
}
/// The origins of a result that is made beforehand, of a mesh.
template <class Shape, class Make>
std::function<Call(std::size_t)> origins_of(Shape shape, Make make) {
    return [=](std::size_t n) {
        const auto mesh = std::make_shared<const Mesh>(shape(n));
        const auto made = std::make_shared<const decltype(make(mesh->view(), gusset::Context()))>(make(mesh->view(), gusset::Context()));
        return making([=](const gusset::Context &context) { return made->origins(context); });
    };
}

/// The same of two shells of n vertices a rim, joined by rows, and texture coordinates carried over by them.
template <class Use>
std::function<Call(std::size_t)> with_strip(Use use) {
    return [=](std::size_t n) {
        const auto mesh = std::make_shared<const Mesh>(shell(circle(n, 1.0, 0.0), {0, 0, -0.5}));
        const auto other = std::make_shared<const Mesh>(shell(circle(n, 1.0, 1.0), {0, 0, 0.5}));
        const auto loop = std::make_shared<std::vector<uint32_t>>();
        for (uint32_t i = 0; i < n; ++i) {
            loop->push_back(i);
        }
        gusset::StitchOptions options;
        options.row_count = 2;
        const auto made = std::make_shared<const gusset::Stitch>(gusset::stitch(mesh->view(), *loop, other->view(), *loop, options));
        const auto origins = std::make_shared<const gusset::Origins>(made->origins());
        return making([=](const gusset::Context &context) { return use(*made, *origins, context); });
    };
}
} // namespace

std::vector<Row> mesh_rows() {
    using gusset::Context;
    using gusset::MeshView;
    const auto boundary = [](const MeshView &mesh, const Context &context) {
        return gusset::Boundary(mesh, gusset::BoundaryOptions(), context);
    };
    const auto check = [](const MeshView &mesh, const Context &context) { return gusset::Check(mesh, context); };
    const auto weld = [](const MeshView &mesh, const Context &context) {
        gusset::WeldOptions options;
        options.vertices = gusset::WeldVertices::all;
        return gusset::Weld(mesh, options, context);
    };
    const auto sew = [](const MeshView &mesh, const Context &context) {
        return gusset::Sew(mesh, gusset::WeldOptions(), context);
    };
    const auto orient = [](const MeshView &mesh, const Context &context) {
        gusset::OrientOptions options;
        options.outward = gusset::Outward::closed;
        return gusset::Orient(mesh, options, context);
    };
    const auto assemble = [](const MeshView &mesh, const Context &context) {
        const MeshView pieces[] = {mesh};
        return gusset::Join(pieces, gusset::JoinOptions(), context);
    };
    // Each with itself.
    const auto align = [](const MeshView &mesh, const Context &context) {
        const MeshView pieces[] = {mesh, mesh};
        return gusset::Alignment(pieces, gusset::AlignmentOptions(), context);
    };
    const auto align_rims = [](const MeshView &mesh, const Context &context) {
        const MeshView pieces[] = {mesh, mesh};
        gusset::AlignmentOptions options;
        options.start = gusset::AlignmentStart::rims;
        return gusset::Alignment(pieces, options, context);
    };
    const auto trim = [](const MeshView &mesh, const Context &context) {
        const MeshView pieces[] = {mesh, mesh};
        return gusset::Trim(pieces, gusset::TrimOptions(), context);
    };
    const auto develop = [](const MeshView &mesh, const Context &context) {
        gusset::DevelopOptions options;
        options.max_iterations = 2;
        return gusset::Development(mesh, options, context);
    };
    const auto fill = [](const MeshView &mesh, const Context &context) {
        gusset::FillOptions options;
        options.keep = gusset::FillKeep::none;
        return gusset::Fill(mesh, options, context);
    };
    const auto fill_together = [](const MeshView &mesh, const Context &context) {
        gusset::FillOptions options;
        options.keep = gusset::FillKeep::none;
        options.together = gusset::FillTogether::one;
        options.refine = gusset::FillRefinement::rim_density;
        options.fairing = gusset::Fairing::thin_plate;
        options.continuity = gusset::FillContinuity::c2;
        return gusset::Fill(mesh, options, context);
    };
    // A plane along the z axis, which meets all plates, in a basis that is not along their sides.
    const auto section = [](const MeshView &mesh, const Context &context) {
        gusset::MeshSectionOptions options;
        options.tolerance = 1e-3;
        return gusset::MeshSections(mesh, gusset::CuttingPlanes::plane({0, 0.1, 0}, {0.3, 1, 0}), options, context);
    };
    const auto winged = [](const MeshView &mesh, const Context &context) {
        return gusset::Winged(mesh, gusset::WingedOptions(), context);
    };
    const auto open_fan = [](std::size_t n) { return fan(n, false); };
    const auto closed_fan = [](std::size_t n) { return fan(n, true); };
    const auto loose = [](std::size_t n) { return scattered(n, false); };
    const auto in_one_point = [](std::size_t n) { return scattered(n, true); };
    const auto flat = [](std::size_t n) { return square(n, 0); };
    const auto rough = [](std::size_t n) { return square(n, 0.8); };
    const auto round_rim = [](std::size_t n, double height) { return circle(n, 1.0, height); };
    const auto line_rim = [](std::size_t n, double) { return collinear(n); };
    const auto star_rim = [](std::size_t n, double height) { return nested_star(n, height); };
    const auto open_rings = [](std::size_t n) { return rings(n, false); };
    const auto torus = [](std::size_t n) { return rings(n, true); };
    const auto tube = [](std::size_t n) { return shell(circle(n, 1.0, 0.0), {0, 0, -0.5}); };
    const auto point_rim = [](std::size_t n, double height) { return point(n, {0, 0, height}); };
    const auto spiral_rim = [](std::size_t n, double height) { return spiral(n, height); };
    const auto again = [](const gusset::Stitch &made, const gusset::Origins &, const Context &context) {
        return made.origins(context);
    };
    const auto textured = [](const gusset::Stitch &, const gusset::Origins &origins, const Context &context) {
        const gusset::Indices starts = origins.starts(gusset::Domain::corners);
        std::vector<std::array<double, 2>> values[2];
        for (std::size_t input = 0; input < 2; ++input) {
            for (uint32_t k = starts[input]; k < starts[input + 1]; ++k) {
                values[input].push_back({0.25 * (k % 7), 0.125 * (k % 5)});
            }
        }
        return origins.apply<std::array<double, 2>>(gusset::Domain::corners, gusset::Rule::texture, {values[0], values[1]}, context);
    };
    const auto merge = [](const MeshView &mesh, const Context &context) { return gusset::find_merge(mesh, {}, context); };
    return {
        {"boundary_create", "fan", 250, 4000000, 1, 1, 0, on_mesh(closed_fan, boundary)},
        {"boundary_create", "loops", 250, 4000000, 1, 1, 0, on_mesh(loose, boundary)},
        {"boundary_create", "triangles at a vertex", 250, 4000000, 1, 1, 0, on_mesh(bundle, boundary)},
        {"boundary_create", "equal copies", 250, 4000000, 1, 1, 0, on_mesh(copies, boundary)},
        {"boundary_create", "square", 250, 4000000, 1, 1, 0, on_mesh(flat, boundary)},
        {"mesh_sections_create", "plates", 250, 300000, 1, 1, 0, on_mesh(plates, section)},
        {"mesh_sections_create", "rough square", 250, 4000000, 1, 1, 0, on_mesh(rough, section)},
        {"check_create", "fan", 250, 4000000, 1, 1, 0, on_mesh(open_fan, check)},
        {"check_create", "triangles at a vertex", 250, 4000000, 1, 1, 0, on_mesh(bundle, check)},
        {"winged_create", "fan", 250, 4000000, 1, 1, 0, on_mesh(closed_fan, winged)},
        {"winged_create", "square", 250, 4000000, 1, 1, 0, on_mesh(flat, winged)},
        {"weld", "points in one", 250, 4000000, 1, 1, 0, on_mesh(in_one_point, weld)},
        {"weld", "equal copies", 250, 4000000, 1, 1, 0, on_mesh(copies, weld)},
        {"weld", "square", 250, 4000000, 1, 1, 0, on_mesh(flat, weld)},
        {"weld", "tube", 4000, 4000000, 1, 1, 0, on_mesh(open_rings, weld)},
        {"sew", "loops", 50, 1000000, 1, 1, 0, on_mesh(loose, sew)},
        {"sew", "points in one", 100, 1000000, 1, 1, 0, on_mesh(in_one_point, sew)},
        {"sew", "equal copies", 50, 1000000, 1, 1, 0, on_mesh(copies, sew)},
        {"sew", "triangles at a vertex", 50, 1000000, 1, 1, 0, on_mesh(bundle, sew)},
        {"orient", "fan", 250, 4000000, 1, 1, 0, on_mesh(closed_fan, orient)},
        {"orient", "triangles at a vertex", 250, 4000000, 1, 1, 0, on_mesh(bundle, orient)},
        {"triangulate", "circle", 1000, 1000000, 1, 1, 0, triangulated(round_rim)},
        {"triangulate", "line", 1000, 1000000, 1, 1, 0, triangulated(line_rim)},
        {"triangulate", "star", 1000, 1000000, 1, 1, 0, triangulated(star_rim)},
        {"triangulate", "spiral", 1000, 1000000, 1, 1, 0, triangulated(spiral_rim)},
        {"triangulate", "point", 1000, 1000000, 1, 1, 0, triangulated(point_rim)},
        {"join", "loops", 64, 100000, 1, 1, 0, on_mesh(loose, assemble)},
        {"join", "triangles at a vertex", 32, 100000, 2, 1, 0, on_mesh(bundle, assemble)},
        {"join", "points in one", 64, 100000, 1, 1, 0, on_mesh(in_one_point, assemble)},
        {"join", "equal copies", 64, 100000, 1, 1, 0, on_mesh(copies, assemble)},
        {"alignment_create", "rough squares", 250, 1000000, 1, 1, 0, on_mesh(rough, align)},
        {"alignment_create", "fans", 250, 1000000, 1, 1, 0, on_mesh(open_fan, align), true},
        {"alignment_create", "points in one", 250, 1000000, 1, 1, 0, on_mesh(in_one_point, align)},
        {"alignment_create", "equal copies", 250, 1000000, 1, 1, 0, on_mesh(copies, align)},
        {"alignment_create", "rims", 4000, 1000000, 1, 1, 0, on_mesh(rough, align_rims), true},
        {"trim_create", "rough squares", 250, 1000000, 1, 1, 0, on_mesh(rough, trim)},
        {"trim_create", "fans", 250, 1000000, 1, 1, 0, on_mesh(open_fan, trim), true},
        {"trim_create", "points in one", 64, 1000000, 2, 1, 0, on_mesh(in_one_point, trim), true},
        {"trim_create", "equal copies", 64, 1000000, 2, 1, 0, on_mesh(copies, trim), true},
        {"develop", "square", 2000, 1000000, 2, 1, 0, on_mesh(flat, develop)},
        {"develop", "rough square", 64, 100000, 2, 1, 0, on_mesh(rough, develop), true},
        {"develop", "loops", 64, 1000000, 1, 1, 0, on_mesh(loose, develop)},
        {"develop", "fan", 64, 100000, 2, 1, 0, on_mesh(open_fan, develop), true},
        {"develop", "triangles at a vertex", 64, 100000, 1, 1, 0, on_mesh(bundle, develop)},
        {"develop", "points in one", 64, 100000, 1, 1, 0, on_mesh(in_one_point, develop), true},
        {"develop", "tube", 16000, 1000000, 2, 1, 0, on_mesh(open_rings, develop), true},
        {"develop", "torus", 2000, 1000000, 2, 1, 0, on_mesh(torus, develop)},
        {"develop", "equal copies", 64, 1000000, 1, 1, 0, on_mesh(copies, develop)},
        {"fill", "loops", 32, 100000, 1, 1, 0, on_mesh(loose, fill)},
        {"fill", "triangles at a vertex", 32, 100000, 2, 1, 0, on_mesh(bundle, fill)},
        {"fill", "points in one", 12, 100000, 2, 1, 0, on_mesh(in_one_point, fill)},
        {"fill", "rough square", 64, 100000, 1, 1, 0, on_mesh(rough, fill)},
        {"fill", "fan", 128, 100000, 1, 1, 0, on_mesh(open_fan, fill), true},
        {"fill", "round rim", 96, 100000, 1, 1, 0, filled(round_rim)},
        {"fill", "collinear rim", 128, 100000, 1, 1, 0, filled(line_rim), true},
        {"fill", "spiral", 128, 100000, 1, 1, 0, filled(spiral_rim), true},
        {"fill", "nested star", 64, 100000, 2, 1, 0, filled(star_rim), true},
        {"fill", "points in one", 32, 100000, 2, 1, 0, filled(point_rim), true},
        {"fill", "two rims in one patch", 16, 10000, 1, 1, 0, on_mesh(tube, fill_together), true},
        {"stitch", "round rims", 64, 100000, 1, 1, 0, joined(round_rim)},
        {"stitch", "collinear rims", 32, 100000, 1, 1, 0, joined(line_rim), true},
        {"stitch", "spirals", 128, 100000, 1, 1, 0, joined(spiral_rim), true},
        {"stitch", "nested stars", 64, 100000, 2, 1, 0, joined(star_rim), true},
        {"stitch", "rims in one point", 128, 100000, 1, 1, 0, joined(point_rim), true},
        {"result_origins_create", "points in one", 250, 1000000, 1, 1, 0, origins_of(in_one_point, weld)},
        {"result_origins_create", "triangles at a vertex", 250, 1000000, 1, 1, 0, origins_of(bundle, orient)},
        {"result_origins_create", "loops", 32, 100000, 1, 1, 0, origins_of(loose, fill)},
        {"result_origins_create", "fan", 128, 10000, 1, 1, 0, origins_of(open_fan, fill), true},
        {"result_origins_create", "round rims", 64, 100000, 1, 1, 0, with_strip(again)},
        {"attributes_apply", "rims on many charts", 64, 100000, 1, 1, 0, with_strip(textured)},
        {"mesh_find_merge", "points in one", 250, 4000000, 1, 1, 0, on_mesh(in_one_point, merge)},
        {"mesh_find_merge", "square", 250, 4000000, 1, 1, 0, on_mesh(flat, merge)},
    };
}

} // namespace complexity
