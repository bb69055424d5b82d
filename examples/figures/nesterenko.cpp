// Nesterenko, "The algorithm for polygonal networks of cross-linking": figures 1 to 5.
#include "figure.hpp"

#include "../pictures/shapes.hpp"

namespace figures {
namespace {
constexpr uint32_t null = UINT32_MAX;

std::string index(uint32_t element) { return element == null ? "NULL" : std::to_string(element); }

/// Fig. 1: an edge a of a small mesh from M to N, the faces L and R on its sides, the edges b, c, d, e of them.
std::string winged_edge(const std::string &file) {
    const std::vector<Point3> points{{0, 0, 0},      {2.1, -0.3, 0}, {4.2, 0.2, 0}, {-0.5, 1.6, 0}, {1.2, 1.5, 0},
                                     {3.2, 1.75, 0}, {5, 1.7, 0},    {0.1, 3.1, 0}, {2.2, 3.4, 0},  {4.3, 3.1, 0}};
    const std::vector<uint32_t> offsets{0, 4, 8, 11, 15, 19},
        corners{0, 1, 4, 3, 1, 2, 5, 4, 2, 6, 5, 3, 4, 8, 7, 4, 5, 9, 8};
    const auto mesh = gusset::MeshView::polygons(points, gusset::Offsets(offsets), gusset::Corners(corners));
    const gusset::Winged table(mesh);
    const auto edges = table.edges();
    // The first edge that has neighbours all round.
    uint32_t a = 0;
    while (edges[a].b == null || edges[a].c == null || edges[a].d == null || edges[a].e == null ||
           edges[a].left == null || edges[a].right == null) {
        ++a;
    }
    const gusset_winged_edge &edge = edges[a];

    Figure figure(960, 400);
    const auto spot = [&](const Point3 &p) { return Spot{90 + 95 * p[0], 335 - 95 * p[1]}; };
    const auto vertex = [&](uint32_t v) { return spot(points[v]); };
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::vector<Spot> outline;
        Spot middle{0, 0};
        for (const uint32_t v : mesh.face(f)) {
            outline.push_back(vertex(v));
            middle[0] += outline.back()[0] / static_cast<double>(mesh.face(f).size());
            middle[1] += outline.back()[1] / static_cast<double>(mesh.face(f).size());
        }
        const bool on_left = f == edge.left, on_right = f == edge.right;
        figure.area(outline,
                    on_left    ? Colour{222, 231, 240}
                    : on_right ? Colour{245, 232, 208}
                               : Colour{240, 238, 231},
                    1, {faint, 1.5, ""});
        if (on_left || on_right) {
            figure.label({middle[0], middle[1] + 6}, on_left ? "L" : "R", "middle", 22, on_left ? blue : ochre);
        }
    }
    // Each wing runs as its face does, clockwise: b and e leave the ends of a, c and d arrive at them.
    const auto name_beside = [&](const Spot &from, const Spot &to, const char *name, const Colour &colour) {
        const double x = to[0] - from[0], y = to[1] - from[1], length = std::hypot(x, y);
        const Spot half = between(from, to, 0.5);
        // Faces are on the right of their edges.
        figure.label({half[0] - 18 * y / length, half[1] + 18 * x / length + 5}, name, "middle", 18, colour);
    };
    for (const auto &[name, e, leaves, colour] :
         {std::tuple("b", edge.b, edge.n, ochre), std::tuple("c", edge.c, null, blue),
          std::tuple("d", edge.d, null, ochre), std::tuple("e", edge.e, edge.m, blue)}) {
        const uint32_t end = std::string(name) == "c" ? edge.n : edge.m;
        const uint32_t start = leaves != null ? leaves : edges[e].m == end ? edges[e].n : edges[e].m;
        const Spot from = vertex(start), to = vertex(edges[e].m == start ? edges[e].n : edges[e].m);
        figure.arrow(between(from, to, 0.06), between(from, to, 0.94), {colour, 2.5, ""});
        name_beside(from, to, name, colour);
    }
    const Spot m = vertex(edge.m), n = vertex(edge.n);
    figure.arrow(m, between(m, n, 0.97), {red, 4, ""}, 14);
    name_beside(m, n, "a", red);
    for (std::size_t v = 0; v < points.size(); ++v) {
        figure.dot(vertex(static_cast<uint32_t>(v)), 4, v == edge.m || v == edge.n ? red : paper);
    }
    figure.label({m[0], m[1] + 24}, "M", "middle", 18, red);
    figure.label({n[0] + 16, n[1] - 14}, "N", "middle", 18, red);
    figure.label({760, 372}, "arrows: a from M to N, its wings clockwise round L and R", "middle", 13);
    const std::array<std::pair<const char *, uint32_t>, 9> record{{{"a", a},
                                                                   {"M", edge.m},
                                                                   {"N", edge.n},
                                                                   {"b", edge.b},
                                                                   {"c", edge.c},
                                                                   {"d", edge.d},
                                                                   {"e", edge.e},
                                                                   {"L", edge.left},
                                                                   {"R", edge.right}}};
    figure.label({760, 60}, "the record of edge a", "middle");
    for (std::size_t k = 0; k < record.size(); ++k) {
        const double y = 95 + 30 * static_cast<double>(k);
        figure.label({740, y}, record[k].first, "middle", 16);
        figure.label({780, y}, index(record[k].second), "middle", 16);
    }
    figure.save(file);
    std::string text = "edge " + std::to_string(a);
    for (std::size_t k = 1; k < record.size(); ++k) {
        text += std::string(", ") + record[k].first + " " + index(record[k].second);
    }
    return text + "; " + std::to_string(edges.size()) + " edges of " + std::to_string(mesh.face_count()) + " faces";
}

/// Fig. 2: an open mesh and its free boundary, in the order of the walk.
std::string open_mesh(const std::string &file) {
    const pictures::Mesh shell = pictures::shell(30, 7, 1, 0);
    const gusset::Boundary boundary(shell.view());
    const gusset::Loop rim = boundary[0];
    Figure figure(960, 400, {1, -0.25, -0.25}, 225);
    figure.place(480, 300);
    figure.mesh(shell.view(), [](std::size_t) { return Colour{120, 160, 200}; });
    std::vector<Point3> points;
    for (const uint32_t v : rim.vertices) {
        points.push_back(shell.points[v]);
    }
    figure.curve(points, true, red, 3, 0.05);
    for (std::size_t k = 0; k < points.size(); ++k) {
        figure.dot(figure.at(points[k]), k == 0 ? 6 : 3.5, k == 0 ? red : paper, red, 1.5);
    }
    // The first vertices of the walk are named below the rim, and its direction is shown.
    for (std::size_t k = 0; k < 4; ++k) {
        const Spot at = figure.at(points[k]);
        figure.label({at[0], at[1] + 24}, "V_" + std::to_string(k), "middle", 16, red);
    }
    figure.save(file);
    return std::to_string(boundary.size()) + " free boundary of " + std::to_string(points.size()) +
           " vertices, from vertex " + std::to_string(rim.vertices[0]) + ", " + places(rim.length, 3) + " long; " +
           std::to_string(shell.view().face_count()) + " faces";
}

/// Fig. 3: two contours; white: the vertices that face the other, beyond the plane through their own centre.
std::string facing(const std::string &file) {
    const double turn = 6.283185307179586;
    std::array<std::vector<Point3>, 2> loops;
    for (int i = 0; i < 15; ++i) {
        const double t = turn * i / 15, r = 1 + 0.12 * std::sin(3 * t + 0.5);
        loops[0].push_back({-1.9 + 1.05 * r * std::cos(t), 0.25 + 1.25 * r * std::sin(t), 0});
    }
    for (int i = 0; i < 12; ++i) {
        const double t = -turn * i / 12 + 0.2, r = 1 + 0.1 * std::cos(2 * t + 1);
        loops[1].push_back({1.75 + 0.95 * r * std::cos(t), -0.2 + 1.05 * r * std::sin(t), 0});
    }
    const gusset::Facing found(loops[0], loops[1]);
    const gusset_facing_view view = found.view();
    Figure figure(960, 420);
    const auto spot = [](double x, double y) { return Spot{480 + 120 * x, 215 - 120 * y}; };
    const std::array<Colour, 2> colours{blue, ochre};
    std::string text;
    std::array<Spot, 2> centre;
    for (std::size_t k = 0; k < 2; ++k) {
        const double *c = view.centre[k], *n = view.normal[k], size = 1.35 / std::hypot(n[0], n[1]);
        centre[k] = spot(c[0], c[1]);
        const Spot above = spot(c[0] - size * n[1], c[1] + size * n[0]),
                   below = spot(c[0] + size * n[1], c[1] - size * n[0]);
        figure.line({above, below}, {ink, 1.2, "7 5"});
        const Spot high = above[1] < below[1] ? above : below;
        figure.label({high[0] + 20, high[1] + 14}, k == 0 ? "Π_1" : "Π_2");
    }
    figure.arrow(centre[0], between(centre[0], centre[1], 0.46), {ink, 1.2, ""});
    figure.arrow(centre[1], between(centre[1], centre[0], 0.46), {ink, 1.2, ""});
    for (std::size_t k = 0; k < 2; ++k) {
        std::vector<Spot> outline;
        for (const Point3 &p : loops[k]) {
            outline.push_back(spot(p[0], p[1]));
        }
        figure.line(outline, {colours[k], 2, ""}, true);
        std::size_t white = 0;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const bool faces = view.distances[k][i] > 0;
            white += faces ? 1 : 0;
            figure.dot(outline[i], 6, faces ? Colour{255, 255, 255} : ink, ink, 1.5);
        }
        figure.dot(centre[k], 4, red, red);
        figure.label({centre[k][0] + (k == 0 ? -20 : 20), centre[k][1] + 20}, k == 0 ? "C_1" : "C_2", "middle", 16,
                     red);
        const std::array<uint32_t, 2> arc = found.arc(static_cast<int>(k));
        text += (k == 0 ? "" : "; ") + std::to_string(white) + " of " + std::to_string(outline.size()) +
                " face, an arc of " + std::to_string(arc[1]) + " from " + std::to_string(arc[0]);
    }
    const Spot middle = between(centre[0], centre[1], 0.5);
    figure.label({middle[0] - 45, middle[1] - 12}, "a_1");
    figure.label({middle[0] + 45, middle[1] - 6}, "a_2");
    figure.save(file);
    return text;
}

/// Two lines in space, with these numbers of points.
std::array<std::vector<Point3>, 2> lines(std::size_t n, std::size_t m) {
    std::array<std::vector<Point3>, 2> made;
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(n - 1);
        made[0].push_back({3 * x - 1.5, 0.25 * std::sin(4 * x), 1.1 + 0.25 * std::sin(6 * x)});
    }
    for (std::size_t j = 0; j < m; ++j) {
        const double x = static_cast<double>(j) / static_cast<double>(m - 1);
        made[1].push_back({3.3 * x - 1.65, -0.2 * std::cos(5 * x), -0.5 + 0.2 * std::cos(5 * x)});
    }
    return made;
}

/// The letters of the points on the lines, and the meridian that a new one is on.
std::string name_of(uint32_t v, std::size_t n, std::size_t m, std::size_t meridians) {
    if (v < n) {
        return "A_" + std::to_string(v + 1);
    }
    if (v < n + m) {
        return "B_" + std::to_string(v - n + 1);
    }
    const std::size_t k = v - n - m;
    return "C_" + std::to_string(k % meridians + 1) + std::to_string(k / meridians + 1);
}

/// Fig. 4: meridians between two lines in space; the straight model that decides which; the matrix H.
std::string meridians(const std::string &file) {
    const std::size_t n = 7, m = 4;
    const auto [a, b] = lines(n, m);
    gusset::StripOptions options;
    options.meridians = gusset::Meridians::index;
    options.cells = gusset::StripCells::quads;
    const gusset::Strip strip(a, b, options);
    const std::vector<uint32_t> to = gusset::meridians_index(n - 1, m - 1);

    Figure figure(960, 380, {0.25, -1, 0.45}, 95);
    figure.place(190, 190);
    figure.mesh(strip.mesh(), [](std::size_t) { return Colour{190, 208, 226}; });
    figure.flush();
    const auto drawn = [&](const std::vector<Point3> &points, const Colour &colour, const std::string &letter,
                           double up) {
        std::vector<Spot> spots;
        for (const Point3 &p : points) {
            spots.push_back(figure.at(p));
        }
        figure.line(spots, {colour, 2.5, ""});
        for (std::size_t k = 0; k < spots.size(); ++k) {
            figure.dot(spots[k], 4, paper, colour, 1.5);
            figure.label({spots[k][0], spots[k][1] + up}, letter + "_" + std::to_string(k + 1), "middle", 14, colour);
        }
    };
    const gusset::Indices pairs = strip.meridians();
    for (std::size_t k = 0; k + 1 < pairs.size(); k += 2) {
        figure.line({figure.at(a[pairs[k]]), figure.at(b[pairs[k + 1]])}, {red, 1.5, ""});
    }
    drawn(a, blue, "A", -12);
    drawn(b, ochre, "B", 24);
    figure.label({190, 365}, "а: wanted");

    // The model: both lines (N - 1)(M - 1) long.
    const double length = static_cast<double>((n - 1) * (m - 1)), left = 400, unit = 300 / length;
    const auto model_a = [&](std::size_t i) { return Spot{left + unit * static_cast<double>((m - 1) * i), 100}; };
    const auto model_b = [&](std::size_t j) { return Spot{left + unit * static_cast<double>((n - 1) * j), 260}; };
    for (std::size_t i = 0; i < n; ++i) {
        figure.line({model_a(i), model_b(to[i])}, {red, 1.5, ""});
    }
    figure.line({model_a(0), model_a(n - 1)}, {blue, 2.5, ""});
    figure.line({model_b(0), model_b(m - 1)}, {ochre, 2.5, ""});
    for (std::size_t i = 0; i < n; ++i) {
        figure.dot(model_a(i), 4, paper, blue, 1.5);
        figure.label({model_a(i)[0], 88}, "A_" + std::to_string(i + 1), "middle", 14, blue);
        figure.label({model_a(i)[0], 66}, std::to_string((m - 1) * i), "middle", 11);
    }
    for (std::size_t j = 0; j < m; ++j) {
        figure.dot(model_b(j), 4, paper, ochre, 1.5);
        figure.label({model_b(j)[0], 284}, "B_" + std::to_string(j + 1), "middle", 14, ochre);
        figure.label({model_b(j)[0], 306}, std::to_string((n - 1) * j), "middle", 11);
    }
    figure.label({left + 150, 365}, "б: the straight model, x of each point");

    // H: a row for each point of A.
    std::string text = "H";
    const double size = 26;
    figure.bits(
        {800, 90}, n, m, size, [&](std::size_t i, std::size_t j) { return to[i] == j; },
        [](std::size_t, std::size_t) { return Colour{178, 62, 40}; });
    for (std::size_t i = 0; i < n; ++i) {
        text += ' ';
        figure.label({785, 108 + size * static_cast<double>(i)}, "A_" + std::to_string(i + 1), "middle", 12, blue);
        for (std::size_t j = 0; j < m; ++j) {
            text += to[i] == j ? '1' : '0';
            figure.label({813 + size * static_cast<double>(j), 80}, "B_" + std::to_string(j + 1), "middle", 12, ochre);
        }
    }
    figure.label({852, 365}, "the matrix H");
    figure.save(file);
    return text + "; N " + std::to_string(n) + ", M " + std::to_string(m) + ", " + std::to_string(pairs.size() / 2) +
           " meridians";
}

/// Fig. 5: the matrix P of a strip between six points and four, with two rows of new vertices.
std::string matrix_p(const std::string &file) {
    const std::size_t n = 6, m = 4;
    const auto [a, b] = lines(n, m);
    gusset::StripOptions options;
    options.meridians = gusset::Meridians::index;
    options.cells = gusset::StripCells::quads;
    options.row_count = 2;
    const gusset::Strip strip(a, b, options);
    const gusset::Indices p = strip.matrix();
    const std::size_t rows = strip.row_count() + 2, columns = p.size() / rows;
    const gusset::MeshView mesh = strip.mesh();

    Figure figure(960, 380, {0.2, -1, 0.35}, 125);
    figure.place(260, 200);
    figure.mesh(
        mesh, [&](std::size_t f) { return mesh.face(f).size() == 4 ? Colour{190, 208, 226} : Colour{238, 214, 170}; });
    figure.flush();
    const auto spot = [&](std::size_t r, std::size_t k) { return figure.at(mesh.position(p[r * columns + k])); };
    for (std::size_t r = 0; r < rows; ++r) {
        std::vector<Spot> along;
        for (std::size_t k = 0; k < columns; ++k) {
            along.push_back(spot(r, k));
        }
        figure.line(along, {r == 0 ? blue : r + 1 == rows ? ochre : ink, r == 0 || r + 1 == rows ? 2.5 : 1, ""});
    }
    for (std::size_t k = 0; k < columns; ++k) {
        for (std::size_t r = 0; r + 1 < rows; ++r) {
            figure.line({spot(r, k), spot(r + 1, k)}, {red, 1.5, ""});
        }
    }
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t k = 0; k < columns; ++k) {
            const uint32_t v = p[r * columns + k];
            const Colour colour = r == 0 ? blue : r + 1 == rows ? ochre : ink;
            figure.dot(spot(r, k), 4, paper, colour, 1.5);
            const Spot at = spot(r, k);
            const double x = r == 0 || r + 1 == rows ? 0 : 18, y = r == 0 ? -12 : r + 1 == rows ? 26 : -6;
            // A vertex of B that has several meridians is named once.
            if (k == 0 || v != p[r * columns + k - 1]) {
                figure.label({at[0] + x, at[1] + y}, name_of(v, n, m, columns), "middle", 13, colour);
            }
        }
    }
    std::string text = "P";
    figure.label({755, 62}, "P, and the vertices by number");
    for (std::size_t r = 0; r < rows; ++r) {
        text += r == 0 ? " " : " / ";
        for (std::size_t k = 0; k < columns; ++k) {
            const uint32_t v = p[r * columns + k];
            const Colour colour = r == 0 ? blue : r + 1 == rows ? ochre : ink;
            const double x = 605 + 60 * static_cast<double>(k), y = 110 + 62 * static_cast<double>(r);
            figure.label({x, y}, name_of(v, n, m, columns), "middle", 17, colour);
            figure.label({x, y + 19}, std::to_string(v), "middle", 11);
            text += (k == 0 ? "" : " ") + std::to_string(v);
        }
    }
    std::size_t quads = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        quads += mesh.face(f).size() == 4 ? 1 : 0;
    }
    figure.save(file);
    return text + "; " + std::to_string(quads) + " quads, " + std::to_string(mesh.face_count() - quads) + " triangles";
}
} // namespace

std::vector<Entry> nesterenko() {
    return {{"nesterenko_1", winged_edge},
            {"nesterenko_2", open_mesh},
            {"nesterenko_3", facing},
            {"nesterenko_4", meridians},
            {"nesterenko_5", matrix_p}};
}
} // namespace figures
