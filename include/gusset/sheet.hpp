// Pieces of smooth surfaces. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_HPP
#define GUSSET_SHEET_HPP

#include <gusset/sheet_types.hpp>

namespace gusset {

/// A piece of surface: rows and columns of cells, each a Bézier patch. Immutable; may be used from many threads.
class Sheet {
public:
    explicit Sheet(gusset_sheet *owned) : sheet_(owned) {}

    /// Through a copy of nodes.
    static Sheet from_nodes(const NodesView &nodes, const Context &context = Context()) {
        return made(context, [&](gusset_context *c, gusset_sheet **out) {
            return gusset_sheet_from_nodes_create(c, &nodes.get(), out);
        });
    }
    /// The same, of points row after row: any container that keeps its elements side by side, whose first bytes are three floats or
    /// doubles.
    template <class Points>
    static Sheet from_nodes(std::size_t rows, std::size_t columns, const Points &points, const SheetOptions &options = {},
                            const Context &context = Context()) {
        return from_nodes(NodesView(rows, columns, points, options), context);
    }
    /// Through nodes in the caller's own memory, of doubles, which must stay valid and unchanged until the sheet and all that was made
    /// of it are gone. See gusset_sheet_borrow_create.
    template <class Points>
    static Sheet borrow(std::size_t rows, std::size_t columns, const Points &points, const SheetOptions &options = {},
                        const Context &context = Context()) {
        using T = std::decay_t<decltype((*std::data(points))[0])>;
        static_assert(std::is_same_v<T, double>, "nodes that are borrowed are of double");
        return borrowed(NodesView(rows, columns, points, options), context);
    }
    /// x, y, z of node (i, j) are at first + i * row_stride + j * column_stride, in numbers; 0: no gaps.
    static Sheet borrow(std::size_t rows, std::size_t columns, const double *first, std::size_t row_stride,
                        std::size_t column_stride, const SheetOptions &options = {}, const Context &context = Context()) {
        return borrowed(NodesView::strided(rows, columns, first, row_stride, column_stride, options), context);
    }
    /// What is gone at the end of the statement cannot be borrowed. A span may be: it owns nothing.
    template <class Points, class = std::enable_if_t<!std::is_lvalue_reference_v<Points> && !detail::is_span<Points>>>
    static Sheet borrow(std::size_t rows, std::size_t columns, Points &&points, const SheetOptions &options = {},
                        const Context &context = Context()) = delete;

    /// With given tangents, one a node, row after row.
    static Sheet from_tangents(const NodesView &nodes, Span<const Point3> u, Span<const Point3> v,
                               Twists twists = Twists::differences, const Context &context = Context()) {
        return hermite(nodes, u, v, static_cast<gusset_twists>(twists), {}, context);
    }
    /// With given tangents and mixed derivatives.
    static Sheet from_tangents(const NodesView &nodes, Span<const Point3> u, Span<const Point3> v, Span<const Point3> twists,
                               const Context &context = Context()) {
        return hermite(nodes, u, v, GUSSET_TWISTS_GIVEN, twists, context);
    }
    /// Of rows x columns Bézier patches, one after the other, each of (degree_u + 1) x (degree_v + 1) control points.
    static Sheet from_patches(Span<const Point3> points, uint32_t degree_u, uint32_t degree_v, std::size_t rows,
                              std::size_t columns, const Context &context = Context()) {
        const auto possible = [](uint32_t degree) { return degree >= 1 && degree <= 7; };
        if (!possible(degree_u) || !possible(degree_v)) {
            // Refused; without patches no point is read before that.
            rows = columns = 0;
        } else {
            const std::size_t each = (std::size_t{degree_u} + 1) * (std::size_t{degree_v} + 1);
            const std::size_t patches = points.size() / each;
            if (points.size() % each != 0 || (columns != 0 ? patches / columns != rows || patches % columns != 0 : patches != 0)) {
                throw std::invalid_argument("gusset: the number of control points is not that of the patches");
            }
        }
        return made(context, [&](gusset_context *c, gusset_sheet **out) {
            return gusset_sheet_from_patches_create(c, detail::numbers(points.data()), degree_u, degree_v, rows, columns, out);
        });
    }
    /// Of a B-spline: control points row after row, rows follow each other in u.
    static Sheet from_spline(Span<const Point3> points, const SplineAxis &u, const SplineAxis &v,
                             const Context &context = Context()) {
        if (v.count != 0 && (u.count > points.size() / v.count || u.count * v.count != points.size())) {
            throw std::invalid_argument("gusset: the number of control points is not u.count * v.count");
        }
        gusset_spline given{};
        given.struct_size = sizeof given;
        given.points = detail::numbers(points.data());
        given.count_u = u.count;
        given.count_v = v.count;
        given.knots_u = u.knots.data();
        given.knot_count_u = u.knots.size();
        given.knots_v = v.knots.data();
        given.knot_count_v = v.knots.size();
        given.degree_u = u.degree;
        given.degree_v = v.degree;
        given.closed_u = u.closed ? 1 : 0;
        given.closed_v = v.closed ? 1 : 0;
        return made(context,
                    [&](gusset_context *c, gusset_sheet **out) { return gusset_sheet_from_spline_create(c, &given, out); });
    }
    /// Gordon's surface of a net of curves, or the skin of a row of them.
    static Sheet from_curves(const CurveNet &net, const Context &context = Context()) {
        const auto handles = [](Span<const Curve> curves) {
            std::vector<const gusset_curve *> list;
            for (const Curve &curve : curves) {
                list.push_back(curve.get());
            }
            return list;
        };
        const std::vector<const gusset_curve *> rows = handles(net.rows), columns = handles(net.columns);
        gusset_curve_net given{};
        given.struct_size = sizeof given;
        given.rows = rows.data();
        given.row_count = rows.size();
        given.columns = columns.data();
        given.column_count = columns.size();
        given.tolerance = net.tolerance;
        given.closed_u = net.closed_u ? 1 : 0;
        given.closed_v = net.closed_v ? 1 : 0;
        return made(context,
                    [&](gusset_context *c, gusset_sheet **out) { return gusset_sheet_from_curves_create(c, &given, out); });
    }
    /// Of the frame of an outline.
    static Sheet from_frame(const Frame &frame, FrameSurface kind = FrameSurface::nodes, const Context &context = Context()) {
        return made(context, [&](gusset_context *c, gusset_sheet **out) {
            return gusset_sheet_from_frame_create(c, frame.get(), static_cast<uint32_t>(kind), out);
        });
    }

    const gusset_sheet *get() const noexcept { return sheet_.get(); }
    gusset_sheet_report info() const { return detail::lent(gusset_sheet_get_report, get()); }
    /// Rows of cells: u runs from 0 to this.
    std::size_t rows() const { return info().rows; }
    /// Columns of cells.
    std::size_t columns() const { return info().columns; }
    /// Cells of all rows.
    std::size_t cell_count() const {
        const gusset_sheet_report all = info();
        return all.rows * all.columns;
    }

    SheetEstimates estimates(const Context &context = Context()) const {
        const std::size_t count = cell_count();
        SheetEstimates out{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
        context.call([&](gusset_context *c) {
            return gusset_sheet_estimates(c, get(), out.errors.data(), out.bilinear.data(), out.triangles.data(), count);
        });
        return out;
    }
    /// The largest angle between normals on both sides of borders between cells, in radians.
    double crease(const Context &context = Context()) const {
        double crease = 0.0;
        context.call([&](gusset_context *c) { return gusset_sheet_crease(c, get(), &crease); });
        return crease;
    }
    /// A coordinate curve, exactly. Along rows the parameter is u, along columns v.
    Curve curve(Along along, double parameter, const Context &context = Context()) const {
        gusset_curve *created = nullptr;
        context.call([&](gusset_context *c) {
            return gusset_sheet_curve_create(c, get(), static_cast<uint32_t>(along), parameter, &created);
        });
        return Curve(created);
    }

    CellDiameters diameters(const Context &context = Context()) const {
        const std::size_t count = cell_count();
        CellDiameters out{std::vector<double>(count), std::vector<double>(count), 0.0, 0.0};
        std::size_t written = 0;
        double greatest[2] = {0.0, 0.0};
        context.call([&](gusset_context *c) {
            return gusset_sheet_diameters(c, get(), out.euclidean.data(), out.intrinsic.data(), count, &written, greatest);
        });
        out.greatest_euclidean = greatest[0];
        out.greatest_intrinsic = greatest[1];
        return out;
    }
    /// A bound of both principal curvatures all over the sheet; infinite if it is not regular everywhere.
    double curvature_bound(const Context &context = Context()) const {
        double bound = 0.0;
        context.call([&](gusset_context *c) { return gusset_sheet_curvature_bound(c, get(), &bound); });
        return bound;
    }
    /// The paper's search, the reference: which cells may have what is looked for. None that has is missing.
    Masked mask(const MaskTask &task, const Context &context = Context()) const {
        const gusset_sheet_report size = info();
        std::vector<uint64_t> words((size.rows * size.columns + 63) / 64);
        std::size_t written = 0;
        gusset_reference_report report{};
        report.struct_size = sizeof report;
        context.call([&](gusset_context *c) {
            return gusset_sheet_reference_mask(c, get(), &task, words.data(), words.size(), &written, &report);
        });
        return {CellMask::from_words(size.rows, size.columns, std::move(words)), report};
    }
    /// A shortest chain of cells of a region, from one to another: row and column of each; empty if there is none. The mask must have the
    /// sheet's rows and columns.
    std::vector<std::array<uint32_t, 2>> chain(const CellMask &region, const std::array<uint32_t, 2> &from,
                                               const std::array<uint32_t, 2> &to, const Context &context = Context()) const {
        check_shape(region);
        // A chain visits no cell twice.
        std::vector<std::array<uint32_t, 2>> cells(region.count());
        static_assert(sizeof cells[0] == sizeof(uint32_t[2]), "packed");
        std::size_t written = 0;
        context.call([&](gusset_context *c) {
            return gusset_sheet_mask_chain(c, get(), region.words().data(), region.words().size(), from.data(), to.data(),
                                      reinterpret_cast<uint32_t *>(cells.data()), cells.size(), &written);
        });
        cells.resize(written);
        return cells;
    }
    /// What a region of cells is like. The mask must have the sheet's rows and columns.
    gusset_mask_report region(const CellMask &cells, const Context &context = Context()) const {
        check_shape(cells);
        gusset_mask_report report{};
        report.struct_size = sizeof report;
        context.call([&](gusset_context *c) {
            return gusset_sheet_mask_measure(c, get(), cells.words().data(), cells.words().size(), &report);
        });
        return report;
    }
    /// The paper's approximate normals, by two orthogonal sections at each place.
    std::vector<Point3> normals_by_sections(Span<const SurfacePlace> places, const Context &context = Context()) const {
        std::vector<Point3> out(places.size());
        context.call([&](gusset_context *c) {
            return gusset_sheet_normals_by_sections(c, get(), places.data(), places.size(), detail::numbers(out.data()));
        });
        return out;
    }

private:
    void check_shape(const CellMask &mask) const {
        const gusset_sheet_report size = info();
        if (mask.rows() != size.rows || mask.columns() != size.columns) {
            throw std::invalid_argument("gusset: the mask has not as many rows and columns as the sheet");
        }
    }
    struct Destroy {
        void operator()(gusset_sheet *sheet) const noexcept { gusset_sheet_destroy(sheet); }
    };
    template <class Function>
    static Sheet made(const Context &context, Function &&function) {
        gusset_sheet *created = nullptr;
        context.call([&](gusset_context *c) { return function(c, &created); });
        return Sheet(created);
    }
    static Sheet borrowed(const NodesView &nodes, const Context &context) {
        return made(context,
                    [&](gusset_context *c, gusset_sheet **out) { return gusset_sheet_borrow_create(c, &nodes.get(), out); });
    }
    static Sheet hermite(const NodesView &nodes, Span<const Point3> u, Span<const Point3> v, gusset_twists kind,
                         Span<const Point3> twists, const Context &context) {
        const std::size_t columns = nodes.get().columns;
        const auto fits = [&](Span<const Point3> vectors) {
            return columns == 0 ? vectors.empty() : vectors.size() / columns == nodes.get().rows && vectors.size() % columns == 0;
        };
        if (!fits(u) || !fits(v) || (kind == GUSSET_TWISTS_GIVEN && !fits(twists))) {
            throw std::invalid_argument("gusset: not as many tangents as nodes");
        }
        gusset_tangents given{};
        given.struct_size = sizeof given;
        given.u = detail::numbers(u.data());
        given.v = detail::numbers(v.data());
        given.twists = kind == GUSSET_TWISTS_GIVEN ? detail::numbers(twists.data()) : nullptr;
        given.twist = kind;
        return made(context, [&](gusset_context *c, gusset_sheet **out) {
            return gusset_sheet_from_tangents_create(c, &nodes.get(), &given, out);
        });
    }
    std::unique_ptr<gusset_sheet, Destroy> sheet_;
};

} // namespace gusset

#endif // GUSSET_SHEET_HPP
