/// @file
/// Validation of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_VALIDATION_HPP
#define GUSSET_NET_VALIDATION_HPP

#include <gusset/net.hpp>

namespace gusset {

/// One finding; kind is a NetFindingKind.
using NetFinding = gusset_net_finding;
/// As in the standard library.
inline bool operator==(const NetFinding &finding, NetFindingKind kind) {
    return finding.kind == static_cast<uint32_t>(kind);
}

/// A check that glued nodes lie together, with warnings. It keeps nothing of the net; spans live as
/// long as this.
class NetValidation {
public:
    /// See ::gusset_net_validation_create.
    explicit NetValidation(const Net &net, double tolerance = 0.0, const Context &context = Context()) {
        validation_.reset(context.result(gusset_net_validation_create, net.get(), tolerance));
    }
    /// No violations; there may be warnings.
    bool is_valid() const { return view().violation_count == 0; }
    /// Violations first, then warnings.
    Span<const NetFinding> findings() const & {
        const gusset_net_validation_view found = view();
        return {found.findings, found.count};
    }
    Span<const NetFinding> findings() const && = delete;
    /// The errors.
    Span<const NetFinding> violations() const & {
        const gusset_net_validation_view found = view();
        return {found.findings, found.violation_count};
    }
    Span<const NetFinding> violations() const && = delete;
    /// The warnings.
    Span<const NetFinding> warnings() const & {
        const gusset_net_validation_view found = view();
        // Without findings the pointer may not be added to.
        const NetFinding *first = found.count == 0 ? nullptr : found.findings + found.violation_count;
        return {first, found.count - found.violation_count};
    }
    Span<const NetFinding> warnings() const && = delete;

private:
    gusset_net_validation_view view() const { return detail::lent(gusset_net_validation_get_view, validation_.get()); }
    detail::Handle<gusset_net_validation, gusset_net_validation_destroy> validation_;
};

} // namespace gusset

#endif // GUSSET_NET_VALIDATION_HPP
