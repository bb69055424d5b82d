// Deryagin, "Modelling of 3D objects and scenes by tetragonal regular networks": figures 1 to 3 and 7 to 9.
#include "net_drawing.hpp"

#include "../pictures/shapes.hpp"

#include <set>

namespace figures {
namespace {
/// Fig. 1: a TIN and a fragment of it: here a ball whose holes were filled by refined patches.
std::string tin(const std::string &file) {
    const pictures::Mesh torn = pictures::torn_ball();
    const gusset::Fill fill(torn.view(), pictures::faired_patch());
    const gusset::MeshView mesh = fill.mesh();
    std::vector<uint32_t> valence(mesh.vertex_count());
    // In a closed mesh of triangles, a vertex has as many faces as edges.
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (const uint32_t v : mesh.face(f)) {
            ++valence[v];
        }
    }
    Figure figure(960, 420, {0.25, -1, 0.42}, 165);
    figure.place(220, 200);
    figure.mesh(mesh, [](std::size_t) { return pictures::blue; });
    // Round the patch that faces the eye.
    const Point3 middle = pictures::unit({0.45, -1, 0.55});
    const auto near = [&](std::size_t f) { return pictures::dot(mesh.position(mesh.face(f)[0]), middle) > 0.88; };
    pictures::Mesh fragment;
    std::size_t new_faces = 0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        fragment.points.push_back(mesh.position(v));
    }
    std::vector<Colour> colours;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const bool patch = f >= torn.corners.size() / 3;
        new_faces += patch ? 1 : 0;
        if (near(f)) {
            fragment.corners.insert(fragment.corners.end(), mesh.face(f).begin(), mesh.face(f).end());
            colours.push_back(patch ? pictures::green : pictures::blue);
        }
    }
    // Seen from the middle, which is at the origin of the picture then.
    figure.look(middle, 340);
    figure.place(690, 200);
    figure.mesh(fragment.view(), [&](std::size_t f) { return colours[f]; });
    figure.label({220, 405}, "a TIN");
    figure.label({690, 405}, "a fragment of its net");
    figure.save(file);
    // The points within the holes lack faces.
    const auto unused = std::count(valence.begin(), valence.end(), 0u);
    const auto odd = std::count_if(valence.begin(), valence.end(), [](uint32_t n) { return n != 0 && n != 6; });
    return std::to_string(mesh.vertex_count() - static_cast<std::size_t>(unused)) + " vertices, " +
           std::to_string(mesh.face_count()) + " faces, " + std::to_string(new_faces) + " of them of patches; " +
           std::to_string(odd) + " vertices whose valence is not 6; " + std::to_string(12 * mesh.face_count()) +
           " bytes of indices, which a net has not";
}

/// Fig. 2: the indices of the nodes of a net, and of its cells, counted from 1 as in the paper.
std::string indices(const std::string &file) {
    const std::size_t h = 4, w = 6;
    const gusset::Net net = gusset::Net::from_primitive(gusset::Primitive::plane(5, 3).with(h, w));
    const gusset::NetMesh mesh(net);
    Figure figure(960, 340);
    const auto pair = [](std::size_t i, std::size_t j) { return std::to_string(i + 1) + "," + std::to_string(j + 1); };
    for (const double x : {235.0, 725.0}) {
        const Grid grid(net, {x, 155}, 75);
        grid.lines(figure, {blue, 1.5, ""});
        for (std::size_t i = 0; i < h; ++i) {
            for (std::size_t j = 0; j < w; ++j) {
                figure.dot(grid.spot(i, j), 3.5, blue, blue);
                if (x < 480) {
                    figure.label({grid.spot(i, j)[0] + 14, grid.spot(i, j)[1] + 16}, pair(i, j), "middle", 12);
                }
            }
        }
        if (x > 480) {
            for (const uint32_t cell : mesh.cell_of_face()) {
                const std::size_t i = cell / (w - 1), j = cell % (w - 1);
                const Spot at = between(grid.spot(i, j), grid.spot(i + 1, j + 1), 0.5);
                figure.label({at[0], at[1] + 5}, pair(i, j), "middle", 14, red);
            }
        }
    }
    figure.label({235, 322}, "а: indices of nodes");
    figure.label({725, 322}, "б: indices of cells");
    figure.save(file);
    return std::to_string(net.rows()) + " x " + std::to_string(net.columns()) + " nodes, " +
           std::to_string(mesh.mesh().face_count()) + " cells";
}

/// Fig. 3: a sheet rolls to a tube, and on to a sphere or to a torus; the gluing is found where sides have met.
std::string forming(const std::string &file) {
    const double pi = 3.141592653589793;
    Figure figure(960, 505);
    std::string text;
    // All shapes of a row have one scale. Each has the width that it needs, and they fill the row.
    const auto row = [&](double y, const char *name, const gusset::Net &sheet, const gusset::Field &field,
                         const Point3 &eye, double below, const char *letter) {
        text += (text.empty() ? "" : "; ") + std::string(name) + " chi";
        const std::array<double, 5> parts{0, 0.3, 0.5, 0.75, 1};
        const double gap = 30, margin = 30;
        std::vector<gusset::Net> nets;
        std::vector<std::array<double, 2>> spans;
        double wide = 0;
        figure.look(eye, 1);
        figure.place(0, 0);
        for (const double part : parts) {
            nets.push_back(sheet);
            gusset::Net &net = nets.back();
            net.deform(field.with_strength(part));
            net.detect_gluing(1e-9);
            gusset::Point3 middle{};
            const auto points = net.points();
            for (const Point3 &p : points) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    middle[axis] += p[axis] / static_cast<double>(points.size());
                }
            }
            net.transform(gusset::Operation::translate({-middle[0], -middle[1], -middle[2]}));
            std::array<double, 2> span{0, 0};
            for (const Point3 &p : net.points()) {
                span[0] = std::min(span[0], figure.at(p)[0]), span[1] = std::max(span[1], figure.at(p)[0]);
            }
            wide += span[1] - span[0];
            spans.push_back(span);
        }
        const double scale = (960 - 2 * margin - gap * static_cast<double>(parts.size() - 1)) / wide;
        double x = margin;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const int64_t euler = gusset::NetComplex(nets[k]).euler();
            figure.look(eye, scale);
            figure.place(x - scale * spans[k][0], y);
            const gusset::NetMesh mesh(nets[k]);
            figure.mesh(mesh.mesh(), [&](std::size_t) { return Colour{150, 180, 210}; });
            const double width = scale * (spans[k][1] - spans[k][0]);
            figure.label({x + 0.5 * width, y + below}, "t = " + places(parts[k], 2) + ", χ = " + std::to_string(euler),
                         "middle", 13);
            text += " " + std::to_string(euler);
            x += width + gap;
        }
        figure.label({28, y - 95}, letter, "middle", 16);
    };
    // The arc of the field is along x, the meridians along y and the height z, so that axes follow z.
    gusset::Net globe = gusset::Net::from_primitive(gusset::Primitive::plane(2 * pi, pi).with(13, 25));
    globe.transform(gusset::Operation::translate({pi, 0, 0}));
    row(125, "sphere", globe, gusset::Field::wrap_sphere(gusset::Axis::z, 1), {0.55, -1, 0.5}, 115, "а");
    gusset::Net ring = gusset::Net::from_primitive(gusset::Primitive::plane(2 * pi, 2 * pi * 0.4).with(13, 25));
    row(370, "torus", ring, gusset::Field::wrap_torus(gusset::Axis::z, 1, 0.4), {-0.8, -0.5, 0.75}, 120, "б");
    figure.save(file);
    return text;
}

/// Fig. 7: rows and columns of a net are repeated, and their links contracted: the surface stays.
std::string reformatting(const std::string &file) {
    const gusset::Net net = gusset::Net::from_primitive(gusset::Primitive::plane(4, 3).with(4, 5));
    gusset::NetCopyOptions options;
    options.rows = 5;
    options.columns = 7;
    options.row_replication = options.column_replication = gusset::Replication::at;
    options.row_index = 1;
    options.column_index = 3;
    const gusset::Net large = net.copied(options);
    Figure figure(960, 400);
    // By their numbers, since repeated nodes are one point in space; each carries the pair of the node that it repeats.
    const Grid before(net.rows(), net.columns(), {200, 175}, 70), after(large.rows(), large.columns(), {680, 175}, 70);
    const auto pair = [&](const Point3 &p) {
        const auto all = net.points();
        const auto at = static_cast<std::size_t>(std::find(all.begin(), all.end(), p) - all.begin());
        return std::to_string(at / net.columns() + 1) + "," + std::to_string(at % net.columns() + 1);
    };
    std::size_t ones = 0;
    for (const auto &[grid, of] : {std::pair(&before, &net), std::pair(&after, &large)}) {
        grid->lines(figure, {blue, 1.5, ""});
        ones = grid->contracted(figure, *of);
        for (std::size_t i = 0; i < of->rows(); ++i) {
            for (std::size_t j = 0; j < of->columns(); ++j) {
                figure.dot(grid->spot(i, j), 3.5, blue, blue);
                figure.label({grid->spot(i, j)[0] + 16, grid->spot(i, j)[1] + 17}, pair(of->at(i, j)), "middle", 12);
            }
        }
    }
    figure.label({200, 380}, "а: a net");
    figure.label({680, 380}, "б: reformatted; contracted links in red");
    figure.save(file);
    const gusset::Net back = large.compacted();
    return std::to_string(large.rows()) + " x " + std::to_string(large.columns()) + " of " +
           std::to_string(net.rows()) + " x " + std::to_string(net.columns()) + ", " + std::to_string(ones) +
           " links contracted; compacted to " + std::to_string(back.rows()) + " x " + std::to_string(back.columns()) +
           ", area " + places(large.measure().area, 3) + " of " + places(net.measure().area, 3);
}

/// A rectangle of nodes with a wave.
gusset::Net wavy(std::size_t rows, std::size_t columns, double x, double phase) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            const double u = x + static_cast<double>(j),
                         v = 1.6 * (1 - 2 * static_cast<double>(i) / static_cast<double>(rows - 1));
            points.push_back({u, v, 0.35 * std::sin(1.1 * u + phase) + 0.15 * std::cos(1.5 * v)});
        }
    }
    // Rows run away from the first one, so that its upper side would be the back.
    gusset::Gluing turned;
    turned.reversed = true;
    return gusset::Net::from_points(rows, columns, points, turned);
}

/// Fig. 8: two nets side by side become one; the smaller one is enlarged before.
std::string joining(const std::string &file) {
    const gusset::Net first = wavy(5, 4, -5.5, 0), second = wavy(4, 5, -1, 1.2);
    const gusset::Net joined = gusset::concatenate(first, second);
    const gusset::Bridge bridge = joined.bridge(0);
    Figure figure(960, 500, {0.15, -1, 0.9}, 42);
    const auto colour_of = [&](std::size_t column) {
        return column + 1 < bridge.at ? pictures::blue : column + 1 == bridge.at ? pictures::green : pictures::ochre;
    };
    figure.place(262, 385);
    const gusset::NetMesh a(first), b(second), c(joined);
    figure.mesh(a.mesh(), [&](std::size_t) { return pictures::blue; });
    figure.mesh(b.mesh(), [&](std::size_t) { return pictures::ochre; });
    figure.place(760, 385);
    figure.mesh(c.mesh(), [&](std::size_t f) { return colour_of(c.cell_of_face()[f] % (joined.columns() - 1)); });
    for (const auto &[net, x, colour] : {std::tuple(&first, 130.0, blue), std::tuple(&second, 350.0, ochre)}) {
        const Grid grid(net->rows(), net->columns(), {x, 150}, 42);
        grid.lines(figure, {colour, 1.5, ""});
        grid.dots(figure, [&](std::size_t, std::size_t) { return colour; });
    }
    const Grid grid(joined.rows(), joined.columns(), {730, 150}, 42);
    grid.lines(figure, {ink, 1.2, ""});
    for (std::size_t i = 0; i < joined.rows(); ++i) {
        figure.line({grid.spot(i, bridge.at - 1), grid.spot(i, bridge.at)}, {green, 3, ""});
    }
    const std::size_t ones = grid.contracted(figure, joined);
    grid.dots(figure, [&](std::size_t, std::size_t j) { return j < bridge.at ? blue : ochre; });
    figure.label({240, 485}, "а: two nets");
    figure.label({740, 485}, "б: one net: a bridge (green), a row repeated (red)");
    figure.save(file);
    const auto [left, right] = joined.split(0);
    return std::to_string(first.rows()) + " x " + std::to_string(first.columns()) + " and " +
           std::to_string(second.rows()) + " x " + std::to_string(second.columns()) + " make " +
           std::to_string(joined.rows()) + " x " + std::to_string(joined.columns()) + ", " + std::to_string(ones) +
           " links contracted; split again " + std::to_string(left.rows()) + " x " + std::to_string(left.columns()) +
           " and " + std::to_string(right.rows()) + " x " + std::to_string(right.columns());
}

/// Fig. 9: what connects two bodies after they were joined: a thread, a ribbon, a tube.
std::string bridges(const std::string &file) {
    Figure figure(960, 420, {0.45, -1, 0.35}, 62);
    std::string text;
    const auto draw = [&](double x, double scale, const gusset::Net &net, const char *how) {
        const std::array<const char *, 3> names{"ribbon", "tube", "thread"};
        const gusset::Bridge bridge = net.bridge(0);
        const std::string name = names[static_cast<std::size_t>(bridge.kind)];
        const bool down = bridge.direction == gusset::Direction::down;
        const std::size_t columns = net.columns() - 1;
        const gusset::NetMesh mesh(net);
        figure.look({0.45, -1, 0.35}, scale);
        figure.place(x, 185);
        figure.mesh(mesh.mesh(), [&](std::size_t f) {
            const std::size_t cell = mesh.cell_of_face()[f], line = down ? cell / columns : cell % columns;
            const bool first = line + 1 + bridge.rows < bridge.at;
            return first ? pictures::blue : line < bridge.at ? pictures::green : pictures::ochre;
        });
        // A thread lacks faces: its edges belong to no face.
        for (std::size_t k = 0; k + 1 < mesh.wires().size(); k += 2) {
            figure.curve({mesh.mesh().position(mesh.wires()[k]), mesh.mesh().position(mesh.wires()[k + 1])}, false,
                         green, 4, 0.05);
        }
        figure.label({x, 388}, name + ": " + how);
        text += (text.empty() ? "" : "; ") + name + " chi " + std::to_string(gusset::NetComplex(net).euler()) + ", " +
                std::to_string(mesh.wires().size() / 2) + " wires";
    };
    const auto moved = [](gusset::Net net, const Point3 &by) {
        net.transform(gusset::Operation::translate(by));
        return net;
    };
    gusset::ConcatenateOptions down;
    down.direction = gusset::Direction::down;
    const gusset::Net ball = gusset::Net::from_primitive(gusset::Primitive::sphere(0.8).with(11, 21));
    // Rows of a net run from below to above.
    draw(150, 72, gusset::concatenate(moved(ball, {0, 0, -1.25}), moved(ball, {0, 0, 1.25}), down), "pole to pole");
    draw(480, 72, gusset::concatenate(moved(ball, {-1.2, 0, 0}), moved(ball, {1.2, 0, 0})), "side by side");
    gusset::ConcatenateOptions film = down;
    film.rows = 9;
    film.properties.tension = 1;
    const gusset::Net ring = gusset::Net::from_primitive(gusset::Primitive::tube(1, 0.9).with(4, 25));
    gusset::Net tube = gusset::concatenate(moved(ring, {0, 0, -1}), moved(ring, {0, 0, 1}), film);
    const gusset_settle_report rest = tube.settle();
    draw(810, 72, tube, "rim to rim, a film at rest");
    figure.save(file);
    return text + ", at rest " + (rest.converged != 0 ? "after " : "not after ") + std::to_string(rest.iterations) +
           " steps";
}
} // namespace

std::vector<Entry> deryagin() {
    return {{"deryagin_1", tin},          {"deryagin_2", indices},  {"deryagin_3", forming},
            {"deryagin_4", gluings},      {"deryagin_5", closures}, {"deryagin_6", cube},
            {"deryagin_7", reformatting}, {"deryagin_8", joining},  {"deryagin_9", bridges}};
}
} // namespace figures
