// A view of a hull from far away, with the curves that can be seen.
#pragma once

#include "hull_plan.hpp"

namespace ship {
struct View {
    /// Towards the eye, which is far away: a silhouette is where normals are across this.
    Point3 eye, right, up;
    double x, y, scale;

    View(const Point3 &towards, const Point3 &centre, double at_x, double at_y, double units)
        : eye(unit(towards)), right(unit(cross({0, 0, 1}, eye))), up(cross(eye, right)), x(at_x - units * dot(centre, right)),
          y(at_y + units * dot(centre, up)), scale(units) {}
    double px(const Point3 &p) const { return x + scale * dot(p, right); }
    double py(const Point3 &p) const { return y - scale * dot(p, up); }
};

struct Face {
    double depth;
    std::string path;
};

/// Colours, darker to lighter: a class of the drawing for each.
inline const std::array<std::array<double, 3>, 3> paints{{{66, 104, 146}, {186, 78, 56}, {216, 205, 180}}};
inline const int shades = 90;

/// The part of a polygon on one side of the level: sign 1 above it, -1 below.
inline std::vector<Point3> part(const std::vector<Point3> &polygon, double level, double sign) {
    std::vector<Point3> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double from = sign * (a[2] - level), to = sign * (b[2] - level);
        if (from >= 0) {
            kept.push_back(a);
        }
        if ((from < 0) != (to < 0)) {
            kept.push_back(a + (from / (from - to)) * (b - a));
        }
    }
    return kept;
}

inline void shade(const View &view, const gusset::Sheet &sheet, double tolerance, double level, bool painted, std::vector<Face> &out) {
    const Point3 light = unit(-0.45 * view.right + view.eye + 0.55 * view.up);
    gusset::SheetMeshOptions options;
    options.tolerance = tolerance;
    options.min_u = sheet.cell_count() > 1000 ? 1 : 2;
    const gusset::SheetMesh made(sheet, options);
    const gusset::MeshView mesh = made.mesh();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::vector<Point3> corners;
        Point3 normal{};
        for (uint32_t v : mesh.face(f)) {
            corners.push_back(mesh.position(v));
            normal = normal + made.normals()[v];
        }
        normal = unit(normal);
        const Point3 flat = cross(corners[2] - corners[0], corners.back() - corners[1]);
        if (dot(flat, view.eye) <= 0) {
            continue; // Seen from within.
        }
        const double lit = 0.3 + 0.7 * std::pow(0.5 + 0.5 * dot(normal, light), 1.2);
        for (double sign : {-1.0, 1.0}) {
            if (!painted && sign < 0) {
                continue;
            }
            const std::vector<Point3> polygon = painted ? part(corners, level, sign) : corners;
            if (polygon.size() < 3) {
                continue;
            }
            Face face{0, {}};
            std::ostringstream path;
            const int paint = !painted ? 2 : sign > 0 ? 0 : 1;
            path << "<path class='" << static_cast<char>('a' + paint) << std::lround(lit * (shades - 1)) << "' d='";
            long last_x = 0, last_y = 0;
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                // In tenths, from one point to the next.
                const long x = std::lround(10 * view.px(polygon[k])), y = std::lround(10 * view.py(polygon[k]));
                path << (k == 0 ? "M" : k == 1 ? "l" : x < last_x ? "" : " ") << x - last_x << (y < last_y ? "" : " ") << y - last_y;
                last_x = x;
                last_y = y;
                face.depth += dot(polygon[k], view.eye) / static_cast<double>(polygon.size());
            }
            path << "z'/>";
            face.path = path.str();
            out.push_back(std::move(face));
        }
    }
}

/// Draws those parts of a curve that nothing hides. normals: none, or as many as points.
inline void draw_seen(std::ostream &svg, const View &view, gusset::Span<const Point3> points, gusset::Span<const Point3> normals, bool closed,
                      const std::vector<gusset::Surface> &solid, double reach) {
    std::vector<gusset::Line> rays;
    for (std::size_t k = 0; k < points.size(); ++k) {
        // From a little nearer to the eye, and out of the surface.
        const Point3 away = normals.empty() ? view.eye : view.eye + normals[k];
        rays.push_back(gusset::Line::ray(points[k] + reach * away, view.eye));
    }
    std::vector<bool> hidden(rays.size(), false);
    for (const gusset::Surface &surface : solid) {
        const std::vector<gusset::Hit> hits = surface.first_hits(rays);
        for (std::size_t k = 0; k < hits.size(); ++k) {
            hidden[k] = hidden[k] || hits[k].is_found();
        }
    }
    double last_x = 0, last_y = 0;
    bool down = false, any = false;
    const std::size_t count = points.size(), steps = count + (closed ? 1 : 0);
    for (std::size_t k = 0; k < steps; ++k) {
        const double x = 10 * view.px(points[k % count]), y = 10 * view.py(points[k % count]);
        const bool last = k + 1 == steps || hidden[(k + 1) % count];
        if (hidden[k % count]) {
            down = false;
        } else if (!down || last || std::hypot(x - last_x, y - last_y) > 25) {
            svg << (any ? "" : "<path d='") << (down ? 'L' : 'M') << x << ' ' << y;
            down = any = true;
            last_x = x;
            last_y = y;
        }
    }
    svg << (any ? "'/>\n" : "");
}

inline void draw_seen(std::ostream &svg, const View &view, const SurfacePaths &paths, const std::vector<gusset::Surface> &solid, double reach) {
    for (const gusset::SurfacePath &path : paths) {
        draw_seen(svg, view, path.points, path.normals, path.closed, solid, reach);
    }
}

/// The colours: a class of the drawing for each, and a number from dark to light.
inline void style(std::ostream &svg) {
    svg << "<style>";
    for (std::size_t paint = 0; paint < paints.size(); ++paint) {
        for (int shade = 0; shade < shades; ++shade) {
            std::ostringstream colour;
            colour << '#' << std::hex << std::setfill('0');
            for (double channel : paints[paint]) {
                // From a cool shadow to a little above the paint itself.
                const double t = 1.12 * shade / (shades - 1);
                colour << std::setw(2) << static_cast<int>(std::clamp(std::lround(channel * t + 14 * (1 - t)), 0L, 255L));
            }
            svg << '.' << static_cast<char>('a' + paint) << shade << "{fill:" << colour.str() << ";stroke:" << colour.str() << '}';
        }
    }
    svg << "</style>\n";
}

/// Surface, curves and silhouette in one view.
inline void draw(std::ostream &svg, const View &view, const Hull &hull, const std::vector<gusset::Surface> &solid, const Lines &lines,
                 double draught) {
    const double length = lines.high[0] - lines.low[0], reach = 2e-4 * length, levels[] = {draught};
    gusset::ContourOptions chord;
    chord.chord = 1e-4 * length;
    std::vector<Face> faces;
    for (const auto *pieces : {&hull.port, &hull.starboard, &hull.transom, &hull.decks}) {
        for (const gusset::Sheet &sheet : *pieces) {
            shade(view, sheet, 6e-4 * length, draught, pieces != &hull.decks, faces);
        }
    }
    std::stable_sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) { return a.depth < b.depth; });
    svg << "<g transform='scale(.1)'>\n<g stroke-width='6'>\n";
    for (const Face &face : faces) {
        svg << face.path;
    }
    svg << "</g>\n<g fill='none'>\n";
    for (std::size_t k = 0; k < 2; ++k) { // Port and starboard.
        const gusset::Surface &side = solid[k];
        svg << "<g stroke='#fff' stroke-opacity='.4' stroke-width='7'>\n";
        draw_seen(svg, view, side.sections({0, 0, 0}, {1, 0, 0}, lines.places, chord), solid, reach);
        draw_seen(svg, view, side.sections({0, 0, 0}, {0, 0, 1}, lines.heights, chord), solid, reach);
        svg << "</g>\n<g stroke='#fff' stroke-width='20'>\n";
        draw_seen(svg, view, side.sections({0, 0, 0}, {0, 0, 1}, levels, chord), solid, reach);
        svg << "</g>\n<g stroke='#14202b' stroke-width='15'>\n";
        draw_seen(svg, view, side.silhouette(view.eye, chord), solid, reach);
        svg << "</g>\n<g stroke='#14202b' stroke-width='9'>\n";
        for (const auto *pieces : {k == 0 ? &hull.port : &hull.starboard, &hull.transom}) {
            for (const gusset::Sheet &sheet : *pieces) {
                for (const gusset::Curve &edge : borders(sheet)) {
                    const gusset::Places samples = edge.sample(gusset::SampleRule::step, 0.004 * length);
                    draw_seen(svg, view, samples.points(), {}, false, solid, 5 * reach);
                }
            }
        }
        svg << "</g>\n";
    }
    svg << "</g>\n<g stroke='" << mark_ink << "' stroke-width='11' fill='" << mark_ink << "'>\n";
    for (std::size_t k = 0; k < lines.outside.size(); ++k) {
        const Point3 from = lines.outside[k], at{lines.nearest[k].point[0], lines.nearest[k].point[1], lines.nearest[k].point[2]};
        svg << "<path d='M" << 10 * view.px(from) << ' ' << 10 * view.py(from) << 'L' << 10 * view.px(at) << ' ' << 10 * view.py(at)
            << "'/><circle r='24' cx='" << 10 * view.px(at) << "' cy='" << 10 * view.py(at) << "'/><circle r='28' fill='#fff' cx='" << 10 * view.px(from)
            << "' cy='" << 10 * view.py(from) << "'/>\n";
    }
    svg << "</g>\n</g>\n";
}

inline void write_view(std::ostream &svg, const Hull &hull, const std::vector<gusset::Surface> &solid, const Lines &lines, double draught) {
    const Point3 centre = 0.5 * (lines.low + lines.high);
    const double scale = 930 / (lines.high[0] - lines.low[0]);
    svg << std::fixed << std::setprecision(0) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 960 640' stroke-linejoin='round' "
        << "stroke-linecap='round'>\n<defs><linearGradient id='sky' x2='0' y2='1'><stop stop-color='#fdfdfe'/><stop offset='1' stop-color='#d9e3ec'/>"
        << "</linearGradient></defs>\n<rect width='100%' height='100%' fill='url(#sky)'/>\n";
    style(svg);
    // From the bow and above; from the stern and below.
    draw(svg, View({0.66, 0.7, 0.36}, {centre[0], 0, centre[2]}, 480, 178, scale), hull, solid, lines, draught);
    draw(svg, View({-0.6, 0.74, -0.3}, {centre[0], 0, centre[2]}, 480, 470, scale), hull, solid, lines, draught);
    svg << "</svg>\n";
}
} // namespace ship
