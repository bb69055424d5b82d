// A picture of meshes and curves seen from far away, as an SVG file: faces are painted from the farthest to the nearest.
#pragma once

#include <gusset.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace pictures {
using gusset::Point3;

inline Point3 minus(const Point3 &a, const Point3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Point3 &a, const Point3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point3 unit(const Point3 &a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? Point3{a[0] / length, a[1] / length, a[2] / length} : a;
}

/// Red, green and blue from 0 to 255.
using Colour = std::array<int, 3>;
inline constexpr Colour blue{70, 118, 168}, ochre{205, 152, 72}, green{86, 150, 96}, grey{176, 174, 166}, red{178, 62, 40};

class Drawing {
public:
    /// Seen from `eye`, a direction; `scale` units of the picture for one of space.
    Drawing(int width, int height, const Point3 &eye, double scale)
        : width_(width), height_(height), eye_(unit(eye)), right_(unit(cross({0, 0, 1}, eye_))), up_(cross(eye_, right_)),
          scale_(scale) {}

    /// The place in the picture where the origin of space is from now on.
    void place(double x, double y) { x_ = x, y_ = y; }

    /// Changes the viewpoint for later drawing, in front of earlier drawing.
    void look(const Point3 &eye, double scale) {
        flush();
        eye_ = unit(eye), right_ = unit(cross({0, 0, 1}, eye_)), up_ = cross(eye_, right_), scale_ = scale;
    }

    /// Where a point of space is in the picture.
    std::array<double, 2> at(const Point3 &p) const { return {x_ + scale_ * dot(p, right_), y_ - scale_ * dot(p, up_)}; }

    /// An element of SVG, in front of earlier drawing.
    void add(const std::string &element) {
        flush();
        body_ += element;
    }

    /// A mesh, face f in the colour that `colour_of(f)` says.
    template <class ColourOf>
    void mesh(const gusset::MeshView &mesh, ColourOf &&colour_of) {
        faces(mesh, [&](std::size_t f, const std::vector<Point3> &corners, double lit) {
            return "<path d='" + path(corners) + "z' fill='" + shade(colour_of(f), lit) + "'/>\n";
        });
    }

    /// A mesh with a checked texture, `checks` to a unit of the corners' texture coordinates; odd checks have the
    /// darker colour.
    void textured(const gusset::MeshView &mesh, const std::vector<std::array<double, 2>> &coordinates, double checks,
                  const std::array<Colour, 2> &colours) {
        faces(mesh, [&](std::size_t f, const std::vector<Point3> &corners, double lit) {
            std::size_t first = 0;
            for (std::size_t g = 0; g < f; ++g) {
                first += mesh.face(g).size();
            }
            std::vector<Textured> face;
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const auto &[u, v] = coordinates[first + k];
                face.push_back({corners[k], {checks * u, checks * v}});
            }
            std::string text;
            for (const auto &check : cut(cut({face}, 0), 1)) {
                std::vector<Point3> points;
                double u = 0, v = 0;
                for (const Textured &point : check) {
                    points.push_back(point.at);
                    u += point.uv[0] / static_cast<double>(check.size());
                    v += point.uv[1] / static_cast<double>(check.size());
                }
                const bool odd = (std::lround(std::floor(u)) + std::lround(std::floor(v))) % 2 != 0;
                const std::string fill = shade(colours[odd ? 1 : 0], lit);
                text += "<path d='" + path(points) + "z' fill='" + fill + "' stroke='" + fill + "'/>\n";
            }
            return text;
        });
    }

    /// A curve, drawn with its surface; `nearer`: how far it is lifted towards the eye, so that the faces it lies on
    /// do not hide it.
    void curve(const std::vector<Point3> &points, bool closed, const Colour &colour, double width, double nearer) {
        for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k) {
            const std::vector<Point3> piece{points[k], points[(k + 1) % points.size()]};
            std::ostringstream text;
            text << "<path d='" << path(piece) << "' fill='none' stroke-linecap='round' stroke='rgb(" << colour[0] << ',' << colour[1]
                 << ',' << colour[2] << ")' stroke-width='" << width << "'/>\n";
            painted_.push_back({0.5 * dot(piece[0], eye_) + 0.5 * dot(piece[1], eye_) + nearer, text.str()});
        }
    }

    /// A line of text in the middle below.
    void caption(double x, double y, const std::string &text) {
        std::ostringstream line;
        line << "<text x='" << x << "' y='" << y << "' text-anchor='middle' stroke='none' fill='#333'>" << text << "</text>\n";
        captions_ += line.str();
    }

    /// Puts the drawing since the last call behind later drawing.
    void flush() {
        std::stable_sort(painted_.begin(), painted_.end(), [](const Painted &a, const Painted &b) { return a.depth < b.depth; });
        for (const Painted &one : painted_) {
            body_ += one.text;
        }
        painted_.clear();
    }

    bool write(const std::string &file) {
        flush();
        std::ofstream out(file);
        out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width_ << ' ' << height_
            << "' stroke='#fff' stroke-width='0.5' stroke-linejoin='round' font-family='sans-serif' font-size='15'>\n"
            // A ground of its own, so that it can be read on a dark page too.
            << "<rect width='100%' height='100%' rx='8' stroke='none' fill='#fbfaf7'/>\n"
            << body_ << captions_ << "</svg>\n";
        return out.good();
    }

private:
    /// A corner of a face with its coordinates on the texture.
    struct Textured {
        Point3 at;
        std::array<double, 2> uv;
    };

    /// Convex polygons, cut where one of their coordinates is a whole number.
    static std::vector<std::vector<Textured>> cut(const std::vector<std::vector<Textured>> &polygons, std::size_t axis) {
        std::vector<std::vector<Textured>> made;
        for (const auto &polygon : polygons) {
            double low = polygon[0].uv[axis], high = low;
            for (const Textured &point : polygon) {
                low = std::min(low, point.uv[axis]), high = std::max(high, point.uv[axis]);
            }
            for (double line = std::floor(low); line < high; ++line) {
                auto part = clipped(clipped(polygon, axis, line, 1), axis, line + 1, -1);
                if (part.size() > 2) {
                    made.push_back(std::move(part));
                }
            }
        }
        return made;
    }

    /// The part of a polygon beyond a line, or before it if `side` is -1.
    static std::vector<Textured> clipped(const std::vector<Textured> &polygon, std::size_t axis, double line, double side) {
        std::vector<Textured> made;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Textured &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
            const double x = side * (a.uv[axis] - line), y = side * (b.uv[axis] - line);
            if (x >= 0) {
                made.push_back(a);
            }
            if (x * y < 0) {
                const double t = x / (x - y);
                Textured between = a;
                for (std::size_t i = 0; i < 3; ++i) {
                    between.at[i] += t * (b.at[i] - a.at[i]);
                }
                for (std::size_t i = 0; i < 2; ++i) {
                    between.uv[i] += t * (b.uv[i] - a.uv[i]);
                }
                made.push_back(between);
            }
        }
        return made;
    }

    /// Faces that are seen: `text_of(f, corners, lit)`. Where the mesh is open both sides are, the inner one darker.
    template <class TextOf>
    void faces(const gusset::MeshView &mesh, TextOf &&text_of) {
        const bool open = !gusset::Boundary(mesh).empty();
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            std::vector<Point3> corners;
            double depth = 0;
            for (const uint32_t v : mesh.face(f)) {
                corners.push_back(mesh.position(v));
                depth += dot(corners.back(), eye_) / static_cast<double>(mesh.face(f).size());
            }
            const Point3 normal = unit(cross(minus(corners[2], corners[0]), minus(corners.back(), corners[1])));
            const double front = dot(normal, eye_);
            if (front >= 0 || open) {
                const double lit = front >= 0 ? 0.4 + 0.6 * std::max(0.0, 0.5 + 0.5 * dot(normal, light_)) : 0.32;
                painted_.push_back({depth, text_of(f, corners, lit)});
            }
        }
    }

    static std::string shade(const Colour &colour, double lit) {
        std::ostringstream text;
        text << '#' << std::hex;
        for (const int channel : colour) {
            const long value = std::lround(channel * lit);
            text << (value < 16 ? "0" : "") << value;
        }
        return text.str();
    }

    struct Painted {
        double depth;
        std::string text;
    };

    /// Points of the picture in tenths, which is fine enough and reads the same everywhere.
    std::string path(const std::vector<Point3> &points) const {
        std::ostringstream text;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const auto spot = at(points[k]);
            const long x = std::lround(10 * spot[0]), y = std::lround(10 * spot[1]);
            text << (k == 0 ? 'M' : 'L') << 0.1 * static_cast<double>(x) << ' ' << 0.1 * static_cast<double>(y);
        }
        return text.str();
    }

    int width_, height_;
    Point3 eye_, right_, up_;
    Point3 light_ = unit({-0.6, -0.9, 1.2});
    double scale_, x_ = 0, y_ = 0;
    std::vector<Painted> painted_;
    std::string body_, captions_;
};
} // namespace pictures
