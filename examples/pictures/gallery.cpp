// Draws the pictures of docs/pictures.md that no other example draws: stitch.svg, texture.svg, pieces.svg, fill.svg,
// sections.svg and meet.svg.
//   gallery FOLDER
#include "shapes.hpp"
#include "views.hpp"

#include <iostream>

namespace {
using namespace pictures;

/// Two shells; a strip without new vertices; a blend.
bool stitched(const std::string &file) {
    const Mesh upper = shell(56, 10, 1, 0.25), lower = shell(41, 8, -1, 0.25);
    Drawing drawing(960, 380, {0.4, -1, 0.42}, 118);
    drawing.place(165, 178);
    drawing.mesh(upper.view(), [](std::size_t) { return blue; });
    drawing.mesh(lower.view(), [](std::size_t) { return ochre; });
    drawing.caption(165, 368, "two open meshes");

    double x = 480;
    gusset::StitchOptions least;
    least.meridians = gusset::Meridians::min_area;
    for (const auto &[options, what] : {std::pair(least, "the strip of least area"), std::pair(blend(), "a blend")}) {
        const gusset::Stitch stitch = gusset::stitch(upper.view(), lower.view(), options);
        const std::size_t first = upper.view().face_count(), strip = stitch.strip_faces().first;
        drawing.place(x, 178);
        drawing.mesh(stitch.mesh(), [&](std::size_t f) { return f >= strip ? green : f < first ? blue : ochre; });
        drawing.caption(x, 368, what);
        x += 315;
    }
    return drawing.write(file);
}

/// Two textured shells; joined, where both are on one chart, and where they are not.
bool textured(const std::string &file) {
    const Mesh upper = shell(36, 8, 1, 0.25), lower = shell(29, 7, -1, 0.25);
    const std::vector<Pair> a = coordinates_of(upper, 0, 1), b = coordinates_of(lower, 0, 1), turned = coordinates_of(lower, 0.4, 1.3);
    const std::array<Colour, 2> checks{Colour{226, 214, 188}, blue};
    Drawing drawing(960, 380, {0.4, -1, 0.42}, 118);
    drawing.place(165, 178);
    drawing.textured(upper.view(), a, 20, checks);
    drawing.textured(lower.view(), b, 20, checks);
    drawing.caption(165, 368, "two textured meshes");
    const gusset::Stitch stitch = gusset::stitch(upper.view(), lower.view(), blend());
    const gusset::Origins origins = stitch.origins();
    double x = 480;
    for (const auto &[of_lower, what] : {std::pair(&b, "on one chart: it goes on"), std::pair(&turned, "on two: they meet in the middle")}) {
        const auto carried = origins.apply<Pair>(gusset::Domain::corners, gusset::Rule::texture, {a, *of_lower});
        drawing.place(x, 178);
        drawing.textured(stitch.mesh(), carried, 20, checks);
        drawing.caption(x, 368, what);
        x += 315;
    }
    return drawing.write(file);
}

/// Four pieces of a shell; assembled.
bool assembled(const std::string &file) {
    const std::vector<Mesh> pieces = quarters();
    const std::array<Colour, 4> colours{blue, ochre, red, grey};
    Drawing drawing(960, 330, {0.5, -1, 0.9}, 165);
    std::vector<gusset::MeshView> views;
    drawing.place(250, 190);
    for (std::size_t k = 0; k < 4; ++k) {
        views.push_back(pieces[k].view());
        drawing.mesh(views.back(), [&](std::size_t) { return colours[k]; });
    }
    drawing.caption(250, 318, "four pieces");
    const gusset::Join assembly(views, assembly_of_quarters());
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

/// Five views of a body, misplaced; aligned, trimmed, joined and filled.
bool scanned(const std::string &file) {
    const std::array<Colour, 5> colours{blue, ochre, green, Colour{150, 110, 160}, Colour{90, 150, 150}};
    std::vector<Mesh> pieces = misplaced_views();
    Drawing drawing(960, 360, {0.05, -1, 0.3}, 125);
    const auto side_by_side = [&](double x, const char *caption) {
        std::vector<gusset::MeshView> views;
        Mesh all;
        std::vector<Colour> colour;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            views.push_back(pieces[k].view());
            for (const uint32_t v : pieces[k].corners) {
                all.corners.push_back(v + static_cast<uint32_t>(all.points.size()));
            }
            all.points.insert(all.points.end(), pieces[k].points.begin(), pieces[k].points.end());
            colour.resize(all.corners.size() / 3, colours[k]);
        }
        drawing.place(x, 165);
        drawing.mesh(all.view(), [&](std::size_t f) { return colour[f]; });
        drawing.caption(x, 345, caption);
        return views;
    };
    const gusset::Alignment found(side_by_side(165, "five views"));
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        move(pieces[k].points, found.pieces()[k].pose);
    }
    const std::vector<gusset::MeshView> views = side_by_side(480, "aligned");
    gusset::JoinOptions options;
    options.overlaps = gusset::Overlaps::trim;
    options.fill = true;
    const gusset::Join whole(views, options);
    std::vector<Colour> colour(whole.mesh().face_count(), red);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const gusset_indices faces = whole.pieces()[k].faces;
        for (const uint32_t f : gusset::Indices(faces.data, faces.count)) {
            if (f != UINT32_MAX) {
                colour[f] = colours[k];
            }
        }
    }
    drawing.place(795, 165);
    drawing.mesh(whole.mesh(), [&](std::size_t f) { return colour[f]; });
    drawing.caption(795, 345, "trimmed and joined");
    return found.is_trusted() && whole.report().loops_left == 0 && drawing.write(file);
}

/// A ball with holes, whose rims are found, and filled: flat, and refined and fair.
bool filled(const std::string &file) {
    const Mesh torn = torn_ball();
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
    double x = 480;
    gusset::StitchOptions least;
    least.meridians = gusset::Meridians::min_area;
    for (const auto &[options, what] : {std::pair(gusset::FillOptions(), "least weight"), std::pair(faired_patch(), "refined, fair")}) {
        const gusset::Fill fill(torn.view(), options);
        const std::size_t old = torn.corners.size() / 3;
        drawing.place(x, 160);
        drawing.mesh(fill.mesh(), [&](std::size_t f) { return f < old ? blue : green; });
        drawing.caption(x, 338, what);
        x += 315;
    }
    return drawing.write(file);
}

/// A ring around the z axis with bumps.
Mesh bumpy_ring(uint32_t around, uint32_t across) {
    const double turn = 6.283185307179586;
    Mesh mesh;
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j) {
            const double s = turn * i / around, t = turn * j / across, tube = 0.36 + 0.05 * std::sin(5 * s);
            const double radius = 0.72 + tube * std::cos(t);
            const uint32_t a = across * i, b = across * ((i + 1) % around), k = (j + 1) % across;
            mesh.points.push_back({radius * std::cos(s), radius * std::sin(s), tube * std::sin(t)});
            mesh.corners.insert(mesh.corners.end(), {a + j, b + j, b + k, a + j, b + k, a + k});
        }
    }
    return mesh;
}

/// A ring; its outlines in parallel planes; its outlines in planes about its axis.
bool sectioned(const std::string &file) {
    const Mesh ring = bumpy_ring(56, 22);
    Drawing drawing(960, 300, {0.4, -1, 0.75}, 135);
    drawing.place(165, 140);
    drawing.mesh(ring.view(), [](std::size_t) { return grey; });
    drawing.caption(165, 288, "a mesh");
    std::vector<double> heights, angles;
    for (int k = 0; k < 10; ++k) {
        heights.push_back(-0.36 + 0.08 * k + 1e-3);
        angles.push_back(0.3141592653589793 * k + 0.1);
    }
    const auto draw = [&](double x, const gusset::CuttingPlanes &planes, const char *what) {
        drawing.place(x, 140);
        for (const gusset::SectionPath &path : gusset::MeshSections(ring.view(), planes)) {
            drawing.curve(std::vector<Point3>(path.points.begin(), path.points.end()), path.is_closed(), path.path.area > 0 ? blue : red, 2, 0.0);
        }
        drawing.caption(x, 288, what);
    };
    draw(480, gusset::CuttingPlanes::stack({0, 0, 0}, {0, 0, 1}, heights), "parallel planes");
    draw(795, gusset::CuttingPlanes::about_axis({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, angles), "planes about an axis");
    return drawing.write(file);
}

/// A tube through a wavy surface: where they meet, sections, and nearest points.
bool met(const std::string &file) {
    const gusset::Sheet pipe = tube(), sea = waves();
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
        if (stitched(folder + "stitch.svg") && textured(folder + "texture.svg") && assembled(folder + "pieces.svg") && scanned(folder + "scans.svg") && filled(folder + "fill.svg") && sectioned(folder + "sections.svg") && met(folder + "meet.svg")) {
            std::cout << "stitch.svg texture.svg pieces.svg scans.svg fill.svg sections.svg meet.svg\n";
            return 0;
        }
        std::cerr << "cannot write into " << folder << '\n';
    } catch (const gusset::Error &error) {
        std::cerr << error.what() << " (status " << error.status() << ")\n";
    }
    return 1;
}
