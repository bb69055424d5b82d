// Draws smooth curves through the points of an outline by each method, and the distances between the curves:
//   outline points.csv drawing.svg       (columns x and y; --columns names others)
//   outline - drawing.svg                (an outline by formula, something like the cross section of a foot)
#include <gusset.hpp>

#include <CLI/CLI.hpp>
#include <csv.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {
using Point = std::array<double, 2>;

struct Style {
    const char *name;
    const char *colour;
    gusset::CurveKind kind;
    gusset::SectionMethod method;
};
// The others are compared with the first curve.
const Style styles[] = {
    {"bisector", "#b3400e", gusset::CurveKind::composite, gusset::SectionMethod::bisector},
    {"median", "#2f6db5", gusset::CurveKind::composite, gusset::SectionMethod::median},
    {"normal", "#2e8b57", gusset::CurveKind::composite, gusset::SectionMethod::normal},
    {"symmedian", "#8a5fb0", gusset::CurveKind::composite, gusset::SectionMethod::symmedian},
    {"cubic spline", "#777777", gusset::CurveKind::cubic_c2, gusset::SectionMethod::bisector},
};

struct DrawnOutline {
    Style style;
    gusset::Curve curve;
    gusset_outline_report report;
    std::vector<gusset::Point3> polygon;
};

std::vector<Point> read_points(const std::string &path, const std::string &x, const std::string &y) {
    io::CSVReader<2> rows(path);
    rows.read_header(io::ignore_extra_column, x, y);
    std::vector<Point> points;
    for (Point p; rows.read_row(p[0], p[1]);) {
        points.push_back(p);
    }
    return points;
}

/// 12 points, closer together where the outline bends more.
std::vector<Point> outline_by_formula() {
    std::vector<Point> points;
    for (int i = 0; i < 12; ++i) {
        const double t = 2 * std::acos(-1.0) * (i + 0.45 * std::sin(2 * std::acos(-1.0) * i / 6)) / 12;
        const double c = std::cos(t), s = std::sin(t);
        const double r = 1 / std::pow(std::pow(std::abs(c), 2.6) + std::pow(std::abs(s), 2.6), 1 / 2.6);
        points.push_back({60 * r * c * (1 - 0.12 * s), 34 * r * s * (s < 0 ? 0.5 : 1.0) + 6 * c});
    }
    return points;
}

DrawnOutline draw(const Style &style, const std::vector<Point> &points, bool closed) {
    gusset::OutlineOptions options;
    options.curve = style.kind;
    options.method = style.method;
    const gusset::Outline outline(gusset::Outlines(points, closed), options);
    DrawnOutline drawn{style, outline.curve_copy(), outline.report(), {}};
    const gusset::OutlineCurve curve = outline.curve();
    for (std::size_t k = 0; k < curve.size(); ++k) {
        drawn.polygon.push_back(curve.segment(k)[1]);
    }
    return drawn;
}

/// The distance of `curve` from points along `reference`, at equal steps of its length.
std::vector<double> differences(const gusset::Curve &reference, const gusset::Curve &curve, int count) {
    const gusset::Places places = reference.sample(gusset::SampleRule::count, count);
    std::vector<gusset::Point3> queries(places.points().begin(), places.points().end());
    std::vector<double> found;
    for (const gusset_curve_nearest_point &nearest : curve.nearest(queries)) {
        found.push_back(nearest.distance);
    }
    return found;
}

void write(std::ostream &svg, const std::vector<Point> &points, const std::vector<DrawnOutline> &all, bool closed) {
    const double width = 900, margin = 40, graph = 180;
    gusset_curve_measures box = all[0].curve.measure(GUSSET_CURVE_MEASURE_BOUNDS);
    for (const DrawnOutline &drawn : all) {
        const gusset_curve_measures other = drawn.curve.measure(GUSSET_CURVE_MEASURE_BOUNDS);
        for (int k = 0; k < 2; ++k) {
            box.low[k] = std::min(box.low[k], other.low[k]);
            box.high[k] = std::max(box.high[k], other.high[k]);
        }
    }
    const double wide = box.high[0] - box.low[0], high = box.high[1] - box.low[1];
    const double scale = (width - 2 * margin) / std::max(wide, high);
    const double top = 2 * margin + scale * high, height = top + graph + 2.5 * margin;
    const auto px = [&](double x) { return margin + scale * (x - box.low[0]); };
    const auto py = [&](double y) { return margin + scale * (box.high[1] - y); };

    svg << std::setprecision(7) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' ' << height
        << "' font-family='sans-serif' font-size='14'>\n<rect width='100%' height='100%' fill='white'/>\n";
    // The control polygon of the first curve; then the curves, as the library writes them, y upwards.
    svg << "<polyline fill='none' stroke='#bbbbbb' stroke-dasharray='4 3' points='";
    for (const gusset::Point3 &p : all[0].polygon) {
        svg << px(p[0]) << ',' << py(p[1]) << ' ';
    }
    if (closed) {
        svg << px(all[0].polygon[0][0]) << ',' << py(all[0].polygon[0][1]);
    }
    svg << "'/>\n<g fill='none' stroke-width='" << 1.6 / scale << "' transform='matrix(" << scale << " 0 0 " << -scale << ' ' << px(0) << ' '
        << py(0) << ")'>\n";
    // The first one on top.
    for (auto drawn = all.rbegin(); drawn != all.rend(); ++drawn) {
        const gusset::CurveForm path = drawn->curve.exported(gusset::CurveFormat::svg);
        svg << "<path stroke='" << drawn->style.colour << "' d='" << path.text() << "'/>\n";
    }
    svg << "</g>\n";
    for (const gusset::Point3 &p : all[0].polygon) {
        svg << "<rect x='" << px(p[0]) - 2.5 << "' y='" << py(p[1]) - 2.5 << "' width='5' height='5' fill='#999999'/>\n";
    }
    for (const Point &p : points) {
        svg << "<circle cx='" << px(p[0]) << "' cy='" << py(p[1]) << "' r='3.5' fill='black'/>\n";
    }
    // How far the others are from the first one, along it.
    const int count = 400;
    const double size = std::max(wide, high);
    double largest = 0;
    std::vector<std::vector<double>> apart;
    for (std::size_t k = 1; k < all.size(); ++k) {
        apart.push_back(differences(all[0].curve, all[k].curve, count));
        largest = std::max(largest, *std::max_element(apart.back().begin(), apart.back().end()));
    }
    const double floor = top + graph + margin;
    svg << "<g fill='none' stroke-width='1.4'>\n";
    for (std::size_t k = 0; k < apart.size(); ++k) {
        svg << "<polyline stroke='" << all[k + 1].style.colour << "' points='";
        for (int i = 0; i < count; ++i) {
            svg << margin + (width - 2 * margin) * i / (count - 1) << ','
                << floor - (largest > 0 ? graph * apart[k][i] / largest : 0) << ' ';
        }
        svg << "'/>\n";
    }
    svg << "</g>\n<path stroke='black' d='M" << margin << ' ' << floor << 'H' << width - margin << "'/>\n";
    svg << "<text x='" << margin << "' y='" << top + margin - 12 << "'>distance from the bisector's curve along it, up to "
        << std::setprecision(2) << 100 * largest / size << " % of the size</text>\n";
    double x = margin;
    for (const DrawnOutline &drawn : all) {
        svg << "<text x='" << x << "' y='" << height - 14 << "' fill='" << drawn.style.colour << "'>" << drawn.style.name
            << "</text>\n";
        x += 24 + 8.0 * static_cast<double>(std::string(drawn.style.name).size());
    }
    svg << "</svg>\n";
}
} // namespace

int main(int argc, char **argv) try {
    CLI::App app("Draws smooth curves through the points of an outline, by each method.");
    std::string input = "-", output = "outline.svg", columns = "x,y";
    bool open = false;
    app.add_option("points", input, "a CSV file, or - for an outline by formula");
    app.add_option("drawing", output, "the SVG file to write");
    app.add_option("--columns", columns, "the names of the two columns");
    app.add_flag("--open", open, "the outline does not go back to its first point");
    CLI11_PARSE(app, argc, argv);

    const std::size_t comma = columns.find(',');
    const std::string x = columns.substr(0, comma), y = comma == std::string::npos ? "y" : columns.substr(comma + 1);
    const std::vector<Point> points = input == "-" ? outline_by_formula() : read_points(input, x, y);
    std::vector<DrawnOutline> all;
    for (const Style &style : styles) {
        all.push_back(draw(style, points, !open));
        const DrawnOutline &drawn = all.back();
        if (drawn.curve.segment_count() == 0) {
            throw std::runtime_error("too few points for a curve");
        }
        std::cout << style.name << ": " << drawn.curve.segment_count() << " segments, length " << drawn.curve.length()
                  << ", " << drawn.report.not_ok_count << " points with a status of their own, largest miss "
                  << drawn.report.max_residual << " of the size\n";
    }
    std::ofstream svg(output);
    write(svg, points, all, !open);
    if (!svg.flush()) {
        throw std::runtime_error("cannot write " + output);
    }
    return 0;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
