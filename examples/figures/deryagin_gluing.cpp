// Deryagin, "Modelling of 3D objects and scenes by tetragonal regular networks": figures 4 to 6, gluings.
#include "net_drawing.hpp"

#include <map>

namespace figures {
namespace {
using gusset::GluingType;
using gusset::LocalGluing;
using gusset::Net;
using gusset::Primitive;

/// The name of a type as the paper writes it.
std::string letters(const gusset::GluingOccurrence &found) {
    const std::string b = found.b == UINT32_MAX ? "" : "," + std::to_string(found.b);
    return (found.place == GUSSET_GLUING_PLACE_CELL ? "c(" : "n(") + std::to_string(found.a) + b + ")";
}
} // namespace

/// Fig. 4: the 18 local gluings in the paper's eight groups; above the net with its glued links, below the glued net.
std::string gluings(const std::string &file) {
    struct Panel {
        const char *letter;
        std::vector<GluingType> types;
    };
    const std::vector<Panel> panels{
        {"а", {GluingType::horizontal, GluingType::vertical}},
        {"б", {GluingType::east_south, GluingType::south_west, GluingType::west_north, GluingType::north_east}},
        {"в", {GluingType::east_west, GluingType::north_south}},
        {"г", {GluingType::but_north, GluingType::but_east, GluingType::but_south, GluingType::but_west}},
        {"д", {GluingType::all}},
        {"е", {GluingType::top_bottom, GluingType::right_left}},
        {"ж", {GluingType::point}},
        {"з", {GluingType::falling, GluingType::rising}},
    };
    Figure figure(960, 980);
    std::string text;
    std::size_t count = 0;
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const double left = 480 * static_cast<double>(k % 2), top = 243 * static_cast<double>(k / 2);
        std::map<std::string, gusset_gluing_place> names;
        uint32_t node_order = 0, link_order = 0;
        for (std::size_t t = 0; t < panels[k].types.size(); ++t) {
            const GluingType type = panels[k].types[t];
            // At the middle of a net: of 3 x 3 nodes for a node, of 4 x 4 for a cell.
            const bool of_cell = type >= GluingType::top_bottom;
            const std::size_t side = of_cell ? 4 : 3;
            Net net = Net::from_primitive(Primitive::plane(1, 1).with(side, side));
            const uint32_t middle = 4;
            net.glue(LocalGluing::of_type(type, middle));
            for (const auto &found : net.gluing_occurrences()) {
                if (found.kind == static_cast<gusset_gluing_type>(type)) {
                    names[letters(found)] = found.place;
                    node_order = found.node_order, link_order = found.link_order;
                }
            }
            const double x = left + 85 + 106 * static_cast<double>(t), step = of_cell ? 27 : 40;
            const Grid before(side, side, {x, top + 85}, step),
                after = Grid(side, side, {x, top + 190}, step).gathered(net, 1);
            before.lines(figure, {blue, 1.2, ""});
            before.contracted(figure, net);
            if (type >= GluingType::falling) {
                // Opposite corners are not a link: the pair is a seam.
                for (const gusset::Seam &seam : net.seams()) {
                    figure.line({before.spot(seam.row_a, seam.column_a), before.spot(seam.row_b, seam.column_b)},
                                {red, 3, "5 4"});
                }
            }
            after.lines(figure, {blue, 1.2, ""});
            const std::vector<uint32_t> classes = net.classes();
            std::vector<std::size_t> size(classes.size());
            for (const uint32_t one : classes) {
                ++size[one];
            }
            for (std::size_t node = 0; node < classes.size(); ++node) {
                const bool glued = size[classes[node]] > 1;
                figure.dot(before.spot(node), 2.5, glued ? red : blue, glued ? red : blue);
                figure.dot(after.spot(node), glued ? 4.5 : 2.5, glued ? red : blue, glued ? red : blue);
            }
            ++count;
        }
        std::string name;
        for (const gusset_gluing_place place : {GUSSET_GLUING_PLACE_NODE, GUSSET_GLUING_PLACE_CELL}) {
            for (const auto &[one, there] : names) {
                name += there == place ? (name.empty() ? "" : ", ") + one : "";
            }
        }
        const std::string orders = "node order " + std::to_string(node_order) +
                                   (link_order > 1 ? ", link order " + std::to_string(link_order) : "");
        const std::size_t kinds = panels[k].types.size();
        figure.label({left + 28, top + 28},
                     std::string(panels[k].letter) + ":  " + name + ";  " + orders + ";  " + std::to_string(kinds) +
                         (kinds == 1 ? " kind" : " kinds"),
                     "start", 14);
        text += name + " " + std::to_string(node_order) + "/" + std::to_string(link_order) + " x " +
                std::to_string(kinds) + "; ";
    }
    figure.save(file);
    return text + std::to_string(count) + " local gluings";
}

/// Fig. 5: the closures of nets, each with its characteristic matrix.
std::string closures(const std::string &file) {
    struct Closure {
        const char *letter, *name;
        Net net;
    };
    const std::size_t h = 9, w = 13;
    const std::vector<Closure> all{
        {"а", "two poles", Net::from_primitive(Primitive::sphere(1).with(h, w))},
        {"б", "one pole", Net::from_primitive(Primitive::one_pole_sphere(1).with(h, w))},
        {"в", "cylinder", Net::from_primitive(Primitive::cylinder(0.75, 1.7).with(h, w))},
        {"в", "prism", Net::from_primitive(Primitive::prism(6, 0.8, 1.7).with(h, w))},
        {"г", "cone", Net::from_primitive(Primitive::cone(0.95, 1.8).with(h, w))},
        {"г", "pyramid", Net::from_primitive(Primitive::pyramid(4, 1.05, 1.8).with(h, w))},
        {"д", "torus", Net::from_primitive(Primitive::torus(0.85, 0.36).with(h, w))},
    };
    Figure figure(960, 410);
    std::string text;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Net &net = all[k].net;
        const double x = 70 + 136.5 * static_cast<double>(k), size = 8;
        const std::vector<uint8_t> matrix = net.matrix();
        const gusset::NetMesh mesh(net);
        const gusset::NetComplex complex(net);
        // The view shows a pole. The only pole of a disc may be below.
        std::map<uint32_t, std::size_t> order;
        for (const uint32_t one : net.classes()) {
            ++order[one];
        }
        const bool only = std::string(all[k].name) == "one pole";
        const Point3 eye{0.5, -1, only && net.at(0, 0)[2] < 0 ? -0.65 : 0.65};
        figure.look(eye, 54);
        figure.place(x, 85);
        figure.mesh(mesh.mesh(), [](std::size_t) { return Colour{150, 180, 210}; });
        for (const auto &[first, count] : order) {
            const Point3 p = net.at(first / w, first % w);
            if (count >= w && pictures::dot(p, eye) > 0) {
                figure.dot(figure.at(p), 4, paper, red, 1.5);
            }
        }
        figure.label({x, 178},
                     std::string(all[k].letter) + ": " + all[k].name + ", χ = " + std::to_string(complex.euler()),
                     "middle", 13);
        // Rows of horizontal and of vertical links by turns.
        figure.bits(
            {x - 0.5 * size * static_cast<double>(w), 196}, 2 * h, w, size,
            [&](std::size_t i, std::size_t j) { return matrix[i * w + j] != 0; },
            [](std::size_t i, std::size_t) { return i % 2 == 0 ? red : blue; });
        const auto ones = std::count(matrix.begin(), matrix.end(), uint8_t{1});
        figure.label({x, 364}, std::to_string(ones) + " ones", "middle", 14);
        text += (k == 0 ? "" : "; ") + std::string(all[k].name) + " " + std::to_string(ones) + " ones, chi " +
                std::to_string(complex.euler()) + (complex.is_closed() ? "" : ", open");
    }
    figure.label({480, 395}, "contracted links: horizontal ones in red, vertical ones in blue; circles: poles in view",
                 "middle", 13);
    figure.save(file);
    return text;
}

/// Fig. 6: a cube unwrapped crosswise; its corners are points of different numbers of nodes.
std::string cube(const std::string &file) {
    const uint32_t n = 4;
    const Net net = Net::from_primitive(Primitive::box({2, 2, 2}, {n, n, n}, gusset::BoxKind::cross));
    const gusset::NetMesh mesh(net);
    const gusset::NetComplex complex(net);
    const std::vector<uint32_t> classes = net.classes();
    std::map<uint32_t, std::size_t> order;
    for (const uint32_t one : classes) {
        ++order[one];
    }
    const auto corner = [&](std::size_t node) {
        const Point3 p = net.at(node / net.columns(), node % net.columns());
        return std::abs(p[0]) == 1 && std::abs(p[1]) == 1 && std::abs(p[2]) == 1;
    };
    Figure figure(960, 440, {0.42, -1, 0.5}, 95);
    const Grid grid(net.rows(), net.columns(), {285, 200}, 29);
    for (const uint32_t cell : mesh.cell_of_face()) {
        const std::size_t i = cell / (net.columns() - 1), j = cell % (net.columns() - 1);
        figure.area({grid.spot(i, j), grid.spot(i, j + 1), grid.spot(i + 1, j + 1), grid.spot(i + 1, j)},
                    {205, 219, 234});
    }
    grid.lines(figure, {faint, 1, ""});
    const std::size_t ones = grid.contracted(figure, net, 2.5);
    std::size_t pairs = 0;
    for (const gusset::Seam &seam : net.seams()) {
        pairs += seam.count;
        const auto run = [&](uint32_t row, uint32_t column, int32_t row_step, int32_t column_step) {
            const auto end = [&](uint32_t start, int32_t step) {
                return static_cast<std::size_t>(static_cast<int64_t>(start) +
                                                static_cast<int64_t>(seam.count - 1) * step);
            };
            figure.line({grid.spot(row, column), grid.spot(end(row, row_step), end(column, column_step))},
                        {violet, 4, ""});
        };
        run(seam.row_a, seam.column_a, seam.row_step_a, seam.column_step_a);
        run(seam.row_b, seam.column_b, seam.row_step_b, seam.column_step_b);
    }
    figure.place(780, 195);
    figure.mesh(mesh.mesh(), [](std::size_t) { return Colour{150, 180, 210}; });
    figure.flush();
    std::map<std::size_t, std::size_t> kinds;
    for (const auto &[first, size] : order) {
        kinds[size] += corner(first) ? 1 : 0;
    }
    // The farthest corner is behind the others.
    const Point3 eye = pictures::unit({0.42, -1, 0.5});
    double farthest = 0;
    for (std::size_t node = 0; node < classes.size(); ++node) {
        if (corner(node)) {
            farthest = std::min(farthest, pictures::dot(net.at(node / net.columns(), node % net.columns()), eye));
        }
    }
    for (std::size_t node = 0; node < classes.size(); ++node) {
        if (!corner(node)) {
            continue;
        }
        figure.dot(grid.spot(node), 4, paper, red, 1.5);
        const Point3 p = net.at(node / net.columns(), node % net.columns());
        if (classes[node] == node && pictures::dot(p, eye) > farthest + 1e-6) {
            const Spot at = figure.at(p);
            figure.dot(at, 4, paper, red, 1.5);
            const double x = at[0] - 780, y = at[1] - 195, length = std::hypot(x, y);
            figure.label({at[0] + 19 * x / length, at[1] + 19 * y / length + 5}, std::to_string(order[classes[node]]),
                         "middle", 16, red);
        }
    }
    figure.label({285, 412}, "the net: cells that stay, contracted links, seams (violet)");
    figure.label({780, 412}, "the cube: how many nodes each corner is");
    figure.save(file);
    std::string text;
    for (const auto &[size, corners] : kinds) {
        text +=
            corners != 0 ? (text.empty() ? "" : ", ") + std::to_string(corners) + " of " + std::to_string(size) : "";
    }
    return "corners by nodes: " + text + "; " + std::to_string(ones) + " ones, " + std::to_string(pairs) +
           " pairs of seams, " + std::to_string(mesh.mesh().face_count()) + " of " +
           std::to_string((net.rows() - 1) * (net.columns() - 1)) + " cells, chi " + std::to_string(complex.euler());
}
} // namespace figures
