// Welding and orienting. Included by gusset.hpp.
#ifndef GUSSET_REPAIR_HPP
#define GUSSET_REPAIR_HPP

#include <gusset/base.hpp>

namespace gusset {

/// Which vertices are welded: the ends of free edges, so that borders are sewn, or all.
enum class WeldVertices : uint32_t { boundary = GUSSET_WELD_BOUNDARY, all = GUSSET_WELD_ALL };

/// How to weld; see gusset_weld_options.
struct WeldOptions {
    WeldVertices vertices = WeldVertices::boundary;
    /// Nothing: equal positions.
    std::optional<double> tolerance;
    /// Corners of one face may become one.
    bool collapse = false;
    /// True: vertices that no face uses are left out.
    bool remove_unused = false;
};

namespace detail {
inline gusset_weld_options as_c(const WeldOptions &options) {
    gusset_weld_options given{};
    given.struct_size = sizeof given;
    given.vertices = static_cast<uint32_t>(options.vertices);
    given.tolerance_mode = options.tolerance ? GUSSET_TOLERANCE_GIVEN : GUSSET_TOLERANCE_AUTO;
    given.tolerance = options.tolerance.value_or(0.0);
    given.collapse = options.collapse ? GUSSET_COLLAPSE_ALLOW : GUSSET_COLLAPSE_NEVER;
    given.unused = options.remove_unused ? GUSSET_UNUSED_REMOVE : GUSSET_UNUSED_KEEP;
    return given;
}
} // namespace detail

/// A mesh whose vertices that lie together are one; see gusset_weld_create.
class Weld {
public:
    /// The index of what is not in the result.
    static constexpr uint32_t none = UINT32_MAX;

    explicit Weld(const MeshView &mesh, const WeldOptions &options = {}, const Context &context = Context()) {
        const gusset_weld_options given = detail::as_c(options);
        gusset_weld *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_weld_create(c, &mesh.get(), &given, &created); });
        weld_.reset(created);
    }

    MeshView mesh() const {
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_weld_get_mesh(weld_.get(), &view));
        return MeshView(view);
    }
    /// Old index to new one, or none.
    Indices vertex_map() const { return detail::indices(parts().vertex_map); }
    /// Of each old face its index in the result; UINT32_MAX if it was dropped.
    Indices face_map() const { return detail::indices(parts().face_map); }
    /// Half-edges of the old mesh: free edges that lie on another and were left.
    Indices left_edges() const { return detail::indices(parts().left_edges); }
    /// Vertices of the old mesh that lie together with another and are not one with it.
    Indices left_vertices() const { return detail::indices(parts().left_vertices); }
    /// How many vertices became one with a smaller one.
    uint32_t welded_vertices() const { return parts().welded_vertices; }
    /// How many edges were two free edges.
    uint32_t sewn_edges() const { return parts().sewn_edges; }
    /// How many faces were dropped.
    uint32_t dropped_faces() const { return parts().dropped_faces; }

private:
    struct Destroy {
        void operator()(gusset_weld *weld) const noexcept { gusset_weld_destroy(weld); }
    };
    gusset_weld_view parts() const {
        gusset_weld_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_weld_get_view(weld_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_weld, Destroy> weld_;
};

/// Which way closed components face: as most of their faces do, or outwards.
enum class Outward : uint32_t { keep = GUSSET_OUTWARD_KEEP, closed = GUSSET_OUTWARD_CLOSED };

/// A mesh whose faces agree with their neighbours; see gusset_orient_create.
class Orient {
public:
    explicit Orient(const MeshView &mesh, Outward outward = Outward::keep, const Context &context = Context()) {
        gusset_orient_options given{};
        given.struct_size = sizeof given;
        given.outward = static_cast<uint32_t>(outward);
        gusset_orient *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_orient_create(c, &mesh.get(), &given, &created); });
        orient_.reset(created);
    }

    MeshView mesh() const {
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_orient_get_mesh(orient_.get(), &view));
        return MeshView(view);
    }
    /// Per face, 1 if it was turned over.
    Span<const uint8_t> turned() const {
        const gusset_orient_view found = parts();
        return {found.turned, found.face_count};
    }
    /// How many faces were turned over.
    uint32_t turned_faces() const { return parts().turned_faces; }
    /// How many components.
    uint32_t component_count() const { return parts().component_count; }
    /// Closed components that face outwards now and otherwise would not.
    uint32_t inverted_components() const { return parts().inverted_components; }
    /// The smallest face of each component that has one side only, and a half-edge at which it shows.
    Indices one_sided_faces() const { return detail::indices(parts().one_sided_faces); }
    /// For each one-sided component a half-edge where two faces disagree.
    Indices one_sided_half_edges() const { return detail::indices(parts().one_sided_half_edges); }

private:
    struct Destroy {
        void operator()(gusset_orient *orient) const noexcept { gusset_orient_destroy(orient); }
    };
    gusset_orient_view parts() const {
        gusset_orient_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_orient_get_view(orient_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_orient, Destroy> orient_;
};

} // namespace gusset

#endif // GUSSET_REPAIR_HPP
