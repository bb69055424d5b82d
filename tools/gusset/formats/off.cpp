// OFF files: Geomview's, in which normals, colours and texture coordinates follow a vertex's position in this order,
// and colours follow a face; and MeshLab's NCOFF, in which colours come before normals.
#include "../attributes.hpp"
#include "../failure.hpp"
#include "formats.hpp"
#include "scanner.hpp"
#include "writer.hpp"

#include <algorithm>
#include <cmath>

namespace {
struct Header {
    bool texcoords = false, colours = false, normals = false;
    /// Normals are named before colours, as MeshLab does.
    bool normals_named_first = false;
    bool homogeneous = false;
};

/// The letters before OFF; nothing if it is no such word.
std::optional<Header> header_of(std::string_view word) {
    if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") {
        return std::nullopt;
    }
    word.remove_suffix(3);
    Header header;
    while (!word.empty()) {
        if (word.substr(0, 2) == "ST") {
            header.texcoords = true;
            word.remove_prefix(1);
        } else if (word[0] == 'C') {
            header.colours = true;
        } else if (word[0] == 'N') {
            header.normals = true;
            header.normals_named_first = !header.colours;
        } else if (word[0] == '4') {
            header.homogeneous = true;
        } else {
            return std::nullopt;
        }
        word.remove_prefix(1);
    }
    return header;
}

/// The numbers behind the positions, row after row.
struct Rows {
    std::vector<double> numbers;
    std::size_t width = 0;
    double at(std::size_t row, std::size_t place) const { return numbers[row * width + place]; }
    std::size_t count() const { return width == 0 ? 0 : numbers.size() / width; }
};

bool are_bytes(const Rows &rows, std::size_t first, std::size_t count) {
    for (std::size_t row = 0; row < rows.count(); ++row) {
        for (std::size_t k = first; k < first + count; ++k) {
            const double x = rows.at(row, k);
            if (!(x >= 0 && x <= 255) || x != std::floor(x)) {
                return false;
            }
        }
    }
    return true;
}

/// Whether all vectors have a length of 1, or 0.
bool are_units(const Rows &rows, std::size_t first) {
    for (std::size_t row = 0; row < rows.count(); ++row) {
        const double length = std::hypot(rows.at(row, first), rows.at(row, first + 1), rows.at(row, first + 2));
        if (!(std::abs(length - 1) < 1e-3) && length != 0) {
            return false;
        }
    }
    return true;
}

/// Steps of 256, unless none is above 1; what is missing is 1.
std::vector<Colour> colours_of(const Rows &rows, std::size_t first, std::size_t count) {
    double greatest = 0;
    for (std::size_t row = 0; row < rows.count(); ++row) {
        for (std::size_t k = first; k < first + count; ++k) {
            greatest = std::max(greatest, rows.at(row, k));
        }
    }
    std::vector<Colour> colours(rows.count(), white);
    for (std::size_t row = 0; row < rows.count(); ++row) {
        for (std::size_t k = 0; k < count; ++k) {
            const double part = rows.at(row, first + k);
            colours[row][k] = std::isnan(part) ? 1 : static_cast<float>(part / (greatest > 1 ? 255 : 1));
        }
    }
    return colours;
}

template <std::size_t N> Attribute<N> attribute_of(const Rows &rows, std::size_t first) {
    Attribute<N> made{Attribute<N>::At::vertices, {}};
    for (std::size_t row = 0; row < rows.count(); ++row) {
        made.values.emplace_back();
        for (std::size_t k = 0; k < N; ++k) {
            made.values.back()[k] = rows.at(row, first + k);
        }
    }
    return made;
}

void enter(Mesh &mesh, const Header &header, const Rows &rows, std::size_t parts) {
    // Where both are there, the numbers decide and the header when they cannot.
    bool colours_first = header.normals && header.colours && header.normals_named_first && are_bytes(rows, 0, parts);
    if (colours_first && are_units(rows, 0) && !are_units(rows, parts)) {
        colours_first = false;
    }
    std::size_t place = colours_first ? parts : 0;
    if (header.normals) {
        mesh.normals = attribute_of<3>(rows, place);
        place += 3;
    }
    if (header.colours) {
        mesh.vertex_colours = colours_of(rows, colours_first ? 0 : place, parts);
        place += colours_first ? 0 : parts;
    }
    if (header.texcoords) {
        mesh.texcoords = attribute_of<2>(rows, place);
    }
}

std::vector<double> numbers_of_line(Scanner &scanner, const Element &of) {
    std::vector<double> numbers;
    for (auto word = scanner.word_of_line(); !word.empty(); word = scanner.word_of_line()) {
        const auto value = number_in(word);
        if (!value) {
            scanner.fail(of, '"' + std::string(word) + "\" is no number");
        }
        numbers.push_back(*value);
    }
    return numbers;
}

void read_vertices(Scanner &scanner, const Header &header, Mesh &mesh, std::size_t count) {
    const std::size_t others = (header.normals ? 3U : 0U) + (header.texcoords ? 2U : 0U);
    Rows rows;
    std::size_t parts = 0;
    for (std::size_t v = 0; v < count; ++v) {
        const Element of{"vertex", v};
        Point point;
        for (double &x : point) {
            x = scanner.number(of);
        }
        if (header.homogeneous) {
            const double w = scanner.number(of);
            for (double &x : point) {
                x /= w;
            }
        }
        mesh.points.push_back(point);
        if (v == 0) {
            // The first line tells whether colours have three parts or four.
            rows.numbers = numbers_of_line(scanner, of);
            const std::size_t behind = rows.numbers.size();
            parts = header.colours && behind > others ? behind - others : 0;
            if (header.colours ? parts != 3 && parts != 4 : behind < others) {
                scanner.fail(of, "it has " + number_of(behind, "number") +
                                     " behind its position, which does not fit the word before OFF");
            }
            rows.width = others + parts;
            rows.numbers.resize(rows.width);
            if (behind > rows.width) {
                mesh.unread.emplace_back("numbers behind the positions of vertices");
            }
        } else {
            for (std::size_t k = 0; k < rows.width; ++k) {
                rows.numbers.push_back(scanner.number(of));
            }
            static_cast<void>(scanner.rest_of_line());
        }
    }
    enter(mesh, header, rows, parts);
}

void read_faces(Scanner &scanner, Mesh &mesh, std::size_t count) {
    Rows colours{{}, 4};
    bool coloured = false;
    for (std::size_t f = 0; f < count; ++f) {
        const Element of{"face", f};
        const std::size_t degree = scanner.index(of, UINT32_MAX);
        for (std::size_t k = 0; k < degree; ++k) {
            const std::size_t v = scanner.index(of, UINT32_MAX);
            if (v >= mesh.points.size()) {
                scanner.fail(of, "it names vertex " + std::to_string(v) + ", and there are " +
                                     std::to_string(mesh.points.size()) + ", from 0 on");
            }
            mesh.corners.push_back(static_cast<uint32_t>(v));
        }
        mesh.offsets.push_back(static_cast<uint32_t>(mesh.corners.size()));
        std::vector<double> parts = numbers_of_line(scanner, of);
        // A single number is a place in a table of colours, which the file does not have.
        coloured = coloured || parts.size() >= 3;
        parts.resize(parts.size() >= 3 ? std::min<std::size_t>(parts.size(), 4) : 0);
        parts.resize(4, std::nan(""));
        colours.numbers.insert(colours.numbers.end(), parts.begin(), parts.end());
    }
    if (coloured) {
        mesh.face_colours = colours_of(colours, 0, 4);
    }
}

void write_colour(Writer &out, const Colour &colour, bool steps, bool opacity) {
    for (std::size_t k = 0; k < (opacity ? 4 : 3); ++k) {
        out << ' ';
        if (steps) {
            out << uint32_t{step_of(colour[k])};
        } else {
            out << static_cast<double>(colour[k]);
        }
    }
}
} // namespace

Mesh read_off(const std::string &path) {
    const std::string text = load(path);
    Scanner scanner(path, text, '#');
    std::string_view word = scanner.word();
    std::optional<Header> header = header_of(word);
    Scanner counts = scanner;
    if (!header) {
        // The word may be left out.
        if (!number_in(word)) {
            scanner.fail(word.empty() ? "the file is empty" : "it does not begin with OFF");
        }
        header = Header{};
        counts = Scanner(path, text, '#');
    }
    scanner = counts;
    if (Scanner ahead = scanner; ahead.word_of_line() == "BINARY") {
        scanner.fail("binary OFF files are not read");
    }
    Mesh mesh;
    const std::size_t vertices = scanner.index({"count", 0}, UINT32_MAX - 1);
    const std::size_t faces = scanner.index({"count", 1}, UINT32_MAX - 1);
    // Of edges, which nobody needs; it may be left out.
    static_cast<void>(scanner.rest_of_line());
    read_vertices(scanner, *header, mesh, vertices);
    read_faces(scanner, mesh, faces);
    return mesh;
}

Losses write_off(const std::string &path, const Mesh &mesh) {
    Losses losses;
    const auto normals = mesh.normals ? at_vertices(mesh, mesh.normals) : std::nullopt;
    const auto texcoords = mesh.texcoords ? at_vertices(mesh, mesh.texcoords) : std::nullopt;
    if (mesh.normals && !normals) {
        losses.emplace_back("normals that differ at the corners of a vertex: OFF files hold one for each vertex");
    }
    if (mesh.texcoords && !texcoords) {
        losses.emplace_back(
            "texture coordinates that differ at the corners of a vertex: OFF files hold one pair for each vertex");
    }
    const bool coloured = !mesh.vertex_colours.empty();
    const bool steps = are_steps(mesh.vertex_colours), face_steps = are_steps(mesh.face_colours);
    const bool opaque = are_opaque(mesh.face_colours);
    Writer out(path);
    out << (texcoords ? "ST" : "") << (coloured ? "C" : "") << (normals ? "N" : "") << "OFF\n"
        << static_cast<uint32_t>(mesh.points.size()) << ' ' << static_cast<uint32_t>(mesh.face_count()) << " 0\n";
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const Point &p = mesh.points[v];
        out << p[0] << ' ' << p[1] << ' ' << p[2];
        for (std::size_t k = 0; normals && k < 3; ++k) {
            out << ' ' << (*normals)[v][k];
        }
        if (coloured) {
            write_colour(out, mesh.vertex_colours[v], steps, true);
        }
        for (std::size_t k = 0; texcoords && k < 2; ++k) {
            out << ' ' << (*texcoords)[v][k];
        }
        out << '\n';
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        out << static_cast<uint32_t>(mesh.degree(f));
        for (uint32_t c = mesh.offsets[f]; c < mesh.offsets[f + 1]; ++c) {
            out << ' ' << mesh.corners[c];
        }
        if (!mesh.face_colours.empty()) {
            write_colour(out, mesh.face_colours[f], face_steps, !opaque);
        }
        out << '\n';
    }
    out.finish();
    return losses;
}
