// Stitching: facing arcs, meridians, strips. Included by gusset.hpp.
#ifndef GUSSET_STITCH_HPP
#define GUSSET_STITCH_HPP

#include <gusset/base.hpp>

namespace gusset {

/// How meridians are chosen; see the constants.
enum class Meridians : uint32_t {
    min_area = GUSSET_MERIDIANS_MIN_AREA,
    index = GUSSET_MERIDIANS_INDEX,
    arc_length = GUSSET_MERIDIANS_ARC_LENGTH,
    greedy = GUSSET_MERIDIANS_GREEDY,
    min_diagonal = GUSSET_MERIDIANS_MIN_DIAGONAL,
    smooth = GUSSET_MERIDIANS_SMOOTH,
    quad = GUSSET_MERIDIANS_QUAD
};
/// How hard the best strip is sought.
enum class Search : uint32_t { automatic = GUSSET_SEARCH_AUTO, exact = GUSSET_SEARCH_EXACT };
/// Where the first meridian is.
enum class Start : uint32_t { automatic = GUSSET_START_AUTO, closest = GUSSET_START_CLOSEST, given = GUSSET_START_GIVEN };
/// Whether faces that cut each other are looked for.
enum class Intersections : uint32_t {
    automatic = GUSSET_INTERSECTIONS_AUTO,
    ignore = GUSSET_INTERSECTIONS_IGNORE,
    report = GUSSET_INTERSECTIONS_REPORT
};
/// What becomes of pieces that are oriented against each other.
enum class Orientation : uint32_t {
    fix = GUSSET_ORIENTATION_FIX,
    refuse = GUSSET_ORIENTATION_REFUSE,
    keep = GUSSET_ORIENTATION_KEEP
};

/// Whether whole loops are joined, or arcs of them.
enum class Extent : uint32_t {
    whole_loops = GUSSET_EXTENT_WHOLE_LOOPS,
    open_arcs = GUSSET_EXTENT_OPEN_ARCS,
    automatic = GUSSET_EXTENT_AUTO,
    arcs = GUSSET_EXTENT_ARCS
};
/// Which of several facing runs is taken.
enum class Run : uint32_t { closest = GUSSET_RUN_CLOSEST, longest = GUSSET_RUN_LONGEST };
/// What the centres of loops are the means of.
enum class Centres : uint32_t { vertices = GUSSET_CENTRES_VERTICES, length = GUSSET_CENTRES_LENGTH };
/// What the faces of strips are.
enum class Cells : uint32_t { triangles = GUSSET_CELLS_TRIANGLES, quads = GUSSET_CELLS_QUADS };

/// Interior rows: none, by the mean edge, or a number.
struct Rows {
    uint32_t mode = GUSSET_ROWS_NONE;
    /// How many, for GUSSET_ROWS_COUNT.
    uint32_t count = 0;
    /// No interior rows.
    static Rows none() { return {}; }
    /// As many as make edges across about as long as those along.
    static Rows mean_edge() { return {GUSSET_ROWS_MEAN_EDGE, 0}; }
    /// So many.
    static Rows exactly(uint32_t count) { return {GUSSET_ROWS_COUNT, count}; }
};

/// An arc of a loop: its first place and its number of vertices.
struct Arc {
    /// The first place on the loop.
    uint32_t first = 0;
    /// How many vertices.
    uint32_t count = 0;
};

/// Which vertices of two loops face each other; see gusset_facing_create. Points are packed x, y, z.
class Facing {
public:
    Facing(Span<const std::array<double, 3>> a, Span<const std::array<double, 3>> b, Run run = Run::closest,
           std::optional<double> tolerance = {}, const Context &context = Context(),
           Centres centres = Centres::vertices) {
        gusset_facing_options given{};
        given.centres = static_cast<uint32_t>(centres);
        given.struct_size = sizeof given;
        given.run = static_cast<uint32_t>(run);
        given.tolerance_mode = tolerance ? GUSSET_TOLERANCE_GIVEN : GUSSET_TOLERANCE_AUTO;
        given.tolerance = tolerance.value_or(0.0);
        const auto first = [](Span<const std::array<double, 3>> points) {
            return points.empty() ? nullptr : points.data()->data();
        };
        gusset_facing *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_facing_create(c, first(a), a.size(), first(b), b.size(), &given, &created);
        });
        facing_.reset(created);
    }
    /// Centres, normals, distances, runs, and the runs taken; valid as long as this lives.
    gusset_facing_view view() const {
        gusset_facing_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_facing_get_view(facing_.get(), &view));
        return view;
    }
    /// The run taken on loop 0 or 1.
    Arc arc(int loop) const {
        const gusset_facing_view found = view();
        return {found.taken[loop != 0][0], found.taken[loop != 0][1]};
    }

private:
    struct Destroy {
        void operator()(gusset_facing *facing) const noexcept { gusset_facing_destroy(facing); }
    };
    std::unique_ptr<gusset_facing, Destroy> facing_;
};

/// The paper's rule: for each i = 0 .. n segments of the longer polyline its j on the other one of m <= n segments.
inline std::vector<uint32_t> meridians_index(uint32_t n, uint32_t m) {
    std::size_t count = 0;
    detail::check(gusset_meridians_index(n, m, nullptr, 0, &count));
    std::vector<uint32_t> j(count);
    detail::check(gusset_meridians_index(n, m, j.data(), j.size(), &count));
    return j;
}

/// A strip of triangles between two polylines that belong to no mesh; see gusset_strip_create.
class Strip {
public:
    Strip(Span<const std::array<double, 3>> a, Span<const std::array<double, 3>> b, bool closed,
          Meridians meridians = Meridians::min_area, Start start = Start::automatic, Search search = Search::automatic,
          const Context &context = Context()) {
        gusset_strip_options given{};
        given.struct_size = sizeof given;
        given.meridians = static_cast<uint32_t>(meridians);
        given.search = static_cast<uint32_t>(search);
        given.start = static_cast<uint32_t>(start);
        given.closed = closed ? 1 : 0;
        const auto first = [](Span<const std::array<double, 3>> points) {
            return points.empty() ? nullptr : points.data()->data();
        };
        gusset_strip *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_strip_create(c, first(a), a.size(), first(b), b.size(), &given, &created);
        });
        strip_.reset(created);
    }
    /// The points that the first meridian joins.
    std::array<uint32_t, 2> start() const { return {parts().start[0], parts().start[1]}; }
    /// Pairs of places counted from there, by turns.
    Indices meridians() const { return detail::indices(parts().meridians); }
    /// Three corners each: points of a, then points of b.
    Indices triangles() const { return detail::indices(parts().triangles); }

private:
    struct Destroy {
        void operator()(gusset_strip *strip) const noexcept { gusset_strip_destroy(strip); }
    };
    gusset_strip_view parts() const {
        gusset_strip_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_strip_get_view(strip_.get(), &parts));
        return parts;
    }
    std::unique_ptr<gusset_strip, Destroy> strip_;
};

/// How to stitch; see gusset_stitch_options.
struct StitchOptions {
    Meridians meridians = Meridians::min_area;
    Orientation orientation = Orientation::fix;
    int64_t twist = 0;
    Extent extent = Extent::whole_loops;
    Run run = Run::closest;
    Rows rows;
    Cells cells = Cells::triangles;
    /// Nothing: what round-off can do.
    std::optional<double> tolerance;
    /// For Extent::arcs.
    Arc arc_a, arc_b;
    Search search = Search::automatic;
    Start start = Start::automatic;
    Fairing fairing = Fairing::none;
    Intersections intersections = Intersections::automatic;
    Centres centres = Centres::vertices;
};

namespace detail {
inline gusset_stitch_options as_c(const StitchOptions &options) {
    gusset_stitch_options given{};
    given.struct_size = sizeof given;
    given.meridians = static_cast<uint32_t>(options.meridians);
    given.orientation = static_cast<uint32_t>(options.orientation);
    given.twist = options.twist;
    given.extent = static_cast<uint32_t>(options.extent);
    given.run = static_cast<uint32_t>(options.run);
    given.rows = options.rows.mode;
    given.row_count = options.rows.count;
    given.cells = static_cast<uint32_t>(options.cells);
    given.tolerance_mode = options.tolerance ? GUSSET_TOLERANCE_GIVEN : GUSSET_TOLERANCE_AUTO;
    given.tolerance = options.tolerance.value_or(0.0);
    given.arc_a[0] = options.arc_a.first;
    given.arc_a[1] = options.arc_a.count;
    given.arc_b[0] = options.arc_b.first;
    given.arc_b[1] = options.arc_b.count;
    given.search = static_cast<uint32_t>(options.search);
    given.start = static_cast<uint32_t>(options.start);
    given.fairing = static_cast<uint32_t>(options.fairing);
    given.intersections = static_cast<uint32_t>(options.intersections);
    given.centres = static_cast<uint32_t>(options.centres);
    return given;
}
} // namespace detail

/// A finished stitch: the whole mesh, the strip, and where everything went. Made by stitch() and stitch_within().
class Stitch {
public:
    MeshView mesh() const { return view(gusset_stitch_get_mesh); }
    MeshView strip() const { return view(gusset_stitch_get_strip); }

    gusset_quality_report quality() const {
        gusset_quality_report quality{};
        quality.struct_size = sizeof quality;
        detail::check(gusset_stitch_get_quality(stitch_.get(), &quality));
        return quality;
    }

    /// Old index to new one, of mesh 0 or 1.
    Indices vertex_map(int mesh) const { return detail::indices(parts().vertex_map[mesh != 0]); }
    /// Of each old face of mesh 0 or 1 its index in the result.
    Indices face_map(int mesh) const { return detail::indices(parts().face_map[mesh != 0]); }
    /// The vertices of a rim in the result, from the first meridian on.
    Indices rim(int mesh) const { return detail::indices(parts().rim[mesh != 0]); }
    /// Pairs of places on the rims, i and j by turns.
    Indices meridians() const { return detail::indices(parts().meridians); }
    /// The strip's faces in the result: the first, and how many.
    std::pair<std::size_t, std::size_t> strip_faces() const {
        const gusset_stitch_view found = parts();
        return {found.strip_face_first, found.strip_face_count};
    }
    /// The paper's matrix P, row by row: (row_count() + 2) rows of as many vertices as there are meridians.
    Indices matrix() const { return detail::indices(parts().matrix); }
    /// Interior rows.
    uint32_t row_count() const { return parts().row_count; }
    /// Of each new vertex its two parents, by turns, and the weight of the second.
    Indices parents() const { return detail::indices(parts().parents); }
    /// Of each new vertex the weight of its second parent.
    Span<const double> weights() const {
        const gusset_stitch_view found = parts();
        return {found.weights, found.parents.count / 2};
    }
    /// True if the strip is a closed band between whole loops.
    bool is_closed_band() const { return parts().closed != 0; }
    /// Pairs of faces of mesh() that cut each other, by turns; nothing if they were not looked for.
    std::optional<Indices> intersections() const {
        const gusset_stitch_view found = parts();
        return found.intersections_known != 0 ? std::optional<Indices>(detail::indices(found.intersections)) : std::nullopt;
    }
    /// How often the fairing had to be taken back in places.
    uint32_t back_off_count() const { return parts().back_off_count; }
    /// True if the second piece was turned over.
    bool turned() const { return parts().turned != 0; }

    /// The C interface's own call; stitch() and stitch_within() are its cases.
    Stitch(const MeshView &a, const Indices *loop_a, const MeshView *b, const Indices *loop_b,
           const StitchOptions &options, const Context &context) {
        const gusset_stitch_options given = detail::as_c(options);
        const auto list = [](const Indices *loop) {
            return loop != nullptr ? gusset_indices{loop->data(), loop->size()} : gusset_indices{nullptr, 0};
        };
        const gusset_indices first = list(loop_a), second = list(loop_b);
        gusset_stitch *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_stitch_create(c, &a.get(), loop_a != nullptr ? &first : nullptr,
                                        b != nullptr ? &b->get() : nullptr, loop_b != nullptr ? &second : nullptr,
                                        &given, &created);
        });
        stitch_.reset(created);
    }

private:
    struct Destroy {
        void operator()(gusset_stitch *stitch) const noexcept { gusset_stitch_destroy(stitch); }
    };
    MeshView view(gusset_status (*get)(const gusset_stitch *, gusset_mesh_view *)) const {
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        detail::check(get(stitch_.get(), &view));
        return MeshView(view);
    }
    gusset_stitch_view parts() const {
        gusset_stitch_view parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_stitch_get_view(stitch_.get(), &parts));
        return parts;
    }

    std::unique_ptr<gusset_stitch, Destroy> stitch_;
};

/// Joins the two loops of a and b that lie nearest to each other.
inline Stitch stitch(const MeshView &a, const MeshView &b, const StitchOptions &options = {},
                     const Context &context = Context()) {
    return Stitch(a, nullptr, &b, nullptr, options, context);
}
/// Joins loop_a of a to loop_b of b; loops are vertices in order, in either direction.
inline Stitch stitch(const MeshView &a, Indices loop_a, const MeshView &b, Indices loop_b,
                     const StitchOptions &options = {}, const Context &context = Context()) {
    return Stitch(a, &loop_a, &b, &loop_b, options, context);
}
/// Joins the two loops of one mesh that lie nearest to each other.
inline Stitch stitch_within(const MeshView &mesh, const StitchOptions &options = {},
                            const Context &context = Context()) {
    return Stitch(mesh, nullptr, nullptr, nullptr, options, context);
}
/// Joins two loops of one mesh.
inline Stitch stitch_within(const MeshView &mesh, Indices loop_a, Indices loop_b, const StitchOptions &options = {},
                            const Context &context = Context()) {
    return Stitch(mesh, &loop_a, nullptr, &loop_b, options, context);
}

} // namespace gusset

#endif // GUSSET_STITCH_HPP
