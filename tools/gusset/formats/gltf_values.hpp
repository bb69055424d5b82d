// What both directions of glTF share: colours, which are linear there, and the extension that keeps polygons.
#pragma once

#include <cmath>

/// Triangles that follow each other and begin at the same vertex are one polygon.
constexpr const char *polygons_extension = "FB_ngon_encoding";
/// Two halves of the number that a vertex had before it was divided, as its corners carry different values.
constexpr const char *vertex_attribute = "_VERTEX";

inline double linear_of(double part) { return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4); }

inline double shown_of(double linear) {
    const double part = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    // One of 256 steps, if what was read is that step but for rounding.
    const double step = std::round(255 * part) / 255;
    return std::abs(linear_of(step) - linear) <= 1.0 / 65535 ? step : part;
}
