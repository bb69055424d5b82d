// Hole filling. Included by gusset.hpp.
#ifndef GUSSET_FILL_HPP
#define GUSSET_FILL_HPP

#include <gusset/base.hpp>

namespace gusset {

/// What makes one triangulation of a rim better than another.
enum class Weight : uint32_t {
    area_and_bend = GUSSET_WEIGHT_AREA_AND_BEND,
    bend_then_area = GUSSET_WEIGHT_BEND_THEN_AREA,
    area = GUSSET_WEIGHT_AREA
};
/// Whether holes get new vertices.
enum class Refine : uint32_t { none = GUSSET_REFINE_NONE, rim_density = GUSSET_REFINE_RIM_DENSITY };

/// How to fill holes; see gusset_fill_options. 0 is no limit.
struct FillOptions {
    Weight weight = Weight::area_and_bend;
    Refine refine = Refine::none;
    Fairing fairing = Fairing::none;
    bool keep_longest = false;
    uint32_t max_new_vertices = 0;
    uint32_t max_edges = 0;
    double max_length = 0.0;
    double max_diameter = 0.0;
};

namespace detail {
inline gusset_fill_options as_c(const FillOptions &options) {
    gusset_fill_options given{};
    given.struct_size = sizeof given;
    given.weight = static_cast<uint32_t>(options.weight);
    given.refine = static_cast<uint32_t>(options.refine);
    given.fairing = static_cast<uint32_t>(options.fairing);
    given.keep_longest = options.keep_longest ? 1 : 0;
    given.max_new_vertices = options.max_new_vertices;
    given.max_edges = options.max_edges;
    given.max_length = options.max_length;
    given.max_diameter = options.max_diameter;
    return given;
}
} // namespace detail

/// A mesh with holes filled; see gusset_fill_create.
class Fill {
public:
    /// All holes.
    explicit Fill(const MeshView &mesh, const FillOptions &options = {}, const Context &context = Context()) {
        create(mesh, nullptr, 0, options, context);
    }
    /// The loops given: vertices in order, in either direction.
    Fill(const MeshView &mesh, Span<const Indices> loops, const FillOptions &options = {},
         const Context &context = Context()) {
        std::vector<gusset_indices> given;
        for (const Indices &loop : loops) {
            given.push_back({loop.data(), loop.size()});
        }
        const gusset_indices none{nullptr, 0};
        create(mesh, given.empty() ? &none : given.data(), given.size(), options, context);
    }

    /// Old vertices and faces first.
    MeshView mesh() const {
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_fill_get_mesh(fill_.get(), &view));
        return MeshView(view);
    }
    /// One account for each loop.
    Span<const gusset_hole> holes() const {
        const gusset_fill_view found = parts();
        return {found.holes, found.hole_count};
    }
    /// The vertices of a hole's rim.
    Indices rim(const gusset_hole &hole) const { return {parts().rims.data + hole.rim_first, hole.rim_count}; }
    gusset_quality_report quality() const {
        gusset_quality_report quality{};
        quality.struct_size = sizeof quality;
        detail::check(gusset_fill_get_quality(fill_.get(), &quality));
        return quality;
    }

private:
    struct Destroy {
        void operator()(gusset_fill *fill) const noexcept { gusset_fill_destroy(fill); }
    };
    void create(const MeshView &mesh, const gusset_indices *loops, std::size_t count, const FillOptions &options,
                const Context &context) {
        const gusset_fill_options given = detail::as_c(options);
        gusset_fill *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_fill_create(c, &mesh.get(), loops, count, &given, &created);
        });
        fill_.reset(created);
    }
    gusset_fill_view parts() const {
        gusset_fill_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_fill_get_view(fill_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_fill, Destroy> fill_;
};

} // namespace gusset

#endif // GUSSET_FILL_HPP
