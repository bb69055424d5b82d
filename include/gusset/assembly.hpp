// Assembly of many pieces. Included by gusset.hpp.
#ifndef GUSSET_ASSEMBLY_HPP
#define GUSSET_ASSEMBLY_HPP

#include <gusset/base.hpp>
#include <gusset/fill.hpp>
#include <gusset/repair.hpp>
#include <gusset/stitch.hpp>

namespace gusset {

/// How to assemble; see gusset_assembly_options.
struct AssemblyOptions {
    /// Nothing: no welding.
    std::optional<WeldOptions> weld = WeldOptions();
    /// True: nothing is turned over.
    bool keep_orientation = false;
    /// Nothing: by the size of the loops. 0 leaves all gaps open.
    std::optional<double> max_gap;
    bool whole_loops_only = false;
    bool within_components = false;
    std::vector<gusset_loop_pair> pairs;
    std::vector<gusset_loop_pair> excluded;
    /// Meridians, search, start, rows, cells, fairing and intersections are read.
    StitchOptions strips;
    /// Nothing: holes are left.
    std::optional<FillOptions> fill;
};

/// Many pieces in one mesh, and the account of it; see gusset_assembly_create.
class Assembly {
public:
    explicit Assembly(Span<const MeshView> pieces, const AssemblyOptions &options = {},
                      const Context &context = Context()) {
        std::vector<gusset_mesh_view> views;
        for (const MeshView &piece : pieces) {
            views.push_back(piece.get());
        }
        const gusset_weld_options weld = detail::as_c(options.weld.value_or(WeldOptions()));
        const gusset_stitch_options strips = detail::as_c(options.strips);
        const gusset_fill_options fill = detail::as_c(options.fill.value_or(FillOptions()));
        gusset_assembly_options given{};
        given.struct_size = sizeof given;
        given.weld = options.weld ? GUSSET_ASSEMBLY_WELD : GUSSET_ASSEMBLY_NO_WELD;
        given.orientation = options.keep_orientation ? GUSSET_ORIENTATION_KEEP : GUSSET_ORIENTATION_FIX;
        given.gap = options.max_gap ? GUSSET_GAP_GIVEN : GUSSET_GAP_AUTO;
        given.max_gap = options.max_gap.value_or(0.0);
        given.whole_loops_only = options.whole_loops_only ? 1 : 0;
        given.within_components = options.within_components ? 1 : 0;
        given.fill = options.fill ? 1 : 0;
        given.pairs = options.pairs.data();
        given.pair_count = options.pairs.size();
        given.excluded = options.excluded.data();
        given.excluded_count = options.excluded.size();
        given.weld_options = &weld;
        given.strip_options = &strips;
        given.fill_options = &fill;
        gusset_assembly *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_assembly_create(c, views.data(), views.size(), &given, &created);
        });
        assembly_.reset(created);
    }

    MeshView mesh() const {
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_assembly_get_mesh(assembly_.get(), &view));
        return MeshView(view);
    }
    /// The whole account; its lists live as long as this.
    gusset_assembly_view parts() const {
        gusset_assembly_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_assembly_get_view(assembly_.get(), &parts));
        return parts;
    }
    /// Where each piece went.
    Span<const gusset_piece_map> pieces() const { return {parts().pieces, parts().piece_count}; }
    /// The pairs of loops that face each other, and what became of them.
    Span<const gusset_joint> joints() const { return {parts().joints, parts().joint_count}; }
    /// The loops that no strip hangs on.
    Span<const gusset_left_loop> left() const { return {parts().left, parts().left_count}; }
    /// The holes that were looked at in the end.
    Span<const gusset_hole> holes() const { return {parts().holes, parts().hole_count}; }

private:
    struct Destroy {
        void operator()(gusset_assembly *assembly) const noexcept { gusset_assembly_destroy(assembly); }
    };
    std::unique_ptr<gusset_assembly, Destroy> assembly_;
};

} // namespace gusset

#endif // GUSSET_ASSEMBLY_HPP
