// A figure of a paper: a picture in space, as of the gallery, and over it lines, letters and matrices in the plane.
#pragma once

#include "../pictures/drawing.hpp"

#include <functional>
#include <stdexcept>

namespace figures {
using gusset::Point3;
using pictures::Colour;

/// A place in the picture, y downwards.
using Spot = std::array<double, 2>;

inline constexpr Colour ink{51, 51, 51}, faint{200, 197, 188}, paper{251, 250, 247}, red{178, 62, 40},
    blue{70, 118, 168}, green{66, 130, 76}, ochre{205, 152, 72}, violet{138, 95, 176};

/// Tenths, which read the same everywhere.
inline std::string tenths(double value) {
    std::ostringstream text;
    text << 0.1 * static_cast<double>(std::lround(10 * value));
    return text.str();
}
inline std::string rgb(const Colour &c) {
    return "rgb(" + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ")";
}
/// Formats a number for the text of a figure, with this many decimals.
inline std::string places(double value, int digits) {
    std::ostringstream text;
    text.setf(std::ios::fixed);
    text.precision(digits);
    text << value;
    return text.str();
}
inline Spot between(const Spot &a, const Spot &b, double t) {
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

/// How a line is drawn.
struct Pen {
    Colour colour = ink;
    double width = 1.5;
    /// The dash pattern of SVG, or nothing.
    const char *dash = "";
};

class Figure : public pictures::Drawing {
public:
    Figure(int width, int height, const Point3 &eye = {0.5, -1, 0.7}, double scale = 100)
        : Drawing(width, height, eye, scale) {}

    void line(const std::vector<Spot> &spots, const Pen &pen = {}, bool closed = false) {
        add(shape(spots, pen, closed, "none"));
    }
    void area(const std::vector<Spot> &spots, const Colour &fill, double opacity = 1, const Pen &pen = {ink, 0, ""}) {
        add(shape(spots, pen, true, rgb(fill) + (opacity < 1 ? "' fill-opacity='" + tenths(opacity) : "")));
    }
    /// A line with a head at its end.
    void arrow(const Spot &from, const Spot &to, const Pen &pen = {}, double head = 9) {
        const double x = to[0] - from[0], y = to[1] - from[1], length = std::hypot(x, y);
        const Spot along{x / length, y / length};
        const Spot neck{to[0] - head * along[0], to[1] - head * along[1]};
        const double half = 0.4 * head;
        line({from, neck}, pen);
        area({to,
              {neck[0] - half * along[1], neck[1] + half * along[0]},
              {neck[0] + half * along[1], neck[1] - half * along[0]}},
             pen.colour);
    }
    void dot(const Spot &at, double radius, const Colour &fill, const Colour &rim = ink, double rim_width = 1) {
        add("<circle cx='" + tenths(at[0]) + "' cy='" + tenths(at[1]) + "' r='" + tenths(radius) + "' fill='" +
            rgb(fill) + "' stroke='" + rgb(rim) + "' stroke-width='" + tenths(rim_width) + "'/>\n");
    }
    void circle(const Spot &at, double radius, const Pen &pen, const Colour &fill, double opacity) {
        add("<circle cx='" + tenths(at[0]) + "' cy='" + tenths(at[1]) + "' r='" + tenths(radius) + "' fill='" +
            rgb(fill) + "' fill-opacity='" + tenths(opacity) + "'" + strokes(pen) + "/>\n");
    }
    /// Letters on a ground of their own, so that lines may pass behind. Text after a '_' is lowered, up to a space or
    /// another '_'.
    void label(const Spot &at, const std::string &text, const char *anchor = "middle", double size = 15,
               const Colour &colour = ink) {
        const std::string head = "<text x='" + tenths(at[0]) + "' y='" + tenths(at[1]) + "' text-anchor='" + anchor +
                                 "' font-size='" + tenths(size) + "' ";
        const std::string inside = lowered(text, size) + "</text>\n";
        add(head + "stroke-width='3' stroke='" + rgb(paper) + "' fill='" + rgb(paper) + "'>" + inside);
        add(head + "stroke='none' fill='" + rgb(colour) + "'>" + inside);
    }
    /// A matrix of bits, cells of `size`, those that are 1 filled; the spot is its upper left corner.
    void bits(const Spot &at, std::size_t rows, std::size_t columns, double size,
              const std::function<bool(std::size_t, std::size_t)> &one,
              const std::function<Colour(std::size_t, std::size_t)> &colour_of) {
        const double width = size * static_cast<double>(columns), height = size * static_cast<double>(rows);
        const auto cell = [&](double x, double y, double w, double h) {
            return std::vector<Spot>{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
        };
        area(cell(at[0], at[1], width, height), {255, 255, 255});
        for (std::size_t i = 0; i < rows; ++i) {
            for (std::size_t j = 0; j < columns; ++j) {
                if (one(i, j)) {
                    area(cell(at[0] + size * static_cast<double>(j), at[1] + size * static_cast<double>(i), size, size),
                         colour_of(i, j));
                }
            }
        }
        for (std::size_t i = 0; i <= rows; ++i) {
            const double y = at[1] + size * static_cast<double>(i);
            line({{at[0], y}, {at[0] + width, y}}, {faint, 0.6, ""});
        }
        for (std::size_t j = 0; j <= columns; ++j) {
            const double x = at[0] + size * static_cast<double>(j);
            line({{x, at[1]}, {x, at[1] + height}}, {faint, 0.6, ""});
        }
    }
    /// Writes the file, or throws.
    void save(const std::string &file) {
        if (!write(file)) {
            throw std::runtime_error("cannot write " + file);
        }
    }

private:
    static std::string strokes(const Pen &pen) {
        if (pen.width <= 0) {
            return " stroke='none'";
        }
        return " stroke='" + rgb(pen.colour) + "' stroke-width='" + tenths(pen.width) + "' stroke-linecap='round'" +
               (pen.dash[0] != 0 ? " stroke-dasharray='" + std::string(pen.dash) + "'" : "");
    }
    static std::string shape(const std::vector<Spot> &spots, const Pen &pen, bool closed, const std::string &fill) {
        std::string text = "<path d='";
        for (std::size_t k = 0; k < spots.size(); ++k) {
            text += (k == 0 ? "M" : "L") + tenths(spots[k][0]) + " " + tenths(spots[k][1]);
        }
        return text + (closed ? "z" : "") + "' fill='" + fill + "'" + strokes(pen) + "/>\n";
    }
    static std::string lowered(const std::string &text, double size) {
        std::string made;
        bool low = false, open = false;
        const std::string down = tenths(0.25 * size), small = tenths(0.7 * size);
        const auto back = [&] { made += "</tspan><tspan dy='-" + down + "'>", low = false; };
        for (const char c : text) {
            if (c == '_' && !low) {
                made += (open ? "</tspan>" : "") + std::string("<tspan dy='") + down + "' font-size='" + small + "'>";
                low = open = true;
            } else if (low && (c == ' ' || c == '_')) {
                back();
                made += c == ' ' ? " " : "";
            } else {
                made += c;
            }
        }
        return made + (open ? "</tspan>" : "");
    }
};

/// A figure: draws itself into a file, and prints its numbers.
using Draw = std::string (*)(const std::string &file);
struct Entry {
    const char *name;
    Draw draw;
};
std::vector<Entry> nesterenko();
std::vector<Entry> deryagin();
std::vector<Entry> leus();
std::vector<Entry> nadopta();
} // namespace figures
