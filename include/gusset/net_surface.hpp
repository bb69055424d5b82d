// What is found out about nets: what surface they are, what is glued, what a deformation does. Include gusset.hpp, not this.
#ifndef GUSSET_NET_SURFACE_HPP
#define GUSSET_NET_SURFACE_HPP

#include <gusset/net.hpp>

namespace gusset {

/// Which cells count.
enum class NetCells : uint32_t { all = GUSSET_NET_CELLS_ALL, present = GUSSET_NET_CELLS_PRESENT };

/// What surface a net is once glued nodes are one. It keeps nothing of the net. See gusset_net_complex_view, whose lists live
/// as long as this.
class Complex {
public:
    explicit Complex(const Net &net, NetCells cells = NetCells::all, const Context &context = Context()) {
        gusset_net_complex *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_net_complex_create(c, net.get(), static_cast<gusset_net_cells>(cells), &created);
        });
        complex_.reset(created);
    }
    gusset_net_complex_view report() const {
        gusset_net_complex_view report{};
        report.struct_size = sizeof report;
        detail::check(gusset_net_complex_get_view(complex_.get(), &report));
        return report;
    }
    /// No boundary edges.
    bool is_closed() const { return has(GUSSET_NET_CLOSED); }
    /// A surface everywhere.
    bool is_manifold() const { return has(GUSSET_NET_MANIFOLD); }
    /// Faces that share an edge run it in opposite directions.
    bool is_oriented() const { return has(GUSSET_NET_ORIENTED); }
    /// They could be made to.
    bool is_orientable() const { return has(GUSSET_NET_ORIENTABLE); }
    /// Vertices - edges + faces.
    int64_t euler() const { return report().euler; }
    /// Handles if it is orientable, else crosscaps; nothing if it is no surface.
    std::optional<int64_t> genus() const {
        const int64_t genus = report().genus;
        return genus < 0 ? std::nullopt : std::optional<int64_t>(genus);
    }
    /// How many chains of boundary edges.
    std::size_t boundary_count() const { return report().boundary_offsets.count - 1; }
    /// The vertices of chain `i` of boundary edges, each by its smallest node; throws std::out_of_range.
    Indices boundary(std::size_t i) const {
        const gusset_net_complex_view found = report();
        if (i + 1 >= found.boundary_offsets.count) {
            throw std::out_of_range("gusset: no such boundary");
        }
        const uint32_t *ends = found.boundary_offsets.data + i;
        return {found.boundary_nodes.data + ends[0], ends[1] - ends[0]};
    }
    /// Edges of no face: two vertices each, as for the other edges.
    Indices wires() const { return detail::indices(report().wires); }
    /// Edges of three faces and more.
    Indices branches() const { return detail::indices(report().branches); }
    /// Vertices whose faces are several fans.
    Indices pinches() const { return detail::indices(report().pinches); }
    /// Edges that two faces run along the same way.
    Indices conflicts() const { return detail::indices(report().conflicts); }

private:
    struct Destroy {
        void operator()(gusset_net_complex *complex) const noexcept { gusset_net_complex_destroy(complex); }
    };
    bool has(uint32_t property) const { return (report().properties & property) != 0; }
    std::unique_ptr<gusset_net_complex, Destroy> complex_;
};

/// The points of a net that are several nodes. It keeps nothing of the net; spans live as long as this.
class Groups {
public:
    explicit Groups(const Net &net, const Context &context = Context()) {
        gusset_net_groups *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_net_groups_create(c, net.get(), &created); });
        groups_.reset(created);
    }
    std::size_t size() const { return offsets().size() - 1; }
    bool empty() const { return size() == 0; }
    /// The nodes of group `i`, in order; throws std::out_of_range.
    Indices operator[](std::size_t i) const {
        gusset_indices offsets{}, members{};
        detail::check(gusset_net_groups_get_view(groups_.get(), &offsets, &members));
        if (i + 1 >= offsets.count) {
            throw std::out_of_range("gusset: no such group");
        }
        return {members.data + offsets.data[i], offsets.data[i + 1] - offsets.data[i]};
    }
    /// Group i has the nodes from members()[offsets()[i]] to members()[offsets()[i + 1] - 1].
    Indices offsets() const {
        gusset_indices offsets{}, members{};
        detail::check(gusset_net_groups_get_view(groups_.get(), &offsets, &members));
        return detail::indices(offsets);
    }
    Indices members() const {
        gusset_indices offsets{}, members{};
        detail::check(gusset_net_groups_get_view(groups_.get(), &offsets, &members));
        return detail::indices(members);
    }

private:
    struct Destroy {
        void operator()(gusset_net_groups *groups) const noexcept { gusset_net_groups_destroy(groups); }
    };
    std::unique_ptr<gusset_net_groups, Destroy> groups_;
};

/// What a validation finds; see the constants.
enum class FindingKind : uint32_t {
    link_apart = GUSSET_NET_FINDING_LINK_APART,
    seam_apart = GUSSET_NET_FINDING_SEAM_APART,
    loop = GUSSET_NET_FINDING_LOOP,
    zero_length = GUSSET_NET_FINDING_ZERO_LENGTH,
    few_nodes = GUSSET_NET_FINDING_FEW_NODES
};
/// One finding; kind is a FindingKind.
using Finding = gusset_net_finding;
inline bool operator==(const Finding &finding, FindingKind kind) { return finding.kind == static_cast<uint32_t>(kind); }

/// Whether glued nodes lie together, and what is suspicious. It keeps nothing of the net; spans live as long as this.
class Validation {
public:
    explicit Validation(const Net &net, double tolerance = 0.0, const Context &context = Context()) {
        gusset_net_validation *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_net_validation_create(c, net.get(), tolerance, &created); });
        validation_.reset(created);
    }
    /// No violations; there may be warnings.
    bool is_valid() const { return view().violation_count == 0; }
    /// Violations first, then warnings.
    Span<const Finding> findings() const {
        const gusset_net_validation_view found = view();
        return {found.findings, found.count};
    }
    /// What is wrong.
    Span<const Finding> violations() const {
        const gusset_net_validation_view found = view();
        return {found.findings, found.violation_count};
    }
    /// What is suspicious.
    Span<const Finding> warnings() const {
        const gusset_net_validation_view found = view();
        // Without findings there is no pointer to add to.
        const Finding *first = found.count == 0 ? nullptr : found.findings + found.violation_count;
        return {first, found.count - found.violation_count};
    }

private:
    struct Destroy {
        void operator()(gusset_net_validation *validation) const noexcept { gusset_net_validation_destroy(validation); }
    };
    gusset_net_validation_view view() const {
        gusset_net_validation_view report{};
        report.struct_size = sizeof report;
        detail::check(gusset_net_validation_get_view(validation_.get(), &report));
        return report;
    }
    std::unique_ptr<gusset_net_validation, Destroy> validation_;
};

/// What a deformation does to a net. It keeps nothing of nets and fields; spans live as long as this. See
/// gusset_net_analysis_view.
class Analysis {
public:
    /// Of a net before and after.
    Analysis(const Net &before, const Net &after, double tolerance = 0.0, const Context &context = Context()) {
        gusset_net_analysis *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_net_analysis_create(c, before.get(), after.get(), tolerance, &created);
        });
        analysis_.reset(created);
    }
    /// Of what fields would do to a net, which stays as it is.
    Analysis(const Net &net, Span<const Field> fields, double time = 0.0, double tolerance = 0.0,
             const Context &context = Context()) {
        const std::vector<gusset_field> given = detail::as_c(fields);
        gusset_net_analysis *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_net_analysis_of_fields_create(c, net.get(), given.data(), given.size(), time, tolerance, &created);
        });
        analysis_.reset(created);
    }
    /// Of each link, its new length divided by its old one; NaN if it had none.
    Span<const double> links() const {
        const gusset_net_analysis_view found = parts();
        return {found.links, found.link_count};
    }
    /// Of each cell, its new area divided by its old one; negative where the surface is folded over.
    Span<const double> cells() const {
        const gusset_net_analysis_view found = parts();
        return {found.cells, found.cell_count};
    }
    /// Of each cell, the determinant of the fields' Jacobian at its centre; empty if nets were compared.
    Span<const double> determinants() const {
        const gusset_net_analysis_view found = parts();
        return {found.determinants, found.determinants != nullptr ? found.cell_count : 0};
    }
    /// The links that have become a point and are not glued: see Net::absorb.
    Indices contracted() const {
        const gusset_net_analysis_view found = parts();
        return {found.contracted, found.contracted_count};
    }
    /// Of contracted link `i`, what the star of its first node has become; throws std::out_of_range.
    GluingType star(std::size_t i) const {
        const gusset_net_analysis_view found = parts();
        if (i >= found.contracted_count) {
            throw std::out_of_range("gusset: no such contracted link");
        }
        return static_cast<GluingType>(found.stars[i]);
    }
    /// The glued links whose ends have come apart.
    Indices torn() const {
        const gusset_net_analysis_view found = parts();
        return {found.torn, found.torn_count};
    }
    /// The cells that are turned the other way than most.
    Indices folded() const {
        const gusset_net_analysis_view found = parts();
        return {found.folded, found.folded_count};
    }
    /// Nothing is newly glued, torn or folded.
    bool is_soft() const { return parts().soft != 0; }

private:
    struct Destroy {
        void operator()(gusset_net_analysis *analysis) const noexcept { gusset_net_analysis_destroy(analysis); }
    };
    gusset_net_analysis_view parts() const {
        gusset_net_analysis_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_net_analysis_get_view(analysis_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_net_analysis, Destroy> analysis_;
};

} // namespace gusset

#endif // GUSSET_NET_SURFACE_HPP
