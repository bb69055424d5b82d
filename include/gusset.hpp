// gusset: joins surfaces that come in pieces. The C++17 face of gusset.h: RAII, ranges, exceptions. Header only.
//
// * Every failure is a gusset::Error that carries the status, the sentence and the report.
// * A callback may throw: the call is cancelled, and the exception comes out of it.
// * Results own their memory; spans and views into them are valid as long as they live. Results are immutable and may be
//   read from many threads. A Context serves one call at a time.
#ifndef GUSSET_HPP
#define GUSSET_HPP

#include <gusset/base.hpp>
#include <gusset/fill.hpp>
#include <gusset/repair.hpp>

namespace gusset {

/// One boundary loop or open chain; see gusset_loop_view.
struct Loop {
    Indices vertices;
    Indices half_edges;
    Indices faces;
    Span<const uint8_t> edge_flags;
    double length;
    uint32_t flags;
    uint32_t walk;
    bool is_closed() const noexcept { return (flags & GUSSET_LOOP_OPEN) == 0; }
};

enum class NonManifold : uint32_t { cut = GUSSET_NON_MANIFOLD_CUT, stop = GUSSET_NON_MANIFOLD_STOP };

enum class Survey : uint32_t {
    whole_mesh = GUSSET_SURVEY_WHOLE_MESH,
    boundary_only = GUSSET_SURVEY_BOUNDARY_ONLY
};

struct BoundaryOptions {
    NonManifold non_manifold = NonManifold::cut;
    Survey survey = Survey::whole_mesh;
};

/// All free boundary loops of a mesh, surface on the left; a range of Loop. See gusset_boundary_create.
class Boundary {
public:
    explicit Boundary(const MeshView &mesh, const BoundaryOptions &options = {}, const Context &context = Context()) {
        gusset_boundary_options given{};
        given.struct_size = sizeof given;
        given.non_manifold = static_cast<uint32_t>(options.non_manifold);
        given.survey = static_cast<uint32_t>(options.survey);
        gusset_boundary *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_boundary_create(c, &mesh.get(), &given, &created); });
        boundary_.reset(created);
    }

    std::size_t size() const noexcept { return gusset_boundary_loop_count(boundary_.get()); }
    bool empty() const noexcept { return size() == 0; }
    std::size_t walk_count() const noexcept { return gusset_boundary_walk_count(boundary_.get()); }

    /// Loop `i`; throws Error (GUSSET_ERROR_NO_SUCH_ELEMENT) from size() on.
    Loop operator[](std::size_t i) const {
        gusset_loop_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_boundary_loop(boundary_.get(), i, &view));
        using detail::indices;
        return {indices(view.vertices), indices(view.half_edges), indices(view.faces),
                {view.edge_flags, view.half_edges.count}, view.length, view.flags, view.walk};
    }

    Span<const gusset_defect> defects() const {
        const gusset_defect *data = nullptr;
        std::size_t count = 0;
        detail::check(gusset_boundary_defects(boundary_.get(), &data, &count));
        return {data, count};
    }

    class iterator {
    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = Loop;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = Loop;
        iterator() = default;
        iterator(const Boundary *boundary, std::size_t i) : boundary_(boundary), i_(i) {}
        Loop operator*() const { return (*boundary_)[i_]; }
        iterator &operator++() {
            ++i_;
            return *this;
        }
        iterator operator++(int) {
            iterator old = *this;
            ++i_;
            return old;
        }
        friend bool operator==(const iterator &a, const iterator &b) { return a.i_ == b.i_; }
        friend bool operator!=(const iterator &a, const iterator &b) { return a.i_ != b.i_; }

    private:
        const Boundary *boundary_ = nullptr;
        std::size_t i_ = 0;
    };
    iterator begin() const noexcept { return {this, 0}; }
    iterator end() const noexcept { return {this, size()}; }

private:
    struct Destroy {
        void operator()(gusset_boundary *boundary) const noexcept { gusset_boundary_destroy(boundary); }
    };
    std::unique_ptr<gusset_boundary, Destroy> boundary_;
};

enum class Winding : uint32_t {
    counter_clockwise = GUSSET_FACES_COUNTER_CLOCKWISE,
    clockwise = GUSSET_FACES_CLOCKWISE
};

/// Winged-edge tables; see gusset_winged_create.
class Winged {
public:
    explicit Winged(const MeshView &mesh, Winding winding = Winding::counter_clockwise,
                    const Context &context = Context()) {
        gusset_winged_options given{};
        given.struct_size = sizeof given;
        given.winding = static_cast<uint32_t>(winding);
        gusset_winged *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_winged_create(c, &mesh.get(), &given, &created); });
        winged_.reset(created);
    }
    Span<const gusset_winged_edge> edges() const {
        const gusset_winged_view found = view();
        return {found.edges, found.edge_count};
    }
    Indices edge_of_half_edge() const { return detail::indices(view().edge_of_half_edge); }
    Indices edge_of_face() const { return detail::indices(view().edge_of_face); }
    Indices edge_of_vertex() const { return detail::indices(view().edge_of_vertex); }
    /// Loops of free edges, found on the tables: loop i has the vertices from loop_offsets()[i] to loop_offsets()[i + 1].
    Indices loop_vertices() const { return detail::indices(view().loop_vertices); }
    Indices loop_edges() const { return detail::indices(view().loop_edges); }
    Indices loop_offsets() const { return detail::indices(view().loop_offsets); }

private:
    struct Destroy {
        void operator()(gusset_winged *winged) const noexcept { gusset_winged_destroy(winged); }
    };
    gusset_winged_view view() const {
        gusset_winged_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_winged_tables(winged_.get(), &view));
        return view;
    }
    std::unique_ptr<gusset_winged, Destroy> winged_;
};

/// What is wrong or unusual in a mesh; see gusset_check_report, whose lists live as long as this.
class Check {
public:
    explicit Check(const MeshView &mesh, const Context &context = Context()) {
        gusset_check *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_check_create(c, &mesh.get(), &created); });
        check_.reset(created);
    }
    gusset_check_report report() const {
        gusset_check_report report{};
        report.struct_size = sizeof report;
        detail::check(gusset_check_view(check_.get(), &report));
        return report;
    }
    bool is_closed() const { return has(GUSSET_MESH_CLOSED); }
    bool is_manifold() const { return has(GUSSET_MESH_MANIFOLD); }
    bool is_oriented() const { return has(GUSSET_MESH_ORIENTED); }
    bool is_orientable() const { return has(GUSSET_MESH_ORIENTABLE); }

private:
    struct Destroy {
        void operator()(gusset_check *check) const noexcept { gusset_check_destroy(check); }
    };
    bool has(uint32_t property) const { return (report().properties & property) != 0; }
    std::unique_ptr<gusset_check, Destroy> check_;
};

enum class Meridians : uint32_t { min_area = GUSSET_MERIDIANS_MIN_AREA, index = GUSSET_MERIDIANS_INDEX };
enum class Orientation : uint32_t {
    fix = GUSSET_ORIENTATION_FIX,
    refuse = GUSSET_ORIENTATION_REFUSE,
    keep = GUSSET_ORIENTATION_KEEP
};

enum class Extent : uint32_t {
    whole_loops = GUSSET_EXTENT_WHOLE_LOOPS,
    open_arcs = GUSSET_EXTENT_OPEN_ARCS,
    automatic = GUSSET_EXTENT_AUTO,
    arcs = GUSSET_EXTENT_ARCS
};
enum class Run : uint32_t { closest = GUSSET_RUN_CLOSEST, longest = GUSSET_RUN_LONGEST };
enum class Cells : uint32_t { triangles = GUSSET_CELLS_TRIANGLES, quads = GUSSET_CELLS_QUADS };

/// Interior rows: none, by the mean edge, or a number.
struct Rows {
    uint32_t mode = GUSSET_ROWS_NONE;
    uint32_t count = 0;
    static Rows none() { return {}; }
    static Rows mean_edge() { return {GUSSET_ROWS_MEAN_EDGE, 0}; }
    static Rows exactly(uint32_t count) { return {GUSSET_ROWS_COUNT, count}; }
};

/// An arc of a loop: its first place and its number of vertices.
struct Arc {
    uint32_t first = 0;
    uint32_t count = 0;
};

/// Which vertices of two loops face each other; see gusset_facing_create. Points are packed x, y, z.
class Facing {
public:
    Facing(Span<const std::array<double, 3>> a, Span<const std::array<double, 3>> b, Run run = Run::closest,
           std::optional<double> tolerance = {}, const Context &context = Context()) {
        gusset_facing_options given{};
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
        detail::check(gusset_facing_arcs(facing_.get(), &view));
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
};

/// A finished stitch: the whole mesh, the strip, and where everything went. Made by stitch() and stitch_within().
class Stitch {
public:
    MeshView mesh() const { return view(gusset_stitch_mesh); }
    MeshView strip() const { return view(gusset_stitch_strip); }

    gusset_quality quality() const {
        gusset_quality quality{};
        quality.struct_size = sizeof quality;
        detail::check(gusset_stitch_quality(stitch_.get(), &quality));
        return quality;
    }

    /// Old index to new one, of mesh 0 or 1.
    Indices vertex_map(int mesh) const { return detail::indices(parts().vertex_map[mesh != 0]); }
    Indices face_map(int mesh) const { return detail::indices(parts().face_map[mesh != 0]); }
    /// The vertices of a rim in the result, from the first meridian on.
    Indices rim(int mesh) const { return detail::indices(parts().rim[mesh != 0]); }
    /// Pairs of places on the rims, i and j by turns.
    Indices meridians() const { return detail::indices(parts().meridians); }
    /// The strip's faces in the result: the first, and how many.
    std::pair<std::size_t, std::size_t> strip_faces() const {
        const gusset_stitch_parts found = parts();
        return {found.strip_face_first, found.strip_face_count};
    }
    /// The paper's matrix P, row by row: (row_count() + 2) rows of as many vertices as there are meridians.
    Indices matrix() const { return detail::indices(parts().matrix); }
    uint32_t row_count() const { return parts().row_count; }
    /// Of each new vertex its two parents, by turns, and the weight of the second.
    Indices parents() const { return detail::indices(parts().parents); }
    Span<const double> weights() const {
        const gusset_stitch_parts found = parts();
        return {found.weights, found.parents.count / 2};
    }
    /// True if the strip is a closed band between whole loops.
    bool is_closed_band() const { return parts().closed != 0; }
    /// True if the second piece was turned over.
    bool turned() const { return parts().turned != 0; }

    /// The C interface's own call; stitch() and stitch_within() are its cases.
    Stitch(const MeshView &a, const Indices *loop_a, const MeshView *b, const Indices *loop_b,
           const StitchOptions &options, const Context &context) {
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
        const auto as_c = [](const Indices *loop) {
            return loop != nullptr ? gusset_indices{loop->data(), loop->size()} : gusset_indices{nullptr, 0};
        };
        const gusset_indices first = as_c(loop_a), second = as_c(loop_b);
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
    gusset_stitch_parts parts() const {
        gusset_stitch_parts parts{};
        parts.struct_size = sizeof parts;
        detail::check(gusset_stitch_view(stitch_.get(), &parts));
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

/// The version of the library that is loaded; GUSSET_VERSION_STRING is the header's.
inline const char *version() noexcept { return gusset_version(); }
/// Its binary interface.
inline uint32_t abi() noexcept { return gusset_abi(); }

} // namespace gusset

#endif // GUSSET_HPP
