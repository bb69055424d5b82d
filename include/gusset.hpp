// gusset: joins surfaces that come in pieces. The C++17 face of gusset.h: RAII, ranges, exceptions. Header only.
//
// * Every failure is a gusset::Error that carries the status, the sentence and the report.
// * A callback may throw: the call is cancelled, and the exception comes out of it.
// * Results own their memory; spans and views into them are valid as long as they live. Results are immutable and may be
//   read from many threads. A Context serves one call at a time.
#ifndef GUSSET_HPP
#define GUSSET_HPP

#include <gusset/assembly.hpp>
#include <gusset/base.hpp>
#include <gusset/surface.hpp>
#include <gusset/curve.hpp>
#include <gusset/fill.hpp>
#include <gusset/frame.hpp>
#include <gusset/net.hpp>
#include <gusset/net_mesh.hpp>
#include <gusset/net_stream.hpp>
#include <gusset/net_surface.hpp>
#include <gusset/outline.hpp>
#include <gusset/repair.hpp>
#include <gusset/scene.hpp>
#include <gusset/sheet.hpp>
#include <gusset/sheet_mesh.hpp>
#include <gusset/stitch.hpp>
#include <gusset/surface_hits.hpp>
#include <gusset/surface_paths.hpp>
#include <gusset/surface_points.hpp>

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
    /// False for an open chain.
    bool is_closed() const noexcept { return (flags & GUSSET_LOOP_OPEN) == 0; }
};

/// How loops treat edges with three or more faces.
enum class NonManifold : uint32_t { cut = GUSSET_NON_MANIFOLD_CUT, stop = GUSSET_NON_MANIFOLD_STOP };

/// How much of the mesh is looked at.
enum class Survey : uint32_t {
    whole_mesh = GUSSET_SURVEY_WHOLE_MESH,
    boundary_only = GUSSET_SURVEY_BOUNDARY_ONLY
};

/// How loops are found; see gusset_boundary_options.
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
        detail::check(gusset_boundary_get_loop(boundary_.get(), i, &view));
        using detail::indices;
        return {indices(view.vertices), indices(view.half_edges), indices(view.faces),
                {view.edge_flags, view.half_edges.count}, view.length, view.flags, view.walk};
    }

    Span<const gusset_defect> defects() const {
        const gusset_defect *data = nullptr;
        std::size_t count = 0;
        detail::check(gusset_boundary_get_defects(boundary_.get(), &data, &count));
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

/// Which way faces run, seen from outside.
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
    /// The edges; see gusset_winged_edge.
    Span<const gusset_winged_edge> edges() const {
        const gusset_winged_view found = view();
        return {found.edges, found.edge_count};
    }
    /// Of each half-edge its edge.
    Indices edge_of_half_edge() const { return detail::indices(view().edge_of_half_edge); }
    /// Of each face its first edge.
    Indices edge_of_face() const { return detail::indices(view().edge_of_face); }
    /// Of each vertex an edge at it, or UINT32_MAX.
    Indices edge_of_vertex() const { return detail::indices(view().edge_of_vertex); }
    /// Loops of free edges, found on the tables: loop i has the vertices from loop_offsets()[i] to loop_offsets()[i + 1].
    Indices loop_vertices() const { return detail::indices(view().loop_vertices); }
    /// The edges along the loops: edge i starts at vertex i.
    Indices loop_edges() const { return detail::indices(view().loop_edges); }
    /// Where each loop starts; one entry more than there are loops.
    Indices loop_offsets() const { return detail::indices(view().loop_offsets); }

private:
    struct Destroy {
        void operator()(gusset_winged *winged) const noexcept { gusset_winged_destroy(winged); }
    };
    gusset_winged_view view() const {
        gusset_winged_view view{};
        view.struct_size = sizeof view;
        detail::check(gusset_winged_get_view(winged_.get(), &view));
        return view;
    }
    std::unique_ptr<gusset_winged, Destroy> winged_;
};

/// What is wrong or unusual in a mesh; see gusset_check_view, whose lists live as long as this.
class Check {
public:
    explicit Check(const MeshView &mesh, const Context &context = Context()) {
        gusset_check *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_check_create(c, &mesh.get(), &created); });
        check_.reset(created);
    }
    gusset_check_view report() const {
        gusset_check_view report{};
        report.struct_size = sizeof report;
        detail::check(gusset_check_get_view(check_.get(), &report));
        return report;
    }
    /// Every edge has two faces or more.
    bool is_closed() const { return has(GUSSET_MESH_CLOSED); }
    /// No edge has three faces, no vertex is a bow-tie.
    bool is_manifold() const { return has(GUSSET_MESH_MANIFOLD); }
    /// Faces that share an edge run it in opposite directions.
    bool is_oriented() const { return has(GUSSET_MESH_ORIENTED); }
    /// They could be made to.
    bool is_orientable() const { return has(GUSSET_MESH_ORIENTABLE); }

private:
    struct Destroy {
        void operator()(gusset_check *check) const noexcept { gusset_check_destroy(check); }
    };
    bool has(uint32_t property) const { return (report().properties & property) != 0; }
    std::unique_ptr<gusset_check, Destroy> check_;
};

/// The version of the library that is loaded; GUSSET_VERSION_STRING is the header's.
inline const char *version() noexcept { return gusset_version(); }
/// Its binary interface.
inline uint32_t abi() noexcept { return gusset_abi(); }

} // namespace gusset

#endif // GUSSET_HPP
