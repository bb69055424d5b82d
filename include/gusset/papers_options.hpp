/// @file
/// The options of gusset/papers.h. Where a comment says NULL, an empty list or options without changes are meant.
/// Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_PAPERS_OPTIONS_HPP
#define GUSSET_PAPERS_OPTIONS_HPP

#include <gusset/span.hpp>

namespace gusset {

/// Options of winged-edge tables. See ::gusset_winged_options.
struct WingedOptions {
    /// Orientation of faces in a mesh.
    Winding winding = Winding::counter_clockwise;
};

namespace detail {
inline gusset_winged_options as_c(const WingedOptions &options) {
    auto given = sized<gusset_winged_options>();
    given.winding = static_cast<gusset_winding>(options.winding);
    return given;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_PAPERS_OPTIONS_HPP
