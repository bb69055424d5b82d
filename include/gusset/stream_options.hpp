/// @file
/// The options of gusset/stream.h. Where a comment says NULL, an empty list or options without changes are meant.
/// Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_STREAM_OPTIONS_HPP
#define GUSSET_STREAM_OPTIONS_HPP

#include <gusset/span.hpp>

namespace gusset {

/// Options of gusset_net_encode_create and gusset_scene_encode_create. See ::gusset_stream_options.
struct StreamOptions {
    /// Rows of each independent block; 0: about 2^17 nodes, or all for RAW.
    std::size_t rows_per_block = 0;
    /// Storage of coordinates in a stream.
    StreamMode mode = StreamMode::quantised;
    /// QUANTISED: bits of a coordinate, 8 to 24; 0: 14. Else 0.
    uint32_t bits = 0;
    /// QUANTISED. 1: each axis has its own step; 0: the longest extent's. Else 0.
    bool per_axis = false;
    /// Smallest coordinates of all tiles: level 0. A value sets levels of C to GUSSET_LEVELS_GIVEN; empty:
    /// GUSSET_LEVELS_AUTO.
    std::optional<Point3> low;
    /// Largest coordinates of all tiles, at least low. A value sets levels of C to GUSSET_LEVELS_GIVEN; empty:
    /// GUSSET_LEVELS_AUTO.
    std::optional<Point3> high;
    /// Distance of levels on all axes, above 0; bits must be 0 and becomes the least number that spans the box. 0:
    /// follows from bits. A value sets levels of C to GUSSET_LEVELS_GIVEN; empty: GUSSET_LEVELS_AUTO.
    std::optional<double> step;
};

namespace detail {
inline gusset_stream_options as_c(const StreamOptions &options) {
    auto given = sized<gusset_stream_options>();
    given.rows_per_block = options.rows_per_block;
    given.mode = static_cast<gusset_stream_mode>(options.mode);
    given.bits = options.bits;
    given.per_axis = options.per_axis ? 1 : 0;
    if (options.low) {
        std::copy(options.low->begin(), options.low->end(), given.low);
        given.levels = GUSSET_LEVELS_GIVEN;
    }
    if (options.high) {
        std::copy(options.high->begin(), options.high->end(), given.high);
        given.levels = GUSSET_LEVELS_GIVEN;
    }
    if (options.step) {
        given.step = *options.step;
        given.levels = GUSSET_LEVELS_GIVEN;
    }
    return given;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_STREAM_OPTIONS_HPP
