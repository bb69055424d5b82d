// Meridians and strips between polylines. Include gusset.hpp, not this.
#ifndef GUSSET_STRIP_HPP
#define GUSSET_STRIP_HPP

#include <gusset/context.hpp>

namespace gusset {

/// The choice of meridians; see the constants.
enum class Meridians : uint32_t {
    continuation = GUSSET_MERIDIANS_CONTINUATION,
    min_area = GUSSET_MERIDIANS_MIN_AREA,
    index = GUSSET_MERIDIANS_INDEX,
    arc_length = GUSSET_MERIDIANS_ARC_LENGTH,
    greedy = GUSSET_MERIDIANS_GREEDY,
    min_diagonal = GUSSET_MERIDIANS_MIN_DIAGONAL,
    smooth = GUSSET_MERIDIANS_SMOOTH,
    quad = GUSSET_MERIDIANS_QUAD
};
/// The effort of the search for the best strip.
enum class StripSearch : uint32_t { automatic = GUSSET_SEARCH_AUTO, exact = GUSSET_SEARCH_EXACT };
/// The first meridian of a closed strip.
enum class StripStart : uint32_t {
    automatic = GUSSET_START_AUTO,
    closest = GUSSET_START_CLOSEST,
    given = GUSSET_START_GIVEN
};

/// The paper's rule for meridians by index: for each i = 0 .. n of a polyline of n segments its j
/// on another of m <= n segments.
inline std::vector<uint32_t> meridians_index(uint32_t n, uint32_t m) {
    return detail::filled<uint32_t>([&](uint32_t *out, std::size_t capacity, std::size_t *written) {
        detail::check(gusset_meridians_index(n, m, out, capacity, written));
    });
}

/// A strip of triangles between two polylines that belong to no mesh; see gusset_strip_create.
class Strip {
public:
    Strip(Points a, Points b, bool closed, Meridians meridians = Meridians::continuation,
          StripStart start = StripStart::automatic, StripSearch search = StripSearch::automatic,
          const Context &context = Context()) {
        auto given = detail::sized<gusset_strip_options>();
        given.meridians = static_cast<uint32_t>(meridians);
        given.search = static_cast<uint32_t>(search);
        given.start = static_cast<uint32_t>(start);
        given.closed = closed ? 1 : 0;
        strip_.reset(context.result(gusset_strip_create, detail::numbers(a.data()), a.size(),
                                    detail::numbers(b.data()), b.size(), &given));
    }
    /// The points that the first meridian joins.
    std::array<uint32_t, 2> start() const { return {view().start[0], view().start[1]}; }
    /// Pairs of places counted from there, interleaved.
    Indices meridians() const & { return detail::indices(view().meridians); }
    Indices meridians() const && = delete;
    /// Three corners each: points of a, then points of b.
    Indices triangles() const & { return detail::indices(view().triangles); }
    Indices triangles() const && = delete;

private:
    gusset_strip_view view() const { return detail::lent(gusset_strip_get_view, strip_.get()); }
    detail::Handle<gusset_strip, gusset_strip_destroy> strip_;
};

} // namespace gusset

#endif // GUSSET_STRIP_HPP
