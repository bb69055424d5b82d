/// @file
/// Meridians and strips between polylines. Include gusset.hpp, not this.
#ifndef GUSSET_STRIP_HPP
#define GUSSET_STRIP_HPP

#include <gusset/result.hpp>

namespace gusset {

/// The paper's rule for meridians by index: for each i = 0 .. n of a polyline of n segments its j
/// on another of m <= n segments.
inline std::vector<uint32_t> meridians_index(uint32_t n, uint32_t m) {
    return detail::filled<uint32_t>([&](uint32_t *out, std::size_t capacity, std::size_t *written) {
        detail::check(gusset_meridians_index(n, m, out, capacity, written));
    });
}

/// A strip between two polylines that belong to no mesh; see gusset_strip. Its mesh has the points of a, the points
/// of b, then
/// the new ones row by row, and the faces between them.
class Strip : public Result {
public:
    /// The strip between two polylines.
    Strip(Points a, Points b, const StripOptions &options = {}, const Context &context = Context()) {
        const gusset_strip_options given = detail::as_c(options);
        take(context.result(gusset_strip, detail::numbers(a.data()), a.size(),
                                    detail::numbers(b.data()), b.size(), &given));
    }
    /// The points that the first meridian joins.
    std::array<uint32_t, 2> start() const { return {report().start[0], report().start[1]}; }
    /// Pairs of places counted from there, interleaved.
    Indices meridians() const & { return detail::indices(report().meridians); }
    Indices meridians() const && = delete;
    /// The paper's matrix P, row by row: row_count() + 2 rows with one vertex for each meridian.
    Indices matrix() const & { return detail::indices(report().matrix); }
    Indices matrix() const && = delete;
    /// The number of interior rows.
    uint32_t row_count() const { return report().row_count; }
    /// For each new vertex its two parents, interleaved.
    Indices parents() const & { return detail::indices(report().parents); }
    Indices parents() const && = delete;
    /// For each new vertex the weight of its second parent.
    Span<const double> weights() const & {
        const gusset_strip_report found = report();
        return {found.weights, found.parents.count / 2};
    }
    Span<const double> weights() const && = delete;

private:
    gusset_strip_report report() const { return detail::lent(gusset_result_get_strip, get()); }
};

} // namespace gusset

#endif // GUSSET_STRIP_HPP
