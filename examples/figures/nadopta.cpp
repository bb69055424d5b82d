// Nadopta, "Theoretical foundations of the identification of outline curves": figures 1 to 3.
#include "figure.hpp"

namespace figures {
namespace {
using gusset::Curve;
using gusset::SectionMethod;

using Plane = std::array<double, 2>;
const std::array<uint32_t, 2> one_quadratic{0, 2};

struct Method {
    const char *name, *letter;
    SectionMethod method;
    Colour colour;
};
const std::array<Method, 3> methods{{{"normal", "N", SectionMethod::normal, green},
                                     {"bisector", "B", SectionMethod::bisector, red},
                                     {"median", "M", SectionMethod::median, blue}}};

std::vector<Spot> drawn(const Curve &curve, const std::function<Spot(const Point3 &)> &spot) {
    const auto samples = curve.sample(gusset::SampleRule::count, 80);
    std::vector<Spot> spots;
    for (const Point3 &p : samples.points()) {
        spots.push_back(spot(p));
    }
    return spots;
}

/// Fig. 1: quadratics of different control points and parameters that pass the same point.
std::string one_point(const std::string &file) {
    const std::vector<Plane> points{{0, 0}, {2.6, 1.6}, {9, 0.4}};
    Figure figure(960, 420);
    const auto spot = [](double x, double y) { return Spot{110 + 80 * x, 370 - 76 * y}; };
    const auto at = [&](const Point3 &p) { return spot(p[0], p[1]); };
    figure.line({spot(points[0][0], points[0][1]), spot(points[2][0], points[2][1])}, {faint, 1.5, "6 4"});
    std::string text;
    double off = 0;
    std::vector<std::pair<Method, double>> styles;
    for (const Method &method : methods) {
        styles.push_back({method, 0.5});
    }
    // Each method is a rule for the parameter; with the parameter the control point is had.
    styles.push_back({{"symmedian", "Y", SectionMethod::symmedian, violet}, 0.5});
    styles.push_back({{"alpha", "A", SectionMethod::alpha, ochre}, 0.25});
    for (std::size_t k = 0; k < styles.size(); ++k) {
        const auto &[style, alpha] = styles[k];
        gusset::OutlineOptions options;
        options.method = style.method;
        if (style.method == SectionMethod::alpha) {
            options.alpha = alpha;
        }
        const gusset::Sections sections(gusset::Outlines(points, false), options);
        const Point3 control = sections.controls()[1];
        const double t = sections.parameters()[1];
        const std::vector<Plane> quadratic{points[0], {control[0], control[1]}, points[2]};
        const Curve curve = Curve::from_controls(quadratic, one_quadratic, false);
        const Point3 given{points[1][0], points[1][1], 0};
        off = std::max(off, curve.nearest({&given, 1})[0].distance);
        figure.line({spot(points[0][0], points[0][1]), at(control), spot(points[2][0], points[2][1])},
                    {style.colour, 0.8, "3 4"});
        figure.line(drawn(curve, at), {style.colour, 2.2, ""});
        figure.dot(at(control), 4.5, paper, style.colour, 1.8);
        const std::string name = style.method == SectionMethod::alpha ? "alpha 0.25" : style.name;
        text += (k == 0 ? "t by " : ", ") + name + " " + places(t, 3);
        const double y = 50 + 26 * static_cast<double>(k);
        figure.line({{690, y - 5}, {720, y - 5}}, {style.colour, 2.5, ""});
        figure.label({732, y}, name + ", t = " + places(t, 3), "start", 15);
    }
    const std::array<std::tuple<const char *, double, double>, 3> names{
        {{"P_i-1", -30, 6}, {"P_i", -20, -8}, {"P_i+1", 30, 6}}};
    for (std::size_t k = 0; k < 3; ++k) {
        const Spot s = spot(points[k][0], points[k][1]);
        figure.dot(s, 5, ink);
        figure.label({s[0] + std::get<1>(names[k]), s[1] + std::get<2>(names[k])}, std::get<0>(names[k]), "middle", 17);
    }
    figure.save(file);
    return text + "; off the point " + (off < 1e-12 ? "less than 1e-12" : places(off, 9));
}

/// Where the guide of a control point, the line through it and its point, meets the chord.
Plane foot(const Plane &from, const Plane &to, const Plane &point, const Point3 &control) {
    const double gx = control[0] - point[0], gy = control[1] - point[1], cx = to[0] - from[0], cy = to[1] - from[1];
    const double t = ((point[0] - from[0]) * gy - (point[1] - from[1]) * gx) / (cx * gy - cy * gx);
    return {from[0] + t * cx, from[1] + t * cy};
}

/// Fig. 2: chords, guides by three methods with their feet; control points cycle by cycle by the paper's stepping.
std::string chords(const std::string &file) {
    const std::vector<Plane> points{{0, 0}, {1, 3}, {7.2, 3.4}, {9, 0.3}};
    Figure figure(960, 400);
    std::string text;
    const auto left = [](double x, double y) { return Spot{105 + 37 * x, 290 - 41 * y}; };
    const auto right = [](double x, double y) { return Spot{540 + 42 * x, 290 - 41 * y}; };
    const auto of = [](const auto &spot, const Plane &p) { return spot(p[0], p[1]); };
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        figure.line({of(left, points[k]), of(left, points[k + 1])}, {faint, 1.2, ""});
    }
    figure.line({of(left, points[0]), of(left, points[2])}, {ink, 1.4, ""});
    figure.line({of(left, points[1]), of(left, points[3])}, {ink, 1.4, ""});
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const Method &method = methods[m];
        gusset::OutlineOptions options;
        options.method = method.method;
        const gusset::Sections sections(gusset::Outlines(points, false), options);
        text += (text.empty() ? "feet " : ", ") + std::string(method.name);
        for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
            const Point3 control = sections.controls()[k];
            const Plane at = foot(points[k - 1], points[k + 1], points[k], control);
            text += " (" + places(at[0], 2) + ", " + places(at[1], 2) + ")";
            figure.line({of(left, at), left(control[0], control[1])}, {method.colour, 1.8, ""});
            figure.dot(of(left, at), 3.5, method.colour, method.colour);
            figure.dot(left(control[0], control[1]), 4, paper, method.colour, 1.8);
            figure.label({of(left, at)[0] + (k == 1   ? 5
                                             : m == 0 ? 4
                                                      : -8),
                          of(left, at)[1] + 20},
                         std::string("S_") + method.letter, "middle", 12, method.colour);
        }
        const double y = 340;
        figure.line({{85 + 130 * static_cast<double>(m), y - 5}, {110 + 130 * static_cast<double>(m), y - 5}},
                    {method.colour, 2.2, ""});
        figure.label({117 + 130 * static_cast<double>(m), y}, method.name, "start", 14);
    }
    // Control points of one cubic through all points, after this many cycles.
    gusset::OutlineOptions options;
    options.curve = gusset::CurveKind::single;
    options.method = SectionMethod::normal;
    options.lock = gusset::ParameterLock::data_guide;
    options.solver = gusset::OutlineSolver::step;
    options.history = true;
    const gusset::Outline whole(gusset::Outlines(points, false), options);
    const gusset_outline_history history = whole.history();
    std::vector<double> moves;
    std::vector<std::vector<Spot>> cycles(1);
    for (const Plane &p : points) {
        cycles[0].push_back(of(right, p));
    }
    std::string places_of_first;
    for (std::size_t k = 0, c = 0; k < history.cycle_count; ++k) {
        moves.push_back(history.cycles[k].moved);
        cycles.emplace_back();
        for (; c < history.cycles[k].control_end; ++c) {
            const double *p = history.controls + 3 * c;
            cycles.back().push_back(right(p[0], p[1]));
            places_of_first += k == 0 ? " (" + places(p[0], 2) + ", " + places(p[1], 2) + ")" : "";
        }
    }
    for (std::size_t k = 0; k < cycles.size(); ++k) {
        const bool last = k + 1 == cycles.size();
        figure.line(cycles[k], {last ? green : faint, last ? 1.6 : 1.2, last ? "" : "4 4"});
    }
    figure.line(drawn(whole.curve_copy(), [&](const Point3 &p) { return right(p[0], p[1]); }), {ink, 2.4, ""});
    for (std::size_t k = 1; k < cycles.size(); ++k) {
        for (const std::size_t c : {std::size_t{1}, std::size_t{2}}) {
            figure.dot(cycles[k][c], 3.5, paper, green, 1.5);
        }
    }
    for (const auto &spot : {std::function<Spot(double, double)>(left), std::function<Spot(double, double)>(right)}) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Spot at = spot(points[k][0], points[k][1]);
            figure.dot(at, 4.5, ink);
            figure.label({at[0] + (k < 2 ? -20 : 20), at[1] + 8}, "B_" + std::to_string(k), "middle", 15);
        }
    }
    figure.label({262, 382}, "chords, guides, feet, and control points");
    figure.label({730, 382}, "control points by cycles (normal), and the curve");
    figure.save(file);
    text += "; control points after cycle 1" + places_of_first + "; moves of cycles";
    for (std::size_t k = 0; k < std::min<std::size_t>(moves.size(), 5); ++k) {
        text += " " + places(moves[k], 6);
    }
    return text + " of " + std::to_string(moves.size()) + " cycles, " + std::to_string(whole.report().steps) + " steps";
}

/// Fig. 3: the weights of the three control points of a quadratic, as heights of curves: 1 there and 0 elsewhere.
std::string weights(const std::string &file) {
    Figure figure(960, 400);
    const auto spot = [](double t, double j) { return Spot{110 + 480 * t, 345 - 300 * j}; };
    for (int k = 0; k <= 4; ++k) {
        const double x = 0.25 * k;
        figure.line({spot(x, 0), spot(x, 1)}, {faint, 1, ""});
        figure.line({spot(0, x), spot(1, x)}, {faint, 1, ""});
        figure.label({spot(x, 0)[0], 366}, places(x, 2), "middle", 12);
        figure.label({98, spot(0, x)[1] + 4}, places(x, 2), "end", 12);
    }
    const std::array<Colour, 3> colours{blue, red, green};
    // By the subscripts of the paper, which number the control points of the whole outline.
    const std::array<const char *, 3> names{"J_n,i-1 = (1 - t)²", "J_n,i = 2 t (1 - t)", "J_n,i+1 = t²"},
        points{"previous base point P_i-1", "control point B_i", "next base point P_i+1"};
    constexpr int steps = 64;
    std::vector<double> sum(steps + 1);
    std::string text = "at t = 0.5";
    for (std::size_t k = 0; k < 3; ++k) {
        // x is the parameter itself.
        std::vector<Plane> controls{{0, 0}, {0.5, 0}, {1, 0}};
        controls[k][1] = 1;
        const Curve curve = Curve::from_controls(controls, one_quadratic, false);
        std::vector<Spot> line;
        for (int step = 0; step <= steps; ++step) {
            const Point3 p = curve.point(gusset::place(0, static_cast<double>(step) / steps));
            line.push_back(spot(p[0], p[1]));
            sum[static_cast<std::size_t>(step)] += p[1];
        }
        figure.line(line, {colours[k], 2.6, ""});
        text += " " + places(curve.point(gusset::place(0, 0.5))[1], 2);
        const double y = 110 + 60 * static_cast<double>(k);
        figure.line({{650, y - 5}, {680, y - 5}}, {colours[k], 2.6, ""});
        figure.label({692, y}, names[k], "start", 16);
        figure.label({692, y + 22}, "weight of the " + std::string(points[k]), "start", 13);
    }
    const auto [low, high] = std::minmax_element(sum.begin(), sum.end());
    figure.label({spot(0.5, 0)[0], 390}, "t", "middle", 16);
    figure.label({50, 200}, "J", "middle", 16);
    figure.save(file);
    return text + "; their sum is from " + places(*low, 12) + " to " + places(*high, 12);
}
} // namespace

std::vector<Entry> nadopta() { return {{"nadopta_1", one_point}, {"nadopta_2", chords}, {"nadopta_3", weights}}; }
} // namespace figures
