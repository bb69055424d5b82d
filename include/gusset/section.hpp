/// @file
/// Sections of meshes by planes. Include gusset.hpp, not this.
#ifndef GUSSET_SECTION_HPP
#define GUSSET_SECTION_HPP

#include <gusset/attributes.hpp>
#include <gusset/mesh.hpp>

#include <stdexcept>
#include <vector>

namespace gusset {

/// Planes that cut a mesh; see gusset_cutting_planes. It keeps its own arrays.
class CuttingPlanes {
public:
    /// Parallel planes at rising distances from a point along a direction; see ::GUSSET_CUTTING_STACK.
    static CuttingPlanes stack(const Point3 &point, const Point3 &direction, Span<const double> distances) {
        CuttingPlanes made(GUSSET_CUTTING_STACK, distances);
        copy_vector(made.planes_.point, point);
        copy_vector(made.planes_.direction, direction);
        return made;
    }
    /// One plane through a point; see ::GUSSET_CUTTING_STACK.
    static CuttingPlanes plane(const Point3 &point, const Point3 &normal) {
        const double zero = 0.0;
        return stack(point, normal, {&zero, 1});
    }
    /// Planes through points, each with its normal; see ::GUSSET_CUTTING_PLANES.
    static CuttingPlanes each(Points points, Points normals) {
        if (points.size() != normals.size()) throw std::invalid_argument("points and normals differ in number");
        CuttingPlanes made(GUSSET_CUTTING_PLANES, {});
        made.points_.assign(points.begin(), points.end());
        made.normals_.assign(normals.begin(), normals.end());
        return made;
    }
    /// Planes that contain an axis, turned from a reference by angles; see ::GUSSET_CUTTING_AXIS.
    static CuttingPlanes about_axis(const Point3 &point, const Point3 &axis, const Point3 &reference, Span<const double> angles) {
        CuttingPlanes made(GUSSET_CUTTING_AXIS, angles);
        copy_vector(made.planes_.point, point);
        copy_vector(made.planes_.direction, axis);
        copy_vector(made.planes_.reference, reference);
        return made;
    }
    /// Planes across a polyline at distances along it; see ::GUSSET_CUTTING_CURVE.
    static CuttingPlanes across(Points polyline, Span<const double> distances, bool closed = false) {
        CuttingPlanes made(GUSSET_CUTTING_CURVE, distances);
        made.points_.assign(polyline.begin(), polyline.end());
        made.planes_.closed = closed ? 1 : 0;
        return made;
    }

    /// The struct of C. Its pointers are valid as long as this is neither changed nor moved.
    gusset_cutting_planes get() const & {
        gusset_cutting_planes given = planes_;
        given.values = values_.data();
        given.value_count = values_.size();
        given.points = points_.empty() ? nullptr : points_.front().data();
        given.normals = normals_.empty() ? nullptr : normals_.front().data();
        given.point_count = points_.size();
        return given;
    }
    gusset_cutting_planes get() const && = delete;

private:
    CuttingPlanes(gusset_cutting_kind kind, Span<const double> values)
        : planes_(detail::sized<gusset_cutting_planes>()), values_(values.begin(), values.end()) {
        planes_.kind = kind;
    }
    static void copy_vector(double (&to)[3], const Point3 &from) {
        for (std::size_t k = 0; k < 3; ++k) to[k] = from[k];
    }
    gusset_cutting_planes planes_;
    std::vector<double> values_;
    std::vector<Point3> points_, normals_;
};

/// One polyline of a section. Spans live as long as the sections.
struct SectionPath {
    /// The points; a closed path does not repeat the first.
    Points points;
    /// The two ends of the edge of each point, one pair after the other; see
    /// ::gusset_mesh_sections_view::edges.
    Span<const uint32_t> edges;
    /// See ::gusset_mesh_sections_view::parameters.
    Span<const double> parameters;
    /// See ::gusset_mesh_sections_view::faces.
    Indices faces;
    /// Plane, nesting, length and area.
    gusset_section_path path;

    /// The number of points.
    std::size_t size() const noexcept { return points.size(); }
    /// True if the path returns to its first point.
    bool is_closed() const noexcept { return path.closed != 0; }
};

/// Polylines in which planes meet a mesh; a range of SectionPath. See gusset_mesh_sections_create.
class MeshSections {
public:
    /// The type of the elements.
    using value_type = SectionPath;
    /// The type of iterators.
    using iterator = detail::Iterator<MeshSections>;

    /// See ::gusset_mesh_sections_create.
    MeshSections(const MeshView &mesh, const CuttingPlanes &planes, const MeshSectionOptions &options = {},
                 const Context &context = Context()) {
        const gusset_mesh_section_options given = detail::as_c(options);
        const gusset_cutting_planes cutting = planes.get();
        sections_.reset(context.result(gusset_mesh_sections_create, &mesh.get(), &cutting, &given));
    }

    /// The number of polylines.
    std::size_t size() const { return view().path_count; }
    /// True if no plane meets the mesh.
    bool empty() const { return size() == 0; }
    /// The number of planes.
    std::size_t plane_count() const { return view().plane_count; }
    /// Polyline `i`; throws an Error if it does not exist.
    SectionPath operator[](std::size_t i) const & {
        const gusset_mesh_sections_view all = view();
        detail::require_element(i, all.path_count, "path");
        const std::size_t from = all.starts.data[i], count = all.starts.data[i + 1] - from;
        return {detail::points(all.points + 3 * from, count),
                {all.edges + 2 * from, 2 * count},
                {all.parameters + from, count},
                {all.faces.data + from, count},
                all.paths[i]};
    }
    SectionPath operator[](std::size_t i) const && = delete;
    /// The first element.
    iterator begin() const & { return {this, 0}; }
    iterator begin() const && = delete;
    /// The end of the range.
    iterator end() const & { return {this, size()}; }
    iterator end() const && = delete;

    /// The vertices of the mesh that each point comes from; see ::gusset_mesh_sections_origins_create.
    Origins origins(const Context &context = Context()) const {
        return Origins(context.result(gusset_mesh_sections_origins_create, sections_.get()));
    }

private:
    gusset_mesh_sections_view view() const { return detail::lent(gusset_mesh_sections_get_view, sections_.get()); }
    detail::Handle<gusset_mesh_sections, gusset_mesh_sections_destroy> sections_;
};

} // namespace gusset

#endif // GUSSET_SECTION_HPP
