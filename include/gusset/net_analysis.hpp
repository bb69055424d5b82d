/// @file
/// The effect of deformations on nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_ANALYSIS_HPP
#define GUSSET_NET_ANALYSIS_HPP

#include <gusset/net.hpp>

namespace gusset {

/// The effect of a deformation on a net. It keeps nothing of nets and fields; spans live as long as
/// this. See gusset_net_analysis_view.
class NetAnalysis {
public:
    /// Analyses a deformation without changing the net.
    NetAnalysis(const Net &net, const NetAnalysisOptions &options, const Context &context = Context()) {
        const gusset_net_analysis_options given = detail::as_c(options);
        analysis_.reset(context.result(gusset_net_analysis_create, net.get(), &given));
    }
    /// Analyses a net before and after.
    NetAnalysis(const Net &before, const Net &after, const Context &context = Context())
        : NetAnalysis(before, options_of(after), context) {}
    /// Analyses fields without changing the net.
    NetAnalysis(const Net &net, Span<const Field> fields, const Context &context = Context())
        : NetAnalysis(net, options_of(fields), context) {}
    /// For each link its new length divided by its old length; NaN if it had none.
    Span<const double> links() const & {
        const gusset_net_analysis_view found = view();
        return {found.links, found.link_count};
    }
    Span<const double> links() const && = delete;
    /// For each cell its new area divided by its old area; negative where the surface folds over.
    Span<const double> cells() const & {
        const gusset_net_analysis_view found = view();
        return {found.cells, found.cell_count};
    }
    Span<const double> cells() const && = delete;
    /// For each cell the determinant of the fields' Jacobian at its centre; empty if nets were compared.
    Span<const double> determinants() const & {
        const gusset_net_analysis_view found = view();
        return {found.determinants, found.determinants != nullptr ? found.cell_count : 0};
    }
    Span<const double> determinants() const && = delete;
    /// The links that have shrunk to a point and are not glued: see Net::absorb.
    Indices contracted() const & {
        const gusset_net_analysis_view found = view();
        return {found.contracted, found.contracted_count};
    }
    Indices contracted() const && = delete;
    /// The type of the star of the first node of contracted link `i`; throws an Error if it does not exist.
    GluingType star(std::size_t i) const {
        const gusset_net_analysis_view found = view();
        detail::require_element(i, found.contracted_count, "contracted link");
        return static_cast<GluingType>(found.stars[i]);
    }
    /// The glued links whose ends have come apart.
    Indices torn() const & {
        const gusset_net_analysis_view found = view();
        return {found.torn, found.torn_count};
    }
    Indices torn() const && = delete;
    /// The cells oriented against most of the others.
    Indices folded() const & {
        const gusset_net_analysis_view found = view();
        return {found.folded, found.folded_count};
    }
    Indices folded() const && = delete;
    /// No node is newly glued, torn or folded.
    bool is_soft() const { return view().soft != 0; }

private:
    static NetAnalysisOptions options_of(const Net &after) {
        NetAnalysisOptions options;
        options.after = after.get();
        return options;
    }
    static NetAnalysisOptions options_of(Span<const Field> fields) {
        NetAnalysisOptions options;
        options.fields = detail::as_c(fields);
        return options;
    }
    gusset_net_analysis_view view() const { return detail::lent(gusset_net_analysis_get_view, analysis_.get()); }
    detail::Handle<gusset_net_analysis, gusset_net_analysis_destroy> analysis_;
};

} // namespace gusset

#endif // GUSSET_NET_ANALYSIS_HPP
