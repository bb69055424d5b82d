/// @file
/// Hole filling. Include gusset.hpp, not this.
#ifndef GUSSET_FILL_HPP
#define GUSSET_FILL_HPP

#include <gusset/result.hpp>

namespace gusset {

/// A mesh with holes filled; see gusset_fill. Its old vertices and faces come first.
class Fill : public Result {
public:
    /// All holes. Groups need loops: with them it throws.
    explicit Fill(const MeshView &mesh, const FillOptions &options = {}, const Context &context = Context()) {
        create(mesh, nullptr, 0, options, context);
    }
    /// The given loops: vertices in order, in either direction. Throws an Error if there are
    /// groups, but not one for each loop.
    Fill(const MeshView &mesh, Span<const Indices> loops, const FillOptions &options = {},
         const Context &context = Context()) {
        if (!options.groups.empty() && options.groups.size() != loops.size()) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "there is not one group for each loop");
        }
        std::vector<gusset_indices> given;
        for (const Indices &loop : loops) {
            given.push_back({loop.data(), loop.size()});
        }
        const gusset_indices none{nullptr, 0};
        create(mesh, given.empty() ? &none : given.data(), given.size(), options, context);
    }

    /// A report on each loop.
    Span<const gusset_hole> holes() const & {
        const gusset_fill_report found = report();
        return {found.holes, found.hole_count};
    }
    Span<const gusset_hole> holes() const && = delete;
    /// The vertices of a hole's rim.
    Indices rim(const gusset_hole &hole) const & { return {report().rims.data + hole.rim_first, hole.rim_count}; }
    Indices rim(const gusset_hole &hole) const && = delete;
    /// Three vertices of its patch's rims for each new vertex.
    Indices parents() const & { return detail::indices(report().parents); }
    Indices parents() const && = delete;
    /// How much each new vertex has of its parents, three numbers a vertex.
    Span<const double> weights() const & { return {report().weights, report().parents.count}; }
    Span<const double> weights() const && = delete;
    /// Pairs of faces that cut each other; empty if they were not looked for.
    std::optional<Indices> intersections() const & {
        return detail::intersections(report());
    }
    std::optional<Indices> intersections() const && = delete;
    /// The faces that Outward::closed turned over.
    Indices turned_outwards() const & { return detail::indices(report().turned_outwards); }
    Indices turned_outwards() const && = delete;
    /// See ::gusset_result_get_quality.
    gusset_quality_report quality() const { return detail::lent(gusset_result_get_quality, get()); }

private:
    void create(const MeshView &mesh, const gusset_indices *loops, std::size_t count, const FillOptions &options,
                const Context &context) {
        const gusset_fill_options given = detail::as_c(options);
        take(context.result(gusset_fill, &mesh.get(), loops, count, &given));
    }
    gusset_fill_report report() const { return detail::lent(gusset_result_get_fill, get()); }
};

} // namespace gusset

#endif // GUSSET_FILL_HPP
