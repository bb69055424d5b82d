/// @file
/// Primitives: nets of standard shapes. Include gusset.hpp, not this.
#ifndef GUSSET_NET_PRIMITIVE_HPP
#define GUSSET_NET_PRIMITIVE_HPP

#include <gusset/net_coordinates.hpp>

#include <cstring>

namespace gusset {

/// A shape for Net::from_primitive, centred at the origin, its axis along z; it owns its profile.
/// See the constants GUSSET_NET_PLANE to GUSSET_NET_PILLOW and gusset_net_primitive_create.
class Primitive {
public:
    /// Rows of nodes; 0: the library's choice.
    std::size_t rows = 0;
    /// Columns of nodes; 0: the library's choice.
    std::size_t columns = 0;
    /// The type of coordinates.
    Scalar scalar = Scalar::f64;

    /// A rectangle in the plane z = 0.
    static Primitive plane(double width, double depth) {
        return Primitive(GUSSET_NET_PLANE).sized({width, depth, 0.0});
    }
    /// A sphere with two poles.
    static Primitive sphere(double radius) { return Primitive(GUSSET_NET_SPHERE, radius); }
    /// A sphere that is a disc with its rim glued to one pole.
    static Primitive one_pole_sphere(double radius) { return Primitive(GUSSET_NET_ONE_POLE_SPHERE, radius); }
    /// A cylinder without caps.
    static Primitive tube(double radius, double height) { return Primitive(GUSSET_NET_TUBE, radius, height); }
    /// A cylinder with caps.
    static Primitive cylinder(double radius, double height) { return Primitive(GUSSET_NET_CYLINDER, radius, height); }
    /// A prism over a regular polygon, with the radius of the circle through its corners.
    static Primitive prism(uint32_t sides, double radius, double height) {
        return Primitive(GUSSET_NET_PRISM, radius, height).sided(sides);
    }
    /// A cone with its base.
    static Primitive cone(double radius, double height) { return Primitive(GUSSET_NET_CONE, radius, height); }
    /// A pyramid over a regular polygon.
    static Primitive pyramid(uint32_t sides, double radius, double height) {
        return Primitive(GUSSET_NET_PYRAMID, radius, height).sided(sides);
    }
    /// `profile`: distance from the axis and height of each row, from below to above.
    static Primitive lathe(std::vector<std::array<double, 2>> profile) {
        Primitive primitive(GUSSET_NET_LATHE);
        primitive.profile_ = std::move(profile);
        return primitive;
    }
    /// A torus: the radius to the middle of the tube, and the radius of the tube.
    static Primitive torus(double radius, double tube_radius) {
        Primitive primitive(GUSSET_NET_TORUS, radius);
        primitive.given_.minor_radius = tube_radius;
        return primitive;
    }
    /// Makes a box. `cells` has the numbers of cells along x, y and z. They determine the numbers of rows and columns.
    static Primitive box(const Point3 &size, const std::array<uint32_t, 3> &cells, BoxKind kind = BoxKind::slit) {
        Primitive primitive = Primitive(GUSSET_NET_BOX).sized(size);
        std::memcpy(primitive.given_.cells, cells.data(), sizeof primitive.given_.cells);
        primitive.given_.box_kind = static_cast<gusset_box_kind>(kind);
        return primitive;
    }
    /// A Möbius strip: the radius of its middle line, and its width.
    static Primitive moebius(double radius, double width) {
        return Primitive(GUSSET_NET_MOEBIUS, radius).sized({width, 0.0, 0.0});
    }
    /// A Klein bottle.
    static Primitive klein(double radius, double minor_radius) {
        Primitive primitive(GUSSET_NET_KLEIN, radius);
        primitive.given_.minor_radius = minor_radius;
        return primitive;
    }
    /// Boy's surface; the radius is a scale.
    static Primitive projective_plane(double radius) { return Primitive(GUSSET_NET_PROJECTIVE_PLANE, radius); }
    /// Two sheets glued along their rims; `thickness`: their distance in the middle.
    static Primitive pillow(double width, double depth, double thickness) {
        return Primitive(GUSSET_NET_PILLOW, 0.0, thickness).sized({width, depth, 0.0});
    }

    /// The same shape with other numbers of rows and columns.
    Primitive with(std::size_t row_count, std::size_t column_count) const {
        Primitive primitive = *this;
        primitive.rows = row_count;
        primitive.columns = column_count;
        return primitive;
    }
    /// The same shape with coordinates of another type.
    Primitive with(Scalar type) const {
        Primitive primitive = *this;
        primitive.scalar = type;
        return primitive;
    }

    /// As the C interface has it; it borrows from this, which must outlive it.
    gusset_net_primitive get() const & {
        gusset_net_primitive given = given_;
        given.scalar = static_cast<uint32_t>(scalar);
        given.rows = rows;
        given.columns = columns;
        given.profile = profile_.empty() ? nullptr : profile_.data()->data();
        given.profile_count = profile_.size();
        return given;
    }
    gusset_net_primitive get() const && = delete;

private:
    explicit Primitive(gusset_net_shape shape, double radius = 0.0, double height = 0.0) {
        given_.shape = shape;
        given_.radius = radius;
        given_.height = height;
    }
    Primitive sized(const Point3 &size) && {
        std::memcpy(given_.size, size.data(), sizeof given_.size);
        return std::move(*this);
    }
    Primitive sided(uint32_t sides) && {
        given_.sides = sides;
        return std::move(*this);
    }

    gusset_net_primitive given_ = detail::sized<gusset_net_primitive>();
    std::vector<std::array<double, 2>> profile_;
};

} // namespace gusset

#endif // GUSSET_NET_PRIMITIVE_HPP
