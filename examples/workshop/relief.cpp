// From a range image to a clean mesh: steps from one surface to another are left open, small holes are filled.
//   relief [heights.csv] [--spacing 10] [--picture relief.svg] [--mesh relief.off] [--page NAME]
// The file has a row of heights on each line; cells that are empty or not numbers are missing. Without one, or with
// -, the image
// is made by formula: hills with a block and a drum on them, noise, and pixels that are missing. Some pixels of the
// file are removed, so that filled heights can be compared with known ones.
#include "workshop.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace {
using namespace workshop;

/// Heights row after row, NaN where nothing was seen, and the true height of any place, in steps of the image.
struct Image {
    std::size_t rows = 0, columns = 0;
    double spacing = 1, noise = 0;
    std::vector<double> heights;
    std::function<double(double, double)> truth;
};

/// The same numbers everywhere.
class Random {
public:
    double operator()() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) / 9007199254740992.0;
    }

private:
    std::uint64_t state_ = 2024;
};

/// Takes out one pixel in fifty, and some patches that keep away from where `busy` says.
void take_out(Image &image, Random &random, const std::function<bool(double, double)> &busy) {
    for (double &height : image.heights) {
        height = random() < 0.02 ? NAN : height;
    }
    for (int made = 0; made < 6;) {
        const double wide = static_cast<double>(image.columns), deep = static_cast<double>(image.rows);
        const double x = random() * wide, y = random() * deep, radius = 1.5 + 2 * random();
        if (x < 7 || y < 7 || x > wide - 7 || y > deep - 7 || busy(x, y)) {
            continue;
        }
        for (std::size_t i = 0; i < image.rows; ++i) {
            for (std::size_t j = 0; j < image.columns; ++j) {
                if (std::hypot(static_cast<double>(i) - y, static_cast<double>(j) - x) < radius) {
                    image.heights[i * image.columns + j] = NAN;
                }
            }
        }
        ++made;
    }
}

double hills(double x, double y) {
    return 2.2 * std::sin(0.11 * x + 0.4) * std::cos(0.135 * y) + 0.8 * std::sin(0.2 * (x + y));
}
bool on_block(double x, double y) {
    return std::abs(x - 18) + 0.4 * std::abs(y - 23) < 9.6 && std::abs(y - 23) < 10.5;
}
bool on_drum(double x, double y) { return std::hypot(x - 46, y - 20) < 8.3; }

Image heights_by_formula() {
    Image image{46, 66, 1, 0.05, {}, {}};
    image.truth = [](double x, double y) {
        return on_block(x, y)  ? 12 + 0.1 * (x - 18)
               : on_drum(x, y) ? 9 + std::sqrt(std::max(0.0, 120 - std::pow(x - 46, 2))) / 4
                               : hills(x, y);
    };
    Random random;
    for (std::size_t i = 0; i < image.rows; ++i) {
        for (std::size_t j = 0; j < image.columns; ++j) {
            // The sum of twelve even numbers is nearly normal.
            double noise = -6;
            for (int k = 0; k < 12; ++k) {
                noise += random();
            }
            image.heights.push_back(image.truth(static_cast<double>(j), static_cast<double>(i)) + image.noise * noise);
        }
    }
    take_out(image, random, [](double x, double y) {
        int around = 0;
        for (int k = 0; k < 16; ++k) {
            const double a = 0.39269908169872414 * k, u = x + 5.5 * std::cos(a), v = y + 5.5 * std::sin(a);
            around += on_block(u, v) || on_drum(u, v) ? 1 : 0;
        }
        return around != 0 && around != 16;
    });
    return image;
}

Image read_heights(const std::string &file, double spacing) {
    std::ifstream in(file);
    Image image;
    image.spacing = spacing;
    for (std::string line; std::getline(in, line); ++image.rows) {
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) {
            char *end = nullptr;
            const double height = std::strtod(cell.c_str(), &end);
            image.heights.push_back(end == cell.c_str() ? NAN : height);
        }
    }
    if (image.rows < 16 || image.heights.size() % image.rows != 0 || image.heights.size() / image.rows < 16) {
        throw std::runtime_error(file + ": no image of 16 x 16 heights or more");
    }
    image.columns = image.heights.size() / image.rows;
    image.truth = [whole = image.heights, rows = image.rows, columns = image.columns](double x, double y) {
        const auto i = std::min(static_cast<std::size_t>(std::max(y, 0.0)), rows - 2);
        const auto j = std::min(static_cast<std::size_t>(std::max(x, 0.0)), columns - 2);
        const double v = y - static_cast<double>(i), u = x - static_cast<double>(j);
        const double *at = &whole[i * columns + j];
        return (1 - v) * ((1 - u) * at[0] + u * at[1]) + v * ((1 - u) * at[columns] + u * at[columns + 1]);
    };
    Random random;
    take_out(image, random, [](double, double) { return false; });
    return image;
}

/// The root of the mean square of the distances in height from the truth, of vertices `first` and after.
double rms(const MeshView &mesh, const Image &image, std::size_t first) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t v = first; v < mesh.vertex_count(); ++v) {
        const Point3 p = mesh.position(v);
        const double off = p[2] - image.truth(p[0] / image.spacing, p[1] / image.spacing);
        if (std::isfinite(off)) {
            sum += off * off;
            ++count;
        }
    }
    return count != 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

/// Prints what a mesh is, and returns the number of its loops.
std::size_t describe(const char *what, const MeshView &mesh) {
    const gusset::Boundary loops(mesh);
    const gusset::Check check(mesh);
    const gusset::Orient parts(mesh);
    std::cout << what << mesh.vertex_count() << " vertices, " << mesh.face_count() << " faces, "
              << parts.component_count() << " components, " << loops.size() << " loops, Euler characteristic "
              << euler(mesh) << ", " << check.view().non_manifold_vertices.count << " bow-ties, smallest angle "
              << smallest_angle(mesh) << " degrees\n";
    return loops.size();
}

/// Before and after: filled faces are green, borders red.
void draw(const MeshView &raw, const MeshView &clean, const Image &image, const std::string &file) {
    const double wide = image.spacing * static_cast<double>(image.columns);
    const double deep = image.spacing * static_cast<double>(image.rows);
    const auto [low, high] = std::minmax_element(image.heights.begin(), image.heights.end(), [](double a, double b) {
        return std::isfinite(a) && std::isfinite(b) && a < b; // what is missing is neither
    });
    const double scale = 396 / std::hypot(wide, 0.32 * deep);
    pictures::Drawing drawing(960, 400, {0.3, -1, 0.85}, scale);
    drawing.add("<g stroke-width='0.12'>\n");
    for (const auto &[mesh, x, caption] : {std::tuple(&raw, 240.0, "as it was seen, without faces across steps"),
                                           std::tuple(&clean, 720.0, "small holes filled, steps left open")}) {
        drawing.place(0, 0);
        const auto at = drawing.at({wide / 2, deep / 2, (*low + *high) / 2});
        drawing.place(x - at[0], 190 - at[1]);
        drawing.mesh(*mesh, [&](std::size_t f) { return f < raw.face_count() ? pictures::blue : pictures::green; });
        page::Body borders;
        add_borders(borders, *mesh, "", 0);
        for (const page::Curve &border : borders.curves) {
            drawing.curve(border.points, true, pictures::red, 1.1, 0.02 * wide);
        }
        drawing.caption(x, 388, caption);
    }
    drawing.add("</g>\n");
    save(drawing, file);
}
/// Both for a page; filled faces show their distance to the known surface.
page::Showcase show(const MeshView &raw, const MeshView &clean, const Image &image, const std::string &text) {
    page::Showcase shown;
    shown.id = "relief";
    shown.title = "A range image";
    shown.text = "Heights of a grid, some missing: to a mesh without faces across steps, whose small holes are filled.";
    shown.paints = {{"seen", "#8fa3b3", 0, 0.5}, {"filled", "#d99a1c", 0.4, 0.35, true}};
    shown.eye = {0.3, -1, 0.85};
    shown.up = {0, 0, 1};
    shown.pairs = {{0, 1}};
    shown.bodies.resize(2);
    double largest = 0;
    for (const MeshView *mesh : {&raw, &clean}) {
        page::Body &body = shown.bodies[mesh == &raw ? 0 : 1];
        body.add(*mesh, [&](std::size_t f) { return f < raw.face_count() ? 0 : 1; });
        add_borders(body, *mesh, "#b0402a", 0.25 * image.spacing);
        for (const Point3 &p : body.points) {
            const double off = std::abs(p[2] - image.truth(p[0] / image.spacing, p[1] / image.spacing));
            body.distances.push_back(std::isfinite(off) ? off : -1);
        }
    }
    for (std::size_t v = raw.vertex_count(); v < clean.vertex_count(); ++v) {
        largest = std::max(largest, shown.bodies[1].distances[v]);
    }
    shown.distance_limit = shown.distance_shown = largest;
    shown.distance_unit = "in the unit of heights";
    shown.states = {{"As it was seen", 0, {}, "Its borders are red."}, {"Clean", 1, {}, text}};
    return shown;
}
} // namespace

int main(int argc, char **argv) try {
    CLI::App app("From a range image to a clean mesh.");
    std::string input = "-", picture, file, page;
    double ratio = 4, spacing = 1;
    uint32_t edges = 40;
    app.add_option("heights", input, "a CSV file, or - for an image by formula");
    app.add_option("--spacing", spacing, "how far pixels of a file are apart, in the unit of its heights");
    app.add_option("--max-edge", ratio, "how long an edge may be, in those of the middle length");
    app.add_option("--max-rim", edges, "how many edges the rim of a small hole has at the most");
    app.add_option("--picture", picture, "an SVG file of the mesh before and after");
    app.add_option("--mesh", file, "an OFF file of the mesh");
    app.add_option("--page", page, "both for scripts/page.py, NAME.json and NAME.bin");
    CLI11_PARSE(app, argc, argv);

    Claims claims;
    const Image image = input == "-" ? heights_by_formula() : read_heights(input, spacing);
    //! [relief]
    gusset::HeightOptions grid;
    grid.spacing = {image.spacing, image.spacing};
    const gusset::Net net = gusset::Net::from_heights(image.rows, image.columns, image.heights.data(), grid);
    gusset::NetMeshOptions triangles;
    triangles.faces = gusset::NetFaces::triangles_shorter;
    triangles.fill_corners = true;
    triangles.max_edge_ratio = ratio; // omits faces across steps between surfaces
    const gusset::NetMesh raw(net, triangles);
    gusset::FillOptions small;
    small.refine = gusset::FillRefinement::rim_density;
    small.fairing = gusset::Fairing::thin_plate;
    small.max_edges = edges; // the border of the image, and those along steps, are longer
    const gusset::Fill clean(raw.mesh(), small);
    //! [relief]

    const std::size_t missing = static_cast<std::size_t>(
        std::count_if(image.heights.begin(), image.heights.end(), [](double height) { return std::isnan(height); }));
    std::cout << image.rows << " x " << image.columns << " pixels, " << missing << " missing\n";
    describe("before: ", raw.mesh());
    const std::size_t loops = describe("after:  ", clean.mesh());
    std::size_t filled = 0, large = 0, outlines = 0;
    for (const gusset_hole &hole : clean.holes()) {
        filled += hole.status == GUSSET_HOLE_FILLED ? 1 : 0;
        large += hole.status == GUSSET_HOLE_TOO_LARGE ? 1 : 0;
        outlines += hole.status == GUSSET_HOLE_KEPT ? 1 : 0;
    }
    const double seen = rms(raw.mesh(), image, 0), made = rms(clean.mesh(), image, raw.mesh().vertex_count());
    std::cout << filled << " holes filled, " << large << " and " << outlines << " outlines left; off the truth by " << seen
              << " where it was seen, by " << made << " where it was filled (root mean square)\n";

    claims.hold(filled + large + outlines == clean.holes().size() && loops == large + outlines, "all small holes are filled");
    const gusset::Check check(clean.mesh());
    claims.hold(check.is_manifold() && check.is_oriented(), "the mesh is an oriented manifold");
    if (input == "-") {
        claims.hold(gusset::Orient(clean.mesh()).component_count() == 3 && loops == 5,
                    "the hills with two holes, the block, and the drum");
        claims.hold(std::abs(percent(seen, image.noise)) < 5, "what was seen is off by the noise");
        claims.hold(made < 1.5 * image.noise, "what was filled is not much worse than what was seen");
    } else {
        claims.hold(seen < 1e-9 && made < 0.5 * image.spacing, "what was filled is within half a pixel");
    }
    if (!picture.empty()) {
        draw(raw.mesh(), clean.mesh(), image, picture);
    }
    save(clean.mesh(), file);
    save(show(raw.mesh(), clean.mesh(), image,
              said(filled, " holes filled, ", large, " and ", outlines, " outlines left open; off the truth by ", seen, " where it was seen, by ", made,
                   " where it was filled (root mean square).")),
         page);
    return claims.status();
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
