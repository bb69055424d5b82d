// Writes the showcases of docs/showcases.html that are made of the shapes of docs/pictures.md: gallery.json and gallery.bin.
//   showcases FOLDER/gallery
#include "shapes.hpp"

#include "../page/showcase.hpp"

#include <iostream>

namespace {
using namespace pictures;

const page::Paint ivory{"ivory", "#dbcbad", 0, 0.42}, slate{"slate", "#8fa3b3", 0, 0.42}, clay{"clay", "#b5744f", 0, 0.5},
    moss{"moss", "#7d8c5c", 0, 0.5}, gold{"joint", "#d99a1c", 0.4, 0.35, true};

std::string text(double value) {
    std::ostringstream out;
    out.precision(2);
    out << value;
    return out.str();
}

page::Showcase titled(const char *id, const char *title, std::vector<page::Paint> paints, const Point3 &eye) {
    page::Showcase show;
    show.id = id;
    show.title = title;
    show.paints = std::move(paints);
    show.eye = eye;
    show.up = {0, 0, 1};
    return show;
}

/// Two shells, joined without new vertices and with them.
page::Showcase stitched() {
    const Mesh upper = shell(56, 10, 1, 0.25), lower = shell(41, 8, -1, 0.25);
    page::Showcase show = titled("stitch", "Two shells", {ivory, slate, gold}, {0.4, -1, 0.42});
    show.pairs = {{0, 2}, {1, 2}};
    gusset::StitchOptions least;
    least.meridians = gusset::Meridians::min_area;
    for (const gusset::StitchOptions &options : {least, blend()}) {
        const gusset::Stitch stitch = gusset::stitch(upper.view(), lower.view(), options);
        const std::size_t first = upper.view().face_count(), strip = stitch.strip_faces().first;
        show.bodies.emplace_back().add(stitch.mesh(), [&](std::size_t f) { return f >= strip ? 2 : f < first ? 0 : 1; });
    }
    show.states = {{"Two open meshes", 0, {2}}, {"The strip of least area", 0}, {"Faired rows", 1}};
    show.text = "The rims have 56 and 41 vertices. The strip of least area needs no new ones; a blend keeps the slopes of the shells.";
    return show;
}

/// Four pieces of a shell, assembled.
page::Showcase assembled() {
    const std::vector<Mesh> pieces = quarters();
    page::Showcase show = titled("pieces", "Four pieces", {ivory, slate, clay, moss, gold}, {0.5, -1, 0.9});
    show.pairs = {{0, 1}};
    show.bodies.resize(2);
    std::vector<gusset::MeshView> views;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        views.push_back(pieces[k].view());
        show.bodies[0].add(views.back(), [&](std::size_t) { return k; });
    }
    const gusset::Join assembly(views, assembly_of_quarters());
    std::vector<uint8_t> paint(assembly.mesh().face_count(), 4);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const gusset_indices faces = assembly.pieces()[k].faces;
        for (const uint32_t f : gusset::Indices(faces.data, faces.count)) {
            paint[f] = static_cast<uint8_t>(k);
        }
    }
    show.bodies[1].add(assembly.mesh(), [&](std::size_t f) { return paint[f]; });
    show.states = {{"Pieces", 0}, {"Assembled", 1}};
    show.text = "The facing arcs of the four rims are found and joined by strips, the hole where all four meet is filled, and the outer rim stays open.";
    return show;
}

/// A ball with holes, filled flat and fair; beside them the ball.
page::Showcase filled() {
    const Mesh torn = torn_ball();
    page::Showcase show = titled("holes", "Three holes", {ivory, gold}, {0.25, -1, 0.42});
    show.pairs = {{0, 2}, {1, 2}};
    show.near_centre = {0.37, -0.82, 0.45};
    show.near_eye = {0.45, -1, 0.55};
    show.near_radius = 0.5;
    show.bodies.resize(1);
    show.bodies[0].add(torn.view(), [](std::size_t) { return 0; });
    for (const gusset::Loop rim : gusset::Boundary(torn.view())) {
        page::Curve curve{{}, true, "#b0402a", 0.012};
        for (const uint32_t v : rim.vertices) {
            curve.points.push_back(torn.points[v]);
        }
        show.bodies[0].curves.push_back(curve);
    }
    double largest = 0;
    for (const bool is_fair : {false, true}) {
        const gusset::Fill fill(torn.view(), is_fair ? faired_patch() : gusset::FillOptions());
        const std::size_t old = torn.corners.size() / 3;
        page::Body &body = show.bodies.emplace_back();
        body.add(fill.mesh(), [&](std::size_t f) { return f < old ? 0 : 1; });
        // The other one lacks new vertices to measure.
        for (std::size_t v = 0; is_fair && v < body.points.size(); ++v) {
            body.distances.push_back(std::abs(std::sqrt(dot(body.points[v], body.points[v])) - 1));
            largest = std::max(largest, body.distances.back());
        }
    }
    show.distance_limit = largest;
    show.distance_shown = 100 * largest;
    show.distance_unit = "% of the radius";
    show.states = {{"Boundary loops", 0}, {"Least weight", 1}, {"Refined and fair", 2}};
    show.text = "Holes in a ball of radius 1. No new vertex of the refined and fair patches is farther than " + text(100 * largest) +
                " % of the radius from it.";
    return show;
}

/// A tube through waves, and the curves on them.
page::Showcase met() {
    const gusset::Sheet pipe = tube(), sea = waves();
    const gusset::Surface a(pipe), b(sea);
    page::Showcase show = titled("meet", "Two surfaces", {clay, slate}, {0.55, -1, 0.75});
    show.pairs = {{0, 1}};
    show.bodies.resize(1);
    gusset::SheetMeshOptions fine;
    fine.min_u = fine.min_v = 4;
    uint8_t paint = 0;
    for (const gusset::Sheet *sheet : {&pipe, &sea}) {
        const gusset::SheetMesh mesh(*sheet, fine);
        show.bodies[0].add(mesh.mesh(), [&](std::size_t) { return paint; });
        ++paint;
    }
    show.bodies.push_back(show.bodies[0]);
    const auto draw = [&](const gusset::SurfacePaths &paths, const char *colour, double radius) {
        for (const gusset::SurfacePath &path : paths) {
            show.bodies[1].curves.push_back({{path.points.begin(), path.points.end()}, path.closed, colour, radius});
        }
    };
    const std::vector<double> heights{-1.0, -0.75, -0.5, 0.5, 0.75, 1.0};
    draw(a.sections({0, 0, 0}, {0, 0, 1}, heights), "#3b2a1c", 0.006);
    draw(a.intersect(b), "#f0b429", 0.016);
    show.states = {{"Two surfaces", 0}, {"Sections and intersection", 1}};
    show.text = "Plane sections of a smooth tube, and the curve in which it meets a wavy surface: of the smooth surfaces, not of the quads that are drawn.";
    return show;
}
} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::cerr << "usage: showcases FOLDER/NAME\n";
        return 2;
    }
    try {
        page::write(argv[1], {stitched(), assembled(), filled(), met()});
        return 0;
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
    }
    return 1;
}
