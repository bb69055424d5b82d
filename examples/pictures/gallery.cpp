// Draws the pictures of docs/pictures.md that no other example draws: stitch.svg, pieces.svg, fill.svg and meet.svg.
//   gallery FOLDER
#include "drawing.hpp"

#include <iostream>

namespace {
using namespace pictures;

struct Mesh {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;
    gusset::MeshView view() const { return gusset::MeshView::triangles(points, corners); }
};

/// Part of a sphere from its pole down to a wavy rim; `up` is 1, or -1 for the lower one.
Mesh shell(uint32_t sides, uint32_t rings, double up, double gap) {
    const double turn = 6.283185307179586;
    Mesh mesh{{{0, 0, up * (1 + gap)}}, {}};
    for (uint32_t ring = 1; ring <= rings; ++ring) {
        for (uint32_t i = 0; i < sides; ++i) {
            const double longitude = up * turn * i / sides;
            const double rim = 1.38 + 0.1 * std::sin(5 * longitude) + 0.02 * (i % 3), polar = rim * ring / rings;
            mesh.points.push_back({std::sin(polar) * std::cos(longitude), std::sin(polar) * std::sin(longitude), up * (gap + std::cos(polar))});
        }
    }
    for (uint32_t i = 0; i < sides; ++i) {
        mesh.corners.insert(mesh.corners.end(), {0, 1 + i, 1 + (i + 1) % sides});
        for (uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const uint32_t a = 1 + ring * sides + i, b = 1 + ring * sides + (i + 1) % sides;
            mesh.corners.insert(mesh.corners.end(), {a, a + sides, b + sides, a, b + sides, b});
        }
    }
    return mesh;
}

/// Two shells; a strip without new vertices; rows of new ones, faired.
bool stitched(const std::string &file) {
    const Mesh upper = shell(56, 10, 1, 0.25), lower = shell(41, 8, -1, 0.25);
    Drawing drawing(960, 380, {0.4, -1, 0.42}, 118);
    drawing.place(165, 178);
    drawing.mesh(upper.view(), [](std::size_t) { return blue; });
    drawing.mesh(lower.view(), [](std::size_t) { return ochre; });
    drawing.caption(165, 368, "two open meshes");

    gusset::StitchOptions faired;
    faired.rows = gusset::StripRows::mean_edge();
    faired.fairing = gusset::Fairing::thin_plate;
    faired.meridians = gusset::Meridians::quad;
    double x = 480;
    for (const auto &[options, what] : {std::pair(gusset::StitchOptions(), "the strip of least area"), std::pair(faired, "rows of new vertices, fair")}) {
        const gusset::Stitch stitch = gusset::stitch(upper.view(), lower.view(), options);
        const std::size_t first = upper.view().face_count(), strip = stitch.strip_faces().first;
        drawing.place(x, 178);
        drawing.mesh(stitch.mesh(), [&](std::size_t f) { return f >= strip ? green : f < first ? blue : ochre; });
        drawing.caption(x, 368, what);
        x += 315;
    }
    return drawing.write(file);
}

/// A shell broken into four, moved apart and each with a rim of its own; assembled.
bool assembled(const std::string &file) {
    const Mesh whole = shell(48, 14, 1, 0);
    std::vector<Mesh> pieces(4);
    for (std::size_t piece = 0; piece < 4; ++piece) {
        const double angle = 1.5707963267948966 * (static_cast<double>(piece) + 0.5);
        pieces[piece].points = whole.points;
        for (Point3 &p : pieces[piece].points) {
            p[0] += 0.1 * std::cos(angle), p[1] += 0.1 * std::sin(angle);
        }
    }
    for (std::size_t f = 0; f < whole.corners.size() / 3; ++f) {
        Point3 middle{};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                middle[axis] += whole.points[whole.corners[3 * f + k]][axis] / 3;
            }
        }
        const std::size_t piece = (middle[1] >= 0 ? 0 : 2) + ((middle[0] >= 0) == (middle[1] >= 0) ? 0 : 1);
        const uint32_t *face = &whole.corners[3 * f];
        pieces[piece].corners.insert(pieces[piece].corners.end(), face, face + 3);
    }
    const std::array<Colour, 4> colours{blue, ochre, red, grey};
    Drawing drawing(960, 330, {0.5, -1, 0.9}, 165);
    std::vector<gusset::MeshView> views;
    drawing.place(250, 190);
    for (std::size_t k = 0; k < 4; ++k) {
        views.push_back(pieces[k].view());
        drawing.mesh(views.back(), [&](std::size_t) { return colours[k]; });
    }
    drawing.caption(250, 318, "four pieces");
    gusset::AssemblyOptions options;
    options.max_gap = 0.3;
    options.strips.rows = gusset::StripRows::mean_edge();
    options.fill = gusset::FillOptions();
    options.fill->keep_longest = true; // the rim of the whole is no hole
    const gusset::Assembly assembly(views, options);
    std::vector<Colour> colour(assembly.mesh().face_count(), green);
    for (std::size_t k = 0; k < 4; ++k) {
        const gusset_indices faces = assembly.pieces()[k].faces;
        for (const uint32_t f : gusset::Indices(faces.data, faces.count)) {
            colour[f] = colours[k];
        }
    }
    drawing.place(710, 190);
    drawing.mesh(assembly.mesh(), [&](std::size_t f) { return colour[f]; });
    drawing.caption(710, 318, "assembled");
    return drawing.write(file);
}

/// A ball with holes, whose rims are found, and filled: flat, and refined and fair.
bool filled(const std::string &file) {
    const gusset::NetMesh ball(gusset::Net::from_primitive(gusset::Primitive::box({1, 1, 1}, {14, 14, 14})));
    Mesh torn;
    for (std::size_t v = 0; v < ball.mesh().vertex_count(); ++v) {
        torn.points.push_back(unit(ball.mesh().position(v)));
    }
    const std::array<Point3, 3> holes{unit({0.45, -1, 0.55}), unit({-0.75, -0.8, -0.1}), unit({0.1, -0.3, 1})};
    for (std::size_t f = 0; f < ball.mesh().face_count(); ++f) {
        const gusset::Indices quad = ball.mesh().face(f);
        const Point3 &at = torn.points[quad[0]];
        const auto in = [&](const Point3 &hole) { return dot(at, hole) > 0.93 + 0.02 * std::sin(9 * at[0] + 7 * at[2]); };
        if (std::none_of(holes.begin(), holes.end(), in)) {
            torn.corners.insert(torn.corners.end(), {quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]});
        }
    }
    Drawing drawing(960, 350, {0.25, -1, 0.42}, 140);
    drawing.place(165, 160);
    drawing.mesh(torn.view(), [](std::size_t) { return blue; });
    const gusset::Boundary rims(torn.view());
    for (const gusset::Loop rim : rims) {
        std::vector<Point3> points;
        for (const uint32_t v : rim.vertices) {
            points.push_back(torn.points[v]);
        }
        drawing.curve(points, true, red, 3, 0.05);
    }
    drawing.caption(165, 338, "boundary loops");
    gusset::FillOptions fair;
    fair.refine = gusset::FillRefinement::rim_density;
    fair.fairing = gusset::Fairing::thin_plate;
    double x = 480;
    for (const auto &[options, what] : {std::pair(gusset::FillOptions(), "least weight"), std::pair(fair, "refined, fair")}) {
        const gusset::Fill fill(torn.view(), options);
        const std::size_t old = torn.corners.size() / 3;
        drawing.place(x, 160);
        drawing.mesh(fill.mesh(), [&](std::size_t f) { return f < old ? blue : green; });
        drawing.caption(x, 338, what);
        x += 315;
    }
    return drawing.write(file);
}

/// A tube through a wavy surface: where they meet, sections, and nearest points.
bool met(const std::string &file) {
    std::vector<Point3> tube, waves;
    for (int i = 0; i <= 14; ++i) {
        for (int j = 0; j <= 24; ++j) {
            const double angle = -6.283185307179586 * (j % 24) / 24.0, radius = 0.5 + 0.12 * std::sin(0.7 * i);
            tube.push_back({radius * std::cos(angle), radius * std::sin(angle) + 0.2 * std::sin(0.35 * i), 0.18 * i - 1.15});
        }
    }
    for (int i = 0; i <= 20; ++i) {
        for (int j = 0; j <= 20; ++j) {
            const double x = 0.18 * (i - 10), y = 0.18 * (j - 10);
            waves.push_back({x, y, 0.22 * std::sin(2.2 * x) * std::cos(1.8 * y)});
        }
    }
    gusset::SheetOptions round;
    round.closed_v = true;
    const gusset::Sheet pipe = gusset::Sheet::from_nodes(15, 25, tube, round), sea = gusset::Sheet::from_nodes(21, 21, waves);
    const gusset::Surface a(pipe), b(sea);
    Drawing drawing(960, 470, {0.55, -1, 0.75}, 150);
    drawing.place(480, 215);
    for (const auto &[sheet, colour] : {std::pair(&pipe, ochre), std::pair(&sea, blue)}) {
        gusset::SheetMeshOptions options;
        options.min_u = options.min_v = 2;
        const gusset::SheetMesh mesh(*sheet, options);
        drawing.mesh(mesh.mesh(), [&, paint = colour](std::size_t) { return paint; });
    }
    const auto draw = [&](const gusset::SurfacePaths &paths, const Colour &colour, double width) {
        for (const gusset::SurfacePath &path : paths) {
            drawing.curve(std::vector<Point3>(path.points.begin(), path.points.end()), path.closed, colour, width, 0.06);
        }
    };
    const std::vector<double> heights{-1.0, -0.75, -0.5, 0.5, 0.75, 1.0};
    draw(a.sections({0, 0, 0}, {0, 0, 1}, heights), {90, 60, 20}, 1.2);
    draw(a.silhouette({0.55, -1, 0.75}), {90, 60, 20}, 2.4);
    draw(a.intersect(b), red, 4);
    drawing.caption(480, 458, "sections, a silhouette, and where two surfaces meet");
    return drawing.write(file);
}
} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::cerr << "usage: gallery FOLDER\n";
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    try {
        if (stitched(folder + "stitch.svg") && assembled(folder + "pieces.svg") && filled(folder + "fill.svg") && met(folder + "meet.svg")) {
            std::cout << "stitch.svg pieces.svg fill.svg meet.svg\n";
            return 0;
        }
        std::cerr << "cannot write into " << folder << '\n';
    } catch (const gusset::Error &error) {
        std::cerr << error.what() << " (status " << error.status() << ")\n";
    }
    return 1;
}
