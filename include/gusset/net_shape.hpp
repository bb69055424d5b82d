// Standard shapes of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_SHAPE_HPP
#define GUSSET_NET_SHAPE_HPP

#include <gusset/net_types.hpp>

namespace gusset {

/// The type of coordinates.
enum class Scalar : uint32_t { f32 = GUSSET_F32, f64 = GUSSET_F64 };

/// How the two caps of a box are covered.
enum class BoxKind : uint32_t {
    slit = GUSSET_NET_BOX_SLIT,
    cross = GUSSET_NET_BOX_CROSS,
    concentric = GUSSET_NET_BOX_CONCENTRIC
};

/// A shape for Net::of_shape, centred at the origin, its axis along z; it owns its profile. See the constants GUSSET_NET_PLANE to
/// GUSSET_NET_PILLOW and gusset_net_primitive_create.
class Shape {
public:
    /// Rows and columns of nodes; 0: the library's choice.
    std::size_t rows = 0, columns = 0;
    /// The type of coordinates.
    Scalar scalar = Scalar::f64;

    /// A rectangle in the plane z = 0.
    static Shape plane(double width, double depth) { return Shape(GUSSET_NET_PLANE).sized({width, depth, 0.0}); }
    /// A sphere with two poles.
    static Shape sphere(double radius) { return Shape(GUSSET_NET_SPHERE, radius); }
    /// A sphere that is a disc whose rim is drawn together.
    static Shape one_pole_sphere(double radius) { return Shape(GUSSET_NET_ONE_POLE_SPHERE, radius); }
    /// A cylinder without caps.
    static Shape tube(double radius, double height) { return Shape(GUSSET_NET_TUBE, radius, height); }
    /// A cylinder with caps.
    static Shape cylinder(double radius, double height) { return Shape(GUSSET_NET_CYLINDER, radius, height); }
    /// A prism over a regular polygon, with the radius of the circle through its corners.
    static Shape prism(uint32_t sides, double radius, double height) {
        return Shape(GUSSET_NET_PRISM, radius, height).sided(sides);
    }
    /// A cone with its base.
    static Shape cone(double radius, double height) { return Shape(GUSSET_NET_CONE, radius, height); }
    /// A pyramid over a regular polygon.
    static Shape pyramid(uint32_t sides, double radius, double height) {
        return Shape(GUSSET_NET_PYRAMID, radius, height).sided(sides);
    }
    /// `profile`: distance from the axis and height of each row, from below to above.
    static Shape lathe(std::vector<std::array<double, 2>> profile) {
        Shape shape(GUSSET_NET_LATHE);
        shape.profile_ = std::move(profile);
        return shape;
    }
    /// A torus: the radius to the middle of the tube, and that of the tube.
    static Shape torus(double radius, double tube_radius) {
        Shape shape(GUSSET_NET_TORUS, radius);
        shape.given_.minor_radius = tube_radius;
        return shape;
    }
    /// `cells`: how many along x, y and z; the number of rows and columns follows.
    static Shape box(const Point3 &size, const std::array<uint32_t, 3> &cells, BoxKind kind = BoxKind::slit) {
        Shape shape = Shape(GUSSET_NET_BOX).sized(size);
        std::memcpy(shape.given_.cells, cells.data(), sizeof shape.given_.cells);
        shape.given_.box_kind = static_cast<gusset_net_box>(kind);
        return shape;
    }
    /// A Moebius strip: the radius of its middle line, and its width.
    static Shape moebius(double radius, double width) { return Shape(GUSSET_NET_MOEBIUS, radius).sized({width, 0.0, 0.0}); }
    /// A Klein bottle.
    static Shape klein(double radius, double minor_radius) {
        Shape shape(GUSSET_NET_KLEIN, radius);
        shape.given_.minor_radius = minor_radius;
        return shape;
    }
    /// Boy's surface; the radius is a scale.
    static Shape projective_plane(double radius) { return Shape(GUSSET_NET_PROJECTIVE_PLANE, radius); }
    /// `thickness`: the distance of the sheets in the middle.
    static Shape pillow(double width, double depth, double thickness) {
        return Shape(GUSSET_NET_PILLOW, 0.0, thickness).sized({width, depth, 0.0});
    }

    /// The same shape with other numbers of rows and columns.
    Shape with(std::size_t row_count, std::size_t column_count) const {
        Shape shape = *this;
        shape.rows = row_count;
        shape.columns = column_count;
        return shape;
    }
    /// The same shape with coordinates of another type.
    Shape with(Scalar type) const {
        Shape shape = *this;
        shape.scalar = type;
        return shape;
    }

    /// As the C interface has it; it borrows from this, which must outlive it.
    gusset_net_primitive get() const & {
        gusset_net_primitive given = given_;
        given.struct_size = sizeof given;
        given.scalar = static_cast<uint32_t>(scalar);
        given.rows = rows;
        given.columns = columns;
        given.profile = profile_.empty() ? nullptr : profile_.data()->data();
        given.profile_count = profile_.size();
        return given;
    }
    gusset_net_primitive get() const && = delete;

private:
    explicit Shape(gusset_net_shape shape, double radius = 0.0, double height = 0.0) {
        given_.shape = shape;
        given_.radius = radius;
        given_.height = height;
    }
    Shape sized(const Point3 &size) && {
        std::memcpy(given_.size, size.data(), sizeof given_.size);
        return std::move(*this);
    }
    Shape sided(uint32_t sides) && {
        given_.sides = sides;
        return std::move(*this);
    }

    gusset_net_primitive given_{};
    std::vector<std::array<double, 2>> profile_;
};

} // namespace gusset

#endif // GUSSET_NET_SHAPE_HPP
