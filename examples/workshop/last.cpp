// Makes a shoe last from sections of a foot, roomier than the foot towards the toes, and flattens its upper.
//   last [sections.json] [--ease 0,8] [--picture last.svg] [--pattern pattern.svg] [--mesh last.off] [--page NAME]
// The file has "stations" from the heel to the toes, each with "points": x to the side, y up, z forward. Without one,
// or with -, the foot is made by formula. Lengths are in decimetres, volumes thus in litres.
#include "pattern.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {
using namespace workshop;

/// Closed sections one behind another; section k has the points offsets[k] to offsets[k + 1].
struct Sections {
    std::vector<Point3> points;
    std::vector<uint32_t> offsets{0};
    std::size_t size() const { return offsets.size() - 1; }
    std::vector<Point3> section(std::size_t k) const {
        return {points.begin() + offsets[k], points.begin() + offsets[k + 1]};
    }
    void end() { offsets.push_back(static_cast<uint32_t>(points.size())); }
};

Sections read_sections(const std::string &file) {
    std::ifstream in(file);
    const nlohmann::json all = nlohmann::json::parse(in);
    Sections made;
    for (const auto &station : all.at("stations")) {
        for (const std::array<double, 3> p : station.at("points")) {
            made.points.push_back({p[2], p[0], p[1]}); // forward, to the side, up
        }
        made.end();
    }
    return made;
}

/// A foot of 2.5 dm: each section with its own number of points and its own first one, as scans have them.
Sections foot_by_formula() {
    const auto step = [](double t, double from, double to) {
        const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
        return s * s * (3 - 2 * s);
    };
    Sections made;
    for (int k = 0; k < 17; ++k) {
        const double t = 0.5 - 0.5 * std::cos(3.141592653589793 * (k + 0.8) / 18.6);
        // Round at the heel and at the toes.
        const double heel = std::sqrt(1 - std::pow(1 - std::min(1.0, t / 0.16), 2));
        const double toes = std::sqrt(1 - std::pow(std::max(0.0, (t - 0.74) / 0.26), 2.5));
        const double half = (0.31 + 0.16 * step(t, 0.3, 0.7)) * heel * toes;
        const double top = (0.26 + 0.6 * (1 - step(t, 0.2, 0.78))) * heel * std::sqrt(toes);
        const double arch = 0.09 * step(t, 0.15, 0.4) * (1 - step(t, 0.5, 0.72));
        const uint32_t count = 40 + 7 * (k % 4), first = 11 * k % count;
        for (uint32_t i = 0; i < count; ++i) {
            const double angle = 6.283185307179586 * (i + first) / count, c = std::cos(angle), s = std::sin(angle);
            // Flat below, narrower above, and the big toe in front.
            const double up = s > 0 ? 0.16 * heel + (top - 0.16 * heel) * s : 0.16 * heel * (1 - std::pow(-s, 0.75));
            const double side = half * c * (1 - 0.25 * std::max(s, 0.0)) + 0.12 * step(t, 0.4, 1);
            made.points.push_back({2.5 * t, side, up + arch * (1 - c) / 2});
        }
        made.end();
    }
    return made;
}

/// A last has one box for all toes: where the girth falls by a third from one section to the next, single toes begin.
Sections without_toes(const Sections &foot) {
    const gusset::Outline drawn(gusset::Outlines(foot.points, true).offsets(foot.offsets));
    Sections made;
    for (std::size_t k = 0; k < foot.size(); ++k) {
        if (k > 1 && drawn.measure(k).length < 0.67 * drawn.measure(k - 1).length) {
            std::cout << "sections left out, of single toes: " << foot.size() - k << '\n';
            break;
        }
        const std::vector<Point3> section = foot.section(k);
        made.points.insert(made.points.end(), section.begin(), section.end());
        made.end();
    }
    return made;
}

/// The results of the workshop from sections, each made of the one before.
struct Last {
    gusset::Frame foot, frame;
    gusset::Sheet sheet;
    gusset::Net net;
    gusset::NetMesh side;
    double deviation;
    gusset::Fill closed;
};

Last make(const Sections &foot, const std::vector<double> &room, double tolerance) {
    //! [path]
    const gusset::Outlines outlines = gusset::Outlines(foot.points, true).offsets(foot.offsets);
    gusset::FrameOptions by_length;
    by_length.correspondence = gusset::CorrespondenceRule::arc_length;
    by_length.columns = 48;
    by_length.smooth_corners = true; // a foot has no edges
    gusset::Frame frame(outlines, by_length);
    gusset::Frame roomy = frame.offset(room, gusset::OffsetDirection::in_section);
    gusset::Sheet sheet = gusset::Sheet::from_frame(roomy, gusset::FrameSurface::curves);
    gusset::SheetMeshOptions fine;
    fine.tolerance = tolerance;
    gusset::SheetMesh side(sheet, fine);
    gusset::Net net = gusset::NetGrid(side.mesh()).net();
    gusset::NetMesh piece(net);
    gusset::FillOptions ends;
    ends.refine = gusset::FillRefinement::rim_density;
    ends.fairing = gusset::Fairing::thin_plate;
    ends.outward = gusset::Outward::closed;
    gusset::Fill closed(piece.mesh(), ends);
    //! [path]
    return {std::move(frame), std::move(roomy), std::move(sheet), std::move(net),
            std::move(piece), side.deviation(), std::move(closed)};
}

/// The volume between the first section and the last one, by the areas of many sections between: the midpoint rule.
double volume_by_sections(const gusset::Frame &frame, double from, double to) {
    const int count = 100;
    double sum = 0;
    for (int k = 0; k < count; ++k) {
        sum += frame.slice({from + (to - from) * (k + 0.5) / count, 0, 0}, {1, 0, 0}).measure().area;
    }
    return sum * (to - from) / count;
}

/// The line of the sheet under the foot, from the heel to the toes: the one that begins lowest at the heel. Places of
/// vertices tell which of them are on it.
std::vector<uint32_t> heel_line(const gusset::SheetMesh &mesh) {
    double lowest = INFINITY, line = 0;
    for (uint32_t v = 0; v < mesh.places().size(); ++v) {
        const gusset::SurfacePlace &at = mesh.places()[v];
        if (at.row == 0 && at.u == 0 && mesh.mesh().position(v)[2] < lowest) {
            lowest = mesh.mesh().position(v)[2];
            line = at.column + at.v;
        }
    }
    std::vector<std::pair<double, uint32_t>> found;
    for (uint32_t v = 0; v < mesh.places().size(); ++v) {
        const gusset::SurfacePlace &at = mesh.places()[v];
        if (at.column + at.v == line) {
            found.push_back({at.row + at.u, v});
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<uint32_t> vertices;
    for (const auto &[u, v] : found) {
        vertices.push_back(v);
    }
    return vertices;
}

/// The side laid out flat, without darts and with up to `darts`; the latter is returned.
gusset::Development lay_out(const Last &last, uint32_t darts, const std::string &file, Claims &claims) {
    const gusset::SheetMesh side(last.sheet); // a quad for each cell is fine enough for a pattern
    gusset::DevelopOptions options;
    options.cuts = heel_line(side);
    const gusset::Development plain(side.mesh(), options);
    options.max_darts = darts;
    gusset::Development flat(side.mesh(), options);
    print_chart("upper", plain);
    print_chart("upper", flat);
    for (const gusset::Development *made : {&plain, static_cast<const gusset::Development *>(&flat)}) {
        claims.hold(made->charts().size() == 1, "the upper is one piece");
        const gusset_chart &chart = made->charts()[0];
        claims.hold(chart.folds == 0 && chart.overlaps == 0, "the upper is flat without folds and overlaps");
        const double area = measure(side.mesh()).area;
        claims.hold(std::abs(percent(chart.area, area)) < 0.5, "the upper has the area of the side");
    }
    claims.hold(flat.charts()[0].energy <= plain.charts()[0].energy, "darts lower the distortion");
    if (!file.empty()) {
        Pattern(flat).write(file, "dm", 0.25);
    }
    return flat;
}

/// The upper on the ground under the last, heel below heel, redder where lengths change more.
void add_upper(page::Body &body, const gusset::Development &flat, const MeshView &on) {
    std::size_t heel = 0, toe = 0;
    double low = INFINITY;
    for (std::size_t v = 0; v < flat.points().size(); ++v) {
        const auto along = [&](std::size_t vertex) { return on.position(flat.vertex_map()[vertex])[0]; };
        heel = along(v) < along(heel) ? v : heel;
        toe = along(v) > along(toe) ? v : toe;
    }
    for (std::size_t v = 0; v < on.vertex_count(); ++v) {
        low = std::min(low, on.position(v)[2]);
    }
    const auto &from = flat.points()[heel], &to = flat.points()[toe];
    const double x = to[0] - from[0], y = to[1] - from[1], length = std::hypot(x, y);
    body.add(flat.mesh(), [](std::size_t) { return 2; });
    for (Point3 &p : body.points) {
        const double along = ((p[0] - from[0]) * x + (p[1] - from[1]) * y) / length;
        const double aside = ((p[1] - from[1]) * x - (p[0] - from[0]) * y) / length;
        p = {along, aside, low - 0.4};
    }
    for (std::size_t f = 0; f < flat.mesh().face_count(); ++f) {
        body.face_colours.push_back(stretch_colour(flat.stretches()[f], 0.25));
    }
}

/// The steps of the workshop for a page, and how far off each of them is.
page::Showcase show(const Last &last, const Sections &foot, const gusset::Development &flat, double by_sections) {
    const char *ochre = "#b98a2f", *blue = "#33597f";
    page::Showcase shown;
    shown.id = "last";
    shown.title = "A last";
    shown.text = "From sections of a foot to a closed last, roomier towards the toes, and the pattern of its upper.";
    shown.paints = {{"side", "#8fa3b3", 0, 0.42}, {"ends", "#d99a1c", 0.4, 0.35, true}, {"upper", "#dbcbad", 0, 0.6}};
    shown.eye = {0.75, -1, 0.55};
    shown.up = {0, 0, 1};
    shown.bodies.resize(5);
    for (std::size_t k = 0; k < foot.size(); ++k) {
        shown.bodies[0].curves.push_back(line(foot.section(k), true, ochre, 0.008));
    }
    const gusset_frame_view size = last.frame.view();
    const gusset::Points nodes = last.frame.nodes();
    for (std::size_t i = 0; i < size.rows; ++i) {
        const auto from = nodes.begin() + i * size.columns;
        shown.bodies[1].curves.push_back(line({from, from + size.columns}, true, blue, 0.008));
    }
    for (std::size_t j = 0; j < size.columns; j += 4) {
        std::vector<Point3> along;
        for (std::size_t i = 0; i < size.rows; ++i) {
            along.push_back(nodes[i * size.columns + j]);
        }
        shown.bodies[1].curves.push_back(line(std::move(along), false, blue, 0.008));
    }
    shown.bodies[2].add(last.side.mesh(), [](std::size_t) { return 0; });
    const std::size_t side = last.side.mesh().face_count();
    shown.bodies[3].add(last.closed.mesh(), [&](std::size_t f) { return f < side ? 0 : 1; });
    const gusset::SheetMesh developed(last.sheet);
    add_upper(shown.bodies[4], flat, developed.mesh());
    const gusset_chart &chart = flat.charts()[0];
    gusset::FillOptions outward;
    outward.outward = gusset::Outward::closed;
    const gusset::Fill ends(last.side.mesh(), outward);
    const double volume = measure(ends.mesh()).volume;
    shown.states = {
        {"Sections", 0, {}, said(foot.size(), " of them, each with its own number of points and its own first one.")},
        {"Frame", 1, {}, said(size.rows, " x ", size.columns, " nodes; curves across and along are ", size.max_gap,
                              " of its size apart where they should meet.")},
        {"Side", 2, {}, said("A mesh within ", last.deviation, " dm of the smooth surface; its area differs from that of the net by ",
                             percent(measure(last.side.mesh()).area, last.net.measure(gusset::NetMeasures::bilinear).bilinear_area), " %.")},
        {"Last", 3, {}, said(measure(last.closed.mesh()).volume, " l, closed and manifold; between flat ends its volume differs from that by the areas of 100 sections by ",
                             percent(volume, by_sections), " %.")},
        {"Upper", 4, {}, said("Cut along the heel line, ", flat.darts(), " darts: lengths change by factors of ", chart.min_stretch, " to ",
                              chart.max_stretch, "; ", chart.folds, " folds, ", chart.overlaps, " overlaps.")}};
    shown.pairs = {{3, 4}, {0, 3}, {1, 2}};
    return shown;
}

/// Sections, the frame, the closed last.
void draw(const Last &last, const Sections &foot, const std::string &file) {
    const double scale = 114;
    pictures::Drawing drawing(960, 310, {0.75, -1, 0.55}, scale);
    const Point3 centre = measure(last.closed.mesh()).centre;
    const auto place = [&](double x, const char *caption) {
        drawing.place(0, 0);
        const auto at = drawing.at(centre);
        drawing.place(x - at[0], 140 - at[1]);
        drawing.caption(x, 292, caption);
    };
    place(165, "sections of a foot");
    for (std::size_t k = 0; k < foot.size(); ++k) {
        drawing.curve(foot.section(k), true, pictures::ochre, 1.2, 0);
    }
    place(480, "the frame, roomier towards the toes");
    const gusset_frame_view size = last.frame.view();
    using Drawn = std::pair<const gusset::Frame *, pictures::Colour>;
    for (const auto &[frame, colour] : {Drawn(&last.foot, pictures::ochre), Drawn(&last.frame, pictures::blue)}) {
        for (std::size_t i = 0; i < size.rows; ++i) {
            const auto from = frame->nodes().begin() + i * size.columns;
            drawing.curve({from, from + size.columns}, true, colour, 0.8, 0);
        }
    }
    for (std::size_t j = 0; j < size.columns; j += 4) {
        std::vector<Point3> line;
        for (std::size_t i = 0; i < size.rows; ++i) {
            line.push_back(last.frame.nodes()[i * size.columns + j]);
        }
        drawing.curve(line, false, pictures::blue, 0.8, 0);
    }
    place(795, "the last: its side, and its filled ends");
    const std::size_t side = last.side.mesh().face_count();
    drawing.add("<g stroke-width='0.15'>\n");
    drawing.mesh(last.closed.mesh(), [&](std::size_t f) { return f < side ? pictures::blue : pictures::green; });
    drawing.add("</g>\n");
    save(drawing, file);
}
} // namespace

int main(int argc, char **argv) try {
    CLI::App app("Makes a shoe last from sections of a foot, and lays its upper out flat.");
    std::string input = "-", picture, pattern, file, page;
    std::vector<double> ease{0, 8};
    double tolerance = 0.01;
    uint32_t darts = 2;
    app.add_option("sections", input, "a JSON file of sections, or - for a foot by formula");
    app.add_option("--ease", ease, "by how much the girth grows at the heel and at the toes, in percent")
        ->delimiter(',')
        ->expected(2);
    app.add_option("--tolerance", tolerance, "how far the mesh may be from the smooth surface");
    app.add_option("--darts", darts, "how many darts the upper may have");
    app.add_option("--picture", picture, "an SVG file of the last");
    app.add_option("--pattern", pattern, "an SVG file of the upper");
    app.add_option("--mesh", file, "an OFF file of the last");
    app.add_option("--page", page, "its steps for scripts/page.py, NAME.json and NAME.bin");
    CLI11_PARSE(app, argc, argv);

    Claims claims;
    const Sections foot = without_toes(input == "-" ? foot_by_formula() : read_sections(input));
    const double heel = foot.points.front()[0], toes = foot.points.back()[0];
    // A curve of girth L that moves outwards by d in its plane gets the girth L + 2 pi d, whatever its shape (Steiner).
    const gusset::Outline drawn(gusset::Outlines(foot.points, true).offsets(foot.offsets));
    std::vector<double> grown, room;
    for (std::size_t k = 0; k < foot.size(); ++k) {
        const double t = (foot.points[foot.offsets[k]][0] - heel) / (toes - heel);
        grown.push_back(ease[0] + t * (ease[1] - ease[0]));
        room.push_back(grown.back() / 100 * drawn.measure(k).length / 6.283185307179586);
    }
    const Last bare = make(foot, std::vector<double>(foot.size()), tolerance), last = make(foot, room, tolerance);

    const gusset_frame_view frame = last.foot.view();
    std::cout << std::setprecision(4) << "frame: " << frame.rows << " x " << frame.columns << " nodes, curves apart by "
              << frame.max_gap << " of its size, turned by " << frame.max_twist << '\n';
    const double gap = std::max(frame.max_gap, last.frame.view().max_gap);
    claims.hold(gap < 1e-12, "curves across and along meet at the nodes");
    std::cout << "   at    girth  of last     more  wanted     area  of last\n" << std::fixed;
    for (std::size_t k = 0; k < foot.size(); ++k) {
        const Point3 at = foot.points[foot.offsets[k]];
        const gusset_curve_measures before = bare.frame.slice(at, {1, 0, 0}).measure();
        const gusset_curve_measures after = last.frame.slice(at, {1, 0, 0}).measure();
        const double more = percent(after.length, before.length);
        std::cout << std::setprecision(2) << std::setw(5) << at[0] << std::setprecision(4) << std::setw(9)
                  << before.length << std::setw(9) << after.length << std::setprecision(2) << std::setw(7) << more
                  << " %" << std::setw(6) << grown[k] << " %" << std::setprecision(4) << std::setw(9) << before.area
                  << std::setw(9) << after.area << '\n';
        claims.hold(std::abs(more - grown[k]) < 1.5, "the girth grows by what is wanted, within 1.5 %");
    }
    std::cout << std::defaultfloat << std::setprecision(4);
    for (const auto &[what, made] : {std::pair("foot", &bare), std::pair("last", &last)}) {
        const MeshView side = made->side.mesh(), closed = made->closed.mesh();
        gusset::FillOptions outward;
        outward.outward = gusset::Outward::closed;
        const gusset::Fill flat(side, outward);
        const double volume = measure(flat.mesh()).volume;
        const double sections = volume_by_sections(made->frame, heel, toes);
        const Measure whole = measure(closed);
        const double area = made->net.measure(gusset::NetMeasures::bilinear).bilinear_area;
        std::cout << what << ": net of " << made->net.rows() << " x " << made->net.columns() << " nodes, mesh within "
                  << made->deviation << " dm of the sheet; side " << measure(side).area << " dm2, of the net "
                  << area << " dm2; " << volume << " l between flat ends, by sections " << sections
                  << " l (" << percent(volume, sections) << " %); closed " << closed.face_count() << " faces, "
                  << whole.area << " dm2, " << whole.volume << " l\n";
        claims.closed(closed, what);
        claims.hold(std::abs(percent(measure(side).area, area)) < 0.1, "net and mesh have one area");
        claims.hold(made->deviation <= tolerance, "the mesh is within its tolerance");
        claims.hold(whole.volume > 0, "the mesh is outward");
        claims.hold(std::abs(percent(volume, sections)) < 1, "volumes agree within a percent");
    }
    const bool roomier = measure(last.closed.mesh()).volume > measure(bare.closed.mesh()).volume;
    claims.hold(roomier || ease[0] + ease[1] <= 0, "the last is roomier than the foot");
    const gusset::Development flat = lay_out(last, darts, pattern, claims);
    if (!picture.empty()) {
        draw(last, foot, picture);
    }
    save(last.closed.mesh(), file);
    save(show(last, foot, flat, volume_by_sections(last.frame, heel, toes)), page);
    return claims.status();
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
