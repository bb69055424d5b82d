/// @file
/// Sheets: grids of patches. Include gusset.hpp, not this.
#ifndef GUSSET_SHEET_HPP
#define GUSSET_SHEET_HPP

#include <gusset/frame.hpp>
#include <gusset/reference.hpp>
#include <gusset/surface_options.hpp>
#include <gusset/surface_paths.hpp>

namespace gusset {

/// Nodes in memory that belongs to someone else, which must outlive the calls that read it; see
/// gusset_nodes.
class NodesView {
public:
    /// Views nodes row by row. `points` is a contiguous container, and each element begins with
    /// three floats or doubles.
    template <class Container>
    NodesView(std::size_t rows, std::size_t columns, const Container &points, const NodesOptions &options = {}) {
        using Point = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(points))>>;
        using T = typename detail::PointTraits3<Point>::Scalar;
        if (columns != 0 && (rows > std::size(points) / columns || rows * columns != std::size(points))) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of points is not rows * columns");
        }
        fill<T>(rows, columns, std::data(points), options);
        nodes_.column_stride = sizeof(Point);
    }
    /// x, y, z of node (i, j) are at first + i * row_stride + j * column_stride, in numbers; 0: no
    /// gaps.
    template <class T>
    static NodesView strided(std::size_t rows, std::size_t columns, const T *first, std::size_t row_stride,
                             std::size_t column_stride, const NodesOptions &options = {}) {
        NodesView view;
        view.fill<T>(rows, columns, first, options);
        view.nodes_.row_stride = detail::stride_in_bytes<T>(row_stride);
        view.nodes_.column_stride = detail::stride_in_bytes<T>(column_stride);
        return view;
    }
    /// The argument for the C interface, which this still owns.
    const gusset_nodes &get() const noexcept { return nodes_; }

private:
    NodesView() = default;
    template <class T>
    void fill(std::size_t rows, std::size_t columns, const void *first, const NodesOptions &options) {
        static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "nodes of float or double");
        nodes_ = detail::as_c(options);
        nodes_.nodes = first;
        nodes_.rows = rows;
        nodes_.columns = columns;
        nodes_.scalar = std::is_same_v<T, float> ? GUSSET_F32 : GUSSET_F64;
    }
    gusset_nodes nodes_ = detail::sized<gusset_nodes>();
};

/// A direction of a B-spline; see gusset_spline.
struct SplineAxis {
    /// The number of control points.
    std::size_t count;
    /// The degree, 1 to 7.
    uint32_t degree;
    /// The knots; see gusset_spline.
    Span<const double> knots;
    /// A closed direction; see gusset_spline.
    bool closed = false;
};

/// Numbers for each cell, row after row; see gusset_cell_arrays.
struct SheetEstimates {
    /// An estimate of the distance from the smooth surface that the nodes were taken from.
    std::vector<double> errors;
    /// A bound of the distance from the bilinear patches of the cells.
    std::vector<double> bilinear;
    /// The same from the triangles.
    std::vector<double> triangles;
};

/// Bounds of the diameters of cells, row after row; see gusset_cell_arrays.
struct CellDiameters {
    /// For each cell a bound of the distance of two of its points in space.
    std::vector<double> euclidean;
    /// For each cell a bound of the distance of two of its points within the cell.
    std::vector<double> intrinsic;
    /// The largest of `euclidean`.
    double max_euclidean;
    /// The largest of `intrinsic`.
    double max_intrinsic;
};

/// A sheet: rows and columns of cells, each a Bézier patch. Immutable; may be used from many
/// threads.
class Sheet {
public:
    /// Takes ownership of a handle of the C interface.
    explicit Sheet(gusset_sheet *owned) : sheet_(owned) {}

    /// Through a copy of nodes.
    static Sheet from_nodes(const NodesView &nodes, const Context &context = Context()) {
        return through(nodes, nullptr, 0, context);
    }
    /// The same, of points row after row: any container that keeps its elements side by side, whose
    /// first bytes are three floats or doubles.
    template <class Container>
    static Sheet from_nodes(std::size_t rows, std::size_t columns, const Container &points,
                            const NodesOptions &options = {}, const Context &context = Context()) {
        return from_nodes(NodesView(rows, columns, points, options), context);
    }
    /// Through nodes in the caller's own memory, of doubles, which must stay valid and unchanged
    /// until the sheet and everything made of it are gone. See gusset_sheet_create.
    template <class Container>
    static Sheet borrow(std::size_t rows, std::size_t columns, const Container &points,
                        const NodesOptions &options = {}, const Context &context = Context()) {
        using T = std::decay_t<decltype((*std::data(points))[0])>;
        static_assert(std::is_same_v<T, double>, "nodes that are borrowed are of double");
        return through(NodesView(rows, columns, points, options), nullptr, 1, context);
    }
    /// x, y, z of node (i, j) are at first + i * row_stride + j * column_stride, in numbers; 0: no
    /// gaps.
    static Sheet borrow(std::size_t rows, std::size_t columns, const double *first, std::size_t row_stride,
                        std::size_t column_stride, const NodesOptions &options = {},
                        const Context &context = Context()) {
        return through(NodesView::strided(rows, columns, first, row_stride, column_stride, options), nullptr, 1,
                       context);
    }
    /// A temporary cannot be borrowed, unless it is a span, which owns nothing.
    template <class Container,
              class = std::enable_if_t<!std::is_lvalue_reference_v<Container> && !detail::is_span<Container>>>
    static Sheet borrow(std::size_t rows, std::size_t columns, Container &&points, const NodesOptions &options = {},
                        const Context &context = Context()) = delete;

    /// With given tangents, one for each node, row after row.
    static Sheet from_tangents(const NodesView &nodes, Points u, Points v, Twists twists = Twists::differences,
                               const Context &context = Context()) {
        return hermite(nodes, u, v, static_cast<gusset_twists>(twists), {}, context);
    }
    /// With given tangents and mixed derivatives.
    static Sheet from_tangents(const NodesView &nodes, Points u, Points v, Points twists,
                               const Context &context = Context()) {
        return hermite(nodes, u, v, GUSSET_TWISTS_GIVEN, twists, context);
    }
    /// From rows x columns Bézier patches, one after the other, each of (degree_u + 1) x (degree_v +
    /// 1) control points.
    static Sheet from_patches(Points points, uint32_t degree_u, uint32_t degree_v, std::size_t rows,
                              std::size_t columns, const Context &context = Context()) {
        const auto possible = [](uint32_t degree) { return degree >= 1 && degree <= 7; };
        if (!possible(degree_u) || !possible(degree_v)) {
            // Refused by the call, which without patches reads no point.
            rows = columns = 0;
        } else {
            const std::size_t each = (std::size_t{degree_u} + 1) * (std::size_t{degree_v} + 1);
            const std::size_t patches = points.size() / each;
            const bool fits = columns != 0 ? patches / columns == rows && patches % columns == 0 : patches == 0;
            if (points.size() % each != 0 || !fits) {
                detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of control points is not that of the patches");
            }
        }
        return Sheet(context.result(gusset_sheet_from_patches_create, detail::numbers(points.data()), degree_u,
                                    degree_v, rows, columns));
    }
    /// From a B-spline: control points row after row, where rows follow each other in u.
    static Sheet from_spline(Points points, const SplineAxis &u, const SplineAxis &v,
                             const Context &context = Context()) {
        return spline(points, {}, u, v, {}, context);
    }
    /// From a rational B-spline (NURBS): control points of space, not multiplied by their weights, and
    /// a weight for each of them.
    static Sheet from_spline(Points points, Span<const double> weights, const SplineAxis &u, const SplineAxis &v,
                             const SplineOptions &options = {}, const Context &context = Context()) {
        if (weights.size() != points.size()) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of weights is not that of control points");
        }
        return spline(points, weights, u, v, options, context);
    }
    /// The Gordon surface of a net of curves, or the skin of a row of them. `rows`: curves in v, one after the other in
    /// u; `columns`: curves in u, one after the other in v. Either may be empty.
    static Sheet from_curves(Span<const Curve> rows, Span<const Curve> columns, const CurveNetOptions &options = {},
                             const Context &context = Context()) {
        const auto handles = [](Span<const Curve> curves) {
            std::vector<const gusset_curve *> list;
            for (const Curve &curve : curves) {
                list.push_back(curve.get());
            }
            return list;
        };
        const std::vector<const gusset_curve *> in_v = handles(rows), in_u = handles(columns);
        gusset_curve_net given = detail::as_c(options);
        given.rows = in_v.data();
        given.row_count = in_v.size();
        given.columns = in_u.data();
        given.column_count = in_u.size();
        return Sheet(context.result(gusset_sheet_from_curves_create, &given));
    }
    /// From the frame of an outline.
    static Sheet from_frame(const Frame &frame, FrameSurface kind = FrameSurface::sections,
                            const Context &context = Context()) {
        return Sheet(context.result(gusset_sheet_from_frame_create, frame.get(), static_cast<uint32_t>(kind)));
    }

    /// The surface beside this one: corners of cells moved along the normals by distances, one for all,
    /// one for each line along v, or one for each; see gusset_sheet_offset_create.
    Sheet offset(Span<const double> distances, double *deviation = nullptr, const Context &context = Context()) const {
        return Sheet(context.result(gusset_sheet_offset_create, get(), distances.data(), distances.size(), deviation));
    }
    /// The same by one distance for all corners.
    Sheet offset(double distance, double *deviation = nullptr, const Context &context = Context()) const {
        return offset({&distance, 1}, deviation, context);
    }

    /// The argument for the C interface, which this still owns.
    const gusset_sheet *get() const noexcept { return sheet_.get(); }
    /// See ::gusset_sheet_get_report.
    gusset_sheet_report report() const { return detail::lent(gusset_sheet_get_report, get()); }
    /// For a sheet of a B-spline: the parameters of the borders of its rows, or of its columns, valid
    /// as long as the sheet. Any other sheet has none.
    Span<const double> knots(bool of_columns) const {
        const gusset_sheet_report all = report();
        const double *first = of_columns ? all.knots_v : all.knots_u;
        return {first, first == nullptr ? 0 : (of_columns ? all.columns : all.rows) + 1};
    }
    /// Rows of cells: u runs from 0 to this.
    std::size_t rows() const { return report().rows; }
    /// Columns of cells.
    std::size_t columns() const { return report().columns; }
    /// The number of cells.
    std::size_t cell_count() const {
        const gusset_sheet_report all = report();
        return all.rows * all.columns;
    }

    /// The estimates of each cell; see gusset_cell_arrays.
    SheetEstimates estimates(const Context &context = Context()) const {
        const std::size_t count = cell_count();
        SheetEstimates out{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
        auto cells = detail::sized<gusset_cell_arrays>();
        cells.capacity = count;
        cells.errors = out.errors.data();
        cells.bilinear = out.bilinear.data();
        cells.triangles = out.triangles.data();
        measure_cells(cells, context);
        return out;
    }
    /// The largest angle between normals on both sides of borders between cells, in radians.
    double crease(const Context &context = Context()) const {
        return measure(GUSSET_SHEET_MEASURE_CREASE, nullptr, context).crease;
    }
    /// A coordinate curve, exactly. Along rows the parameter is u, along columns v.
    Curve curve(SheetDirection along, double parameter, const Context &context = Context()) const {
        return Curve(context.result(gusset_sheet_curve_create, get(), static_cast<uint32_t>(along), parameter));
    }

    /// The diameters of each cell, and the largest ones.
    CellDiameters diameters(const Context &context = Context()) const {
        const std::size_t count = cell_count();
        CellDiameters out{std::vector<double>(count), std::vector<double>(count), 0.0, 0.0};
        auto cells = detail::sized<gusset_cell_arrays>();
        cells.capacity = count;
        cells.diameters = out.euclidean.data();
        cells.intrinsic_diameters = out.intrinsic.data();
        const gusset_sheet_measures found = measure(GUSSET_SHEET_MEASURE_DIAMETERS, &cells, context);
        out.max_euclidean = found.diameter;
        out.max_intrinsic = found.intrinsic_diameter;
        return out;
    }
    /// A bound of both principal curvatures all over the sheet; infinite if it is not regular
    /// everywhere.
    double curvature_bound(const Context &context = Context()) const {
        return measure(GUSSET_SHEET_MEASURE_CURVATURE, nullptr, context).curvature_bound;
    }
    /// The cells that may hold the object of a task, by the paper's search. No cell that does is
    /// missing.
    ReferenceMask reference_mask(const ReferenceTask &task, const Context &context = Context()) const {
        const gusset_sheet_report size = report();
        std::vector<uint64_t> words((size.rows * size.columns + 63) / 64);
        std::size_t written = 0;
        auto found = detail::sized<gusset_reference_report>();
        context.call(gusset_sheet_reference_mask, get(), &task, words.data(), words.size(), &written, &found);
        return {CellMask::from_words(size.rows, size.columns, std::move(words)), found};
    }
    /// A shortest chain of marked cells from one to another: row and column of each; empty if none
    /// exists. The mask must have the sheet's rows and columns.
    std::vector<std::array<uint32_t, 2>> mask_chain(const CellMask &mask, const std::array<uint32_t, 2> &from,
                                                    const std::array<uint32_t, 2> &to,
                                                    const Context &context = Context()) const {
        check_shape(mask);
        // A chain visits no cell twice.
        std::vector<std::array<uint32_t, 2>> cells(mask.count());
        static_assert(sizeof cells[0] == sizeof(uint32_t[2]), "packed");
        std::size_t written = 0;
        context.call(gusset_sheet_mask_chain, get(), mask.words().data(), mask.words().size(), from.data(),
                     to.data(), reinterpret_cast<uint32_t *>(cells.data()), cells.size(), &written);
        cells.resize(written);
        return cells;
    }
    /// Row and column of each marked cell. The mask must have the sheet's rows and columns.
    std::vector<std::array<uint32_t, 2>> mask_cells(const CellMask &mask, const Context &context = Context()) const {
        return mask_elements(GUSSET_DOMAIN_FACES, mask, mask.count(), context);
    }
    /// Row and column of each corner of marked cells.
    std::vector<std::array<uint32_t, 2>> mask_nodes(const CellMask &mask, const Context &context = Context()) const {
        return mask_elements(GUSSET_DOMAIN_VERTICES, mask, 4 * mask.count(), context);
    }
    /// Numbers of the region of marked cells. The mask must have the sheet's rows and columns.
    gusset_mask_report mask_measure(const CellMask &mask, const Context &context = Context()) const {
        check_shape(mask);
        return context.result(gusset_sheet_mask_measure, get(), mask.words().data(), mask.words().size());
    }
    /// The paper's approximate normals, by two orthogonal sections at each place.
    std::vector<Point3> normals_by_sections(Span<const SurfacePlace> places, const Context &context = Context()) const {
        std::vector<Point3> out(places.size());
        context.call(gusset_sheet_normals_by_sections, get(), places.data(), places.size(),
                     detail::numbers(out.data()));
        return out;
    }

private:
    gusset_sheet_measures measure(gusset_sheet_measure_flags parts, const gusset_cell_arrays *cells,
                                  const Context &context) const {
        return context.result(gusset_sheet_measure, get(), parts, cells);
    }
    void measure_cells(const gusset_cell_arrays &cells, const Context &context) const {
        context.call(gusset_sheet_measure, get(), gusset_sheet_measure_flags{0}, &cells, nullptr);
    }
    std::vector<std::array<uint32_t, 2>> mask_elements(gusset_domain domain, const CellMask &mask,
                                                       std::size_t capacity, const Context &context) const {
        check_shape(mask);
        std::vector<std::array<uint32_t, 2>> found(capacity);
        std::size_t written = 0;
        context.call(gusset_sheet_mask_elements, get(), mask.words().data(), mask.words().size(), domain,
                     reinterpret_cast<uint32_t *>(found.data()), found.size(), &written);
        found.resize(written);
        return found;
    }
    void check_shape(const CellMask &mask) const {
        const gusset_sheet_report size = report();
        if (mask.rows() != size.rows || mask.columns() != size.columns) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the mask has not as many rows and columns as the sheet");
        }
    }
    static Sheet through(const NodesView &nodes, const gusset_tangents *tangents, uint32_t borrow,
                         const Context &context) {
        return Sheet(context.result(gusset_sheet_create, &nodes.get(), tangents, borrow));
    }
    static Sheet spline(Points points, Span<const double> weights, const SplineAxis &u, const SplineAxis &v,
                        const SplineOptions &options, const Context &context) {
        if (v.count != 0 && (u.count > points.size() / v.count || u.count * v.count != points.size())) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of control points is not u.count * v.count");
        }
        gusset_spline given = detail::as_c(options);
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
        given.weights = weights.data();
        return Sheet(context.result(gusset_sheet_from_spline_create, &given));
    }
    static Sheet hermite(const NodesView &nodes, Points u, Points v, gusset_twists kind, Points twists,
                         const Context &context) {
        const std::size_t columns = nodes.get().columns;
        const auto fits = [&](Points vectors) {
            return columns == 0 ? vectors.empty()
                                : vectors.size() / columns == nodes.get().rows && vectors.size() % columns == 0;
        };
        if (!fits(u) || !fits(v) || (kind == GUSSET_TWISTS_GIVEN && !fits(twists))) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "not as many tangents as nodes");
        }
        auto given = detail::sized<gusset_tangents>();
        given.u = detail::numbers(u.data());
        given.v = detail::numbers(v.data());
        given.twists = kind == GUSSET_TWISTS_GIVEN ? detail::numbers(twists.data()) : nullptr;
        given.twist = kind;
        return through(nodes, &given, 0, context);
    }
    detail::Handle<gusset_sheet, gusset_sheet_destroy> sheet_;
};

} // namespace gusset

#endif // GUSSET_SHEET_HPP
