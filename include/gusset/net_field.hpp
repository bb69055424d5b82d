/// @file
/// Spatial operations and fields of deformation. Include gusset.hpp, not this.
#ifndef GUSSET_NET_FIELD_HPP
#define GUSSET_NET_FIELD_HPP

#include <gusset/context.hpp>

#include <algorithm>
#include <cstring>

namespace gusset {

/// Three rows of four numbers, the fourth of each the displacement; see gusset_transform.
using Transform = gusset_transform;
/// A map of homogeneous coordinates: four rows of four.
using Projection = std::array<double, 16>;

/// The identity.
inline Transform identity() { return {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}; }
/// The transform that moves by a vector.
inline Transform translation(const Point3 &by) { return {{1, 0, 0, by[0], 0, 1, 0, by[1], 0, 0, 1, by[2]}}; }

namespace detail {
inline double *put(double *to, double number) {
    *to = number;
    return to + 1;
}
inline double *put(double *to, const Point3 &numbers) { return std::copy(numbers.begin(), numbers.end(), to); }
/// Writes numbers one after the other.
template <class... Parts>
void put_all(double *to, const Parts &...parts) {
    ((to = put(to, parts)), ...);
    static_cast<void>(to);
}
} // namespace detail

/// A spatial operation: a step of Net::transform. See the constants GUSSET_OPERATION_...
struct Operation : gusset_operation {
    /// Moves by a vector.
    static Operation translate(const Point3 &by) { return Operation(GUSSET_OPERATION_TRANSLATE, by); }
    /// About the axis through `point`, by the right hand, in radians.
    static Operation rotate(const Point3 &direction, double angle, const Point3 &point = {}) {
        return Operation(GUSSET_OPERATION_ROTATE, direction, angle, point);
    }
    /// The same by the left hand.
    static Operation rotate_as_printed(const Point3 &direction, double angle, const Point3 &point = {}) {
        return Operation(GUSSET_OPERATION_ROTATE_AS_PRINTED, direction, angle, point);
    }
    /// About the origin.
    static Operation scale(double ratio) { return Operation(GUSSET_OPERATION_SCALE, ratio); }
    /// About an axis of coordinates.
    static Operation compress(Axis axis, double ratio) {
        Operation made(GUSSET_OPERATION_COMPRESS, ratio);
        made.axis = static_cast<gusset_axis>(axis);
        return made;
    }
    /// Scales x, y and z.
    static Operation stretch(const Point3 &ratios) { return Operation(GUSSET_OPERATION_STRETCH, ratios); }
    /// Any affine map.
    static Operation matrix(const Transform &map) {
        Operation made(GUSSET_OPERATION_MATRIX);
        std::memcpy(made.values, map.rows, sizeof map.rows);
        return made;
    }

private:
    template <class... Parts>
    explicit Operation(gusset_operation_kind kind_, const Parts &...parts) : gusset_operation{} {
        kind = kind_;
        detail::put_all(values, parts...);
    }
};
static_assert(sizeof(Operation) == sizeof(gusset_operation), "an operation is what C takes");

/// A time, and the strength of a field there.
struct FieldKey {
    /// The time.
    double time;
    /// The factor of the field's strength at this time: 0 changes nothing, 1 applies the field in
    /// full. Any finite number.
    double strength;
};

/// A field of deformation, for Net::deform. It owns its keys and offsets. See the constants
/// GUSSET_FIELD_... and gusset_field.
class Field {
public:
    /// An affine map; see GUSSET_FIELD_AFFINE.
    static Field affine(const Transform &map) {
        Field made(GUSSET_FIELD_AFFINE);
        std::memcpy(made.field_.values, map.rows, sizeof map.rows);
        return made;
    }
    /// `rate`: radians for each unit along the axis from the coordinate `from` on.
    static Field twist(Axis axis, double rate, double from = 0.0) {
        return Field(GUSSET_FIELD_TWIST, rate, from).about(axis);
    }
    /// `rate`: the growth of distances from the axis for each unit along it from the coordinate
    /// `from` on.
    static Field taper(Axis axis, double rate, double from = 0.0) {
        return Field(GUSSET_FIELD_TAPER, rate, from).about(axis);
    }
    /// Between two coordinates on the axis, towards the axis that follows.
    static Field bend(Axis axis, double curvature, double from = 0.0,
                      double to = std::numeric_limits<double>::infinity()) {
        return Field(GUSSET_FIELD_BEND, curvature, from, to).about(axis);
    }
    /// The coordinate on `axis` grows by `rate` times that on `other`.
    static Field shear(Axis axis, Axis other, double rate) {
        Field made = Field(GUSSET_FIELD_SHEAR, rate).about(axis);
        made.field_.other_axis = static_cast<gusset_axis>(other);
        return made;
    }
    /// Onto a sphere; see GUSSET_FIELD_SPHERIFY.
    static Field spherify(const Point3 &centre, double radius) { return Field(GUSSET_FIELD_SPHERIFY, centre, radius); }
    /// The next axis becomes the arc, which starts on the axis after it. The axis after it becomes the height above
    /// the cylinder. In part: rolled to less curvature.
    static Field wrap_cylinder(Axis axis, double radius) {
        return Field(GUSSET_FIELD_CYLINDER_WRAP, radius).about(axis);
    }
    /// Round a torus, by way of a tube; see GUSSET_FIELD_TORUS_WRAP.
    static Field wrap_torus(Axis axis, double radius, double tube_radius) {
        return Field(GUSSET_FIELD_TORUS_WRAP, radius, tube_radius).about(axis);
    }
    /// To a cone whose generators lean towards the axis by `angle`; see GUSSET_FIELD_CONE_WRAP.
    static Field wrap_cone(Axis axis, double radius, double angle) {
        return Field(GUSSET_FIELD_CONE_WRAP, radius, angle).about(axis);
    }
    /// To a sphere, by way of a tube; see GUSSET_FIELD_SPHERE_WRAP.
    static Field wrap_sphere(Axis axis, double radius) { return Field(GUSSET_FIELD_SPHERE_WRAP, radius).about(axis); }
    /// Free-form deformation. `offsets`: the displacement of each of counts[0] * counts[1] *
    /// counts[2] control points, x running first.
    static Field lattice(const Point3 &low, const Point3 &high, const std::array<uint32_t, 3> &counts,
                         std::vector<Point3> offsets) {
        std::size_t wanted = 1;
        bool fits = true;
        for (uint32_t count : counts) {
            // More than 32 are refused by the call, with a report.
            fits = fits && count <= 32;
            wanted *= fits ? count : 1;
        }
        if (fits && wanted != offsets.size()) {
            detail::refuse(GUSSET_ERROR_COUNT_DIFFERS, "the number of offsets is not that of the control points");
        }
        Field made(GUSSET_FIELD_LATTICE, low, high);
        made.offsets_ = std::move(offsets);
        std::memcpy(made.field_.counts, counts.data(), sizeof made.field_.counts);
        return made;
    }
    /// A map of homogeneous coordinates; see GUSSET_FIELD_PROJECTION.
    static Field projection(const Projection &map) {
        Field made(GUSSET_FIELD_PROJECTION);
        std::memcpy(made.field_.values, map.data(), sizeof made.field_.values);
        return made;
    }
    /// Onto a plane, along a direction.
    static Field parallel(const Point3 &point, const Point3 &normal, const Point3 &direction) {
        return Field(GUSSET_FIELD_PARALLEL, point, normal, direction);
    }
    /// Onto a plane, along the lines through the eye.
    static Field perspective(const Point3 &eye, const Point3 &point, const Point3 &normal) {
        return Field(GUSSET_FIELD_PERSPECTIVE, eye, point, normal);
    }

    /// The same field in part, from 0 for none to 1 for all of it. Multiplies the strength of keys.
    Field with_strength(double strength) const {
        Field made = *this;
        made.field_.strength = strength;
        return made;
    }
    /// The same field with a strength that depends on time, which increases from key to key.
    Field with_keys(std::vector<FieldKey> keys, Easing easing = Easing::linear) const {
        static_assert(sizeof(FieldKey) == 2 * sizeof(double), "packed");
        Field made = *this;
        made.keys_ = std::move(keys);
        made.field_.easing = static_cast<gusset_easing>(easing);
        return made;
    }

    /// As the C interface has it; it borrows from this, which must outlive it.
    gusset_field get() const & {
        gusset_field field = field_;
        field.keys = keys_.empty() ? nullptr : &keys_.data()->time;
        field.key_count = keys_.size();
        field.offsets = offsets_.empty() ? nullptr : offsets_.data()->data();
        return field;
    }
    gusset_field get() const && = delete;

private:
    template <class... Parts>
    explicit Field(gusset_field_kind kind, const Parts &...parts) {
        field_.kind = kind;
        field_.strength = 1.0;
        detail::put_all(field_.values, parts...);
    }
    Field about(Axis axis) && {
        field_.axis = static_cast<gusset_axis>(axis);
        return std::move(*this);
    }

    gusset_field field_ = detail::sized<gusset_field>();
    std::vector<FieldKey> keys_;
    std::vector<Point3> offsets_;
};

namespace detail {
inline std::vector<gusset_field> as_c(Span<const Field> fields) {
    std::vector<gusset_field> given;
    given.reserve(fields.size());
    for (const Field &field : fields) {
        given.push_back(field.get());
    }
    return given;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_NET_FIELD_HPP
