/// @file
/// Developments: surfaces laid out in the plane. Include gusset.hpp, not this.
#ifndef GUSSET_DEVELOPMENT_HPP
#define GUSSET_DEVELOPMENT_HPP

#include <gusset/result.hpp>

#include <array>

namespace gusset {

/// A surface in the plane; see gusset_develop. Its mesh is flat, with z = 0.
class Development : public Result {
public:
    /// See ::gusset_develop.
    explicit Development(const MeshView &mesh, const DevelopOptions &options = {}, const Context &context = Context()) {
        const gusset_develop_options given = detail::as_c(options);
        take(context.result(gusset_develop, &mesh.get(), &given));
    }

    /// The places of the vertices in the plane.
    Span<const std::array<double, 2>> points() const & {
        const gusset_develop_report all = report();
        return {reinterpret_cast<const std::array<double, 2> *>(all.points), all.vertex_map.count};
    }
    Span<const std::array<double, 2>> points() const && = delete;
    /// For each vertex its vertex of the surface.
    Indices vertex_map() const & { return detail::indices(report().vertex_map); }
    Indices vertex_map() const && = delete;
    /// For each face its chart.
    Indices face_charts() const & { return detail::indices(report().face_charts); }
    Indices face_charts() const && = delete;
    /// For each face the largest and the least factor by which its lengths change.
    Span<const std::array<double, 2>> stretches() const & {
        const gusset_develop_report all = report();
        return {reinterpret_cast<const std::array<double, 2> *>(all.stretches), all.face_charts.count};
    }
    Span<const std::array<double, 2>> stretches() const && = delete;
    /// The connected components, each with its account.
    Span<const gusset_chart> charts() const & { return {report().charts, report().chart_count}; }
    Span<const gusset_chart> charts() const && = delete;
    /// Edges of the surface that were cut, two vertices an edge.
    Indices cut_edges() const & { return detail::indices(report().cut_edges); }
    Indices cut_edges() const && = delete;
    /// The GUSSET_CUT_... of each cut.
    Indices cut_kinds() const & { return detail::indices(report().cut_kinds); }
    Indices cut_kinds() const && = delete;
    /// The number of darts.
    uint32_t darts() const { return report().darts; }

private:
    gusset_develop_report report() const { return detail::lent(gusset_result_get_develop, get()); }
};

} // namespace gusset

#endif // GUSSET_DEVELOPMENT_HPP
