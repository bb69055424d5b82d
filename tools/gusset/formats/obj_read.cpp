// OBJ files by tinyobjloader, which reads faces of up to 255 corners. Its numbers are right to some 15 digits only, and
// what is no number is 0 to it; so as it takes line after line, numbers are read here, and it gives the indices:
// borders of two files are found to coincide by the same digits in both.
#include "../attributes.hpp"
#include "../failure.hpp"
#include "formats.hpp"
#include "mtl.hpp"
#include "scanner.hpp"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <filesystem>
#include <istream>
#include <map>
#include <set>
#include <streambuf>

namespace {
constexpr std::size_t most_corners = 255;

/// A file that is handed out by lines, each of which is inspected.
class Lines : public std::streambuf {
public:
    Lines(const std::string &path_, std::string text_) : path(path_), text(std::move(text_)) {
        // Lines that go on after a backslash are one.
        for (std::size_t k = text.find('\\'); k != std::string::npos; k = text.find('\\', k + 1)) {
            const std::size_t end = k + (text.compare(k + 1, 1, "\r") == 0 ? 2 : 1);
            if (text.compare(end, 1, "\n") == 0) {
                std::fill(text.begin() + static_cast<std::ptrdiff_t>(k),
                          text.begin() + static_cast<std::ptrdiff_t>(end + 1), ' ');
            }
        }
        // tinyobjloader writes no further than what it has read.
        char *const start = text.data();
        setg(start, start, start);
    }

    [[noreturn]] void fail(std::size_t line, const std::string &why) const {
        throw Failure(Exit::file, path + ':' + std::to_string(line) + ": " + why);
    }

    std::vector<Point> points;
    /// Those of vertices that have one, else white.
    std::vector<Colour> colours;
    bool coloured = false;
    /// Three numbers each, and two.
    std::vector<double> normals, texcoords;
    /// Of each face of three corners or more.
    std::vector<std::size_t> face_lines;
    std::size_t lines = 0, polylines = 0, dots = 0, small_faces = 0, free_forms = 0;
    std::set<std::string> groups;
    std::vector<std::string> libraries;
    /// Of each face of three corners or more, the number of its material's name; no_material before the first.
    std::vector<uint32_t> face_materials;
    std::vector<std::string> materials;

protected:
    int_type underflow() override {
        char *const start = egptr();
        char *const end = text.data() + text.size();
        if (start == end) {
            return traits_type::eof();
        }
        char *const stop = std::find(start, end, '\n');
        ++lines;
        inspect(std::string_view(start, static_cast<std::size_t>(stop - start)));
        setg(start, start, stop == end ? end : stop + 1);
        return traits_type::to_int_type(*start);
    }

private:
    double number(std::string_view word, const Element &of) const {
        const auto value = number_in(word);
        if (!value) {
            fail(lines, of.text() + ": \"" + std::string(word) + "\" is no number");
        }
        return *value;
    }

    void vertex(const std::vector<std::string_view> &words) {
        const Element of{"vertex", points.size()};
        std::vector<double> numbers;
        for (std::size_t w = 1; w < words.size() && words[w][0] != '#'; ++w) {
            numbers.push_back(number(words[w], of));
        }
        if (numbers.size() < 3) {
            fail(lines, of.text() + ": it has " + number_of(numbers.size(), "coordinate"));
        }
        points.push_back({numbers[0], numbers[1], numbers[2]});
        colours.push_back(white);
        if (numbers.size() >= 6) {
            coloured = true;
            for (std::size_t k = 0; k < std::min<std::size_t>(4, numbers.size() - 3); ++k) {
                colours.back()[k] = static_cast<float>(numbers[3 + k]);
            }
        }
    }

    /// `count` numbers, 0 where there are fewer.
    void enter(const std::vector<std::string_view> &words, const char *name, std::size_t count,
               std::vector<double> &into) {
        const Element of{name, into.size() / count};
        for (std::size_t k = 0; k < count; ++k) {
            into.push_back(k + 1 < words.size() && words[k + 1][0] != '#' ? number(words[k + 1], of) : 0);
        }
    }

    void inspect(std::string_view line) {
        const auto words = words_of(line);
        if (words.empty() || words[0][0] == '#') {
            return;
        }
        const std::string_view what = words[0];
        if (what == "v") {
            vertex(words);
        } else if (what == "vn" || what == "vt") {
            enter(words, what == "vn" ? "normal" : "texture coordinate", what == "vn" ? 3 : 2,
                  what == "vn" ? normals : texcoords);
        } else if (what == "f") {
            if (words.size() - 1 > most_corners) {
                fail(lines, Element{"face", face_lines.size()}.text() + ": it has more than 255 corners");
            }
            if (words.size() < 4) {
                ++small_faces;
            } else {
                face_lines.push_back(lines);
                face_materials.push_back(material);
            }
        } else if (what == "l") {
            ++polylines;
        } else if (what == "p") {
            ++dots;
        } else if (what == "mtllib") {
            libraries.push_back(behind(line, words));
        } else if (what == "usemtl") {
            const std::string name = behind(line, words);
            const auto found = std::find(materials.begin(), materials.end(), name);
            material = static_cast<uint32_t>(found - materials.begin());
            if (found == materials.end()) {
                materials.push_back(name);
            }
        } else if (what == "g" || what == "o") {
            groups.emplace(line);
        } else if (what == "curv" || what == "curv2" || what == "surf" || what == "vp") {
            ++free_forms;
        }
    }

    /// All of a line but the first word.
    static std::string behind(std::string_view line, const std::vector<std::string_view> &words) {
        if (words.size() < 2) {
            return "";
        }
        const auto start = static_cast<std::size_t>(words[1].data() - line.data());
        const auto end = static_cast<std::size_t>(words.back().data() - line.data()) + words.back().size();
        return std::string(line.substr(start, end - start));
    }

    std::string path, text;
    uint32_t material = no_material;
};

struct Obj {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
};

Obj parse(Lines &lines) {
    std::istream stream(&lines);
    // What is wrong with a line is thrown by it, through the stream.
    stream.exceptions(std::ios::badbit);
    Obj obj;
    std::vector<tinyobj::material_t> materials;
    std::string warnings, error;
    // Without a reader of materials; and faces stay polygons.
    if (!tinyobj::LoadObj(&obj.attributes, &obj.shapes, &materials, &warnings, &error, &stream, nullptr, false,
                          false)) {
        lines.fail(lines.lines, "a vertex is numbered 0, or from the end by more than there are");
    }
    return obj;
}

/// Values by the indices of corners, -1 for none.
template <std::size_t N> Attribute<N> at_indices(const std::vector<double> &values, const std::vector<int> &indices) {
    Attribute<N> made;
    if (std::all_of(indices.begin(), indices.end(), [](int index) { return index < 0; })) {
        return made;
    }
    made.at = Attribute<N>::At::corners;
    for (const int index : indices) {
        made.values.push_back(missing<N>());
        for (std::size_t k = 0; index >= 0 && k < N; ++k) {
            made.values.back()[k] = values[N * static_cast<std::size_t>(index) + k];
        }
    }
    return made;
}

/// Of all corners, -1 for none.
struct Indices {
    std::vector<int> normals, texcoords;
};

void check(const Lines &lines, std::size_t face, int index, std::size_t count, const char *what, bool needed) {
    if (index < (needed ? 0 : -1) || (index >= 0 && static_cast<std::size_t>(index) >= count)) {
        lines.fail(lines.face_lines[face], Element{"face", face}.text() + ": it names " + what + ' ' +
                                               std::to_string(index + 1) + ", and there are " + std::to_string(count));
    }
}

/// Those that faces use, with what their libraries say of them.
void add_materials(const std::string &path, const Lines &lines, Mesh &mesh) {
    std::map<std::string, Material> known;
    const auto folder = std::filesystem::path(path).parent_path();
    const auto read = [&](std::string name) {
        // As Windows writes them.
        std::replace(name.begin(), name.end(), '\\', '/');
        return read_mtl((folder / name).string(), known);
    };
    for (const std::string &library : lines.libraries) {
        // One file whose name may have spaces, or several.
        if (read(library)) {
            continue;
        }
        for (const std::string_view word : words_of(library)) {
            if (!read(std::string(word))) {
                mesh.unread.push_back("the materials in " + std::string(word) + ", which is not there,");
            }
        }
    }
    if (lines.materials.empty()) {
        return;
    }
    std::vector<uint32_t> numbers;
    for (const std::string &name : lines.materials) {
        const auto found = known.find(name);
        // Names that files have for none.
        const bool none = found == known.end() && (name.empty() || name == "none" || name == "None" || name == "(null)" ||
                                                   name == "(none)");
        numbers.push_back(none ? no_material : static_cast<uint32_t>(mesh.materials.size()));
        if (found != known.end()) {
            mesh.materials.push_back(found->second);
        } else if (!none) {
            mesh.materials.emplace_back();
            mesh.materials.back().name = name;
        }
    }
    for (const uint32_t material : lines.face_materials) {
        mesh.face_materials.push_back(material == no_material ? no_material : numbers[material]);
    }
}

void scale(std::vector<Colour> &colours) {
    const bool bytes = std::any_of(colours.begin(), colours.end(), [](const Colour &colour) {
        return std::any_of(colour.begin(), colour.begin() + 3, [](float part) { return part > 1; });
    });
    for (Colour &colour : colours) {
        for (std::size_t k = 0; bytes && k < 3; ++k) {
            colour[k] /= 255;
        }
    }
}
} // namespace

Mesh read_obj(const std::string &path) {
    Lines lines(path, load(path));
    const Obj obj = parse(lines);
    Mesh mesh;
    Indices indices;
    mesh.points = std::move(lines.points);
    for (const tinyobj::shape_t &shape : obj.shapes) {
        auto next = shape.mesh.indices.begin();
        for (const auto degree : shape.mesh.num_face_vertices) {
            const std::size_t face = mesh.face_count();
            for (const auto end = next + degree; next != end; ++next) {
                check(lines, face, next->vertex_index, mesh.points.size(), "vertex", true);
                check(lines, face, next->normal_index, lines.normals.size() / 3, "normal", false);
                check(lines, face, next->texcoord_index, lines.texcoords.size() / 2, "texture coordinate", false);
                mesh.corners.push_back(static_cast<uint32_t>(next->vertex_index));
                indices.normals.push_back(next->normal_index);
                indices.texcoords.push_back(next->texcoord_index);
            }
            mesh.offsets.push_back(static_cast<uint32_t>(mesh.corners.size()));
        }
    }
    mesh.normals = at_indices<3>(lines.normals, indices.normals);
    mesh.texcoords = at_indices<2>(lines.texcoords, indices.texcoords);
    if (lines.coloured) {
        mesh.vertex_colours = std::move(lines.colours);
        scale(mesh.vertex_colours);
    }
    add_materials(path, lines, mesh);
    const auto note = [&](bool there, const std::string &what) {
        if (there) {
            mesh.unread.push_back(what);
        }
    };
    note(lines.groups.size() > 1, "names of objects and groups");
    note(lines.polylines > 0, number_of(lines.polylines, "polyline"));
    note(lines.dots > 0, "points");
    note(lines.small_faces > 0, number_of(lines.small_faces, "face") + " of fewer than three corners");
    note(lines.free_forms > 0, "free-form curves and surfaces");
    simplify(mesh);
    return mesh;
}

Curves read_obj_lines(const std::string &path) {
    Lines lines(path, load(path));
    const Obj obj = parse(lines);
    Curves curves;
    for (const tinyobj::shape_t &shape : obj.shapes) {
        auto next = shape.lines.indices.begin();
        for (const int length : shape.lines.num_line_vertices) {
            const auto end = next + length;
            const bool closed = length > 1 && next->vertex_index == (end - 1)->vertex_index;
            for (; next != end - (closed ? 1 : 0); ++next) {
                const auto v = static_cast<std::size_t>(next->vertex_index);
                if (next->vertex_index < 0 || v >= lines.points.size()) {
                    throw Failure(Exit::file, path + ": " + Element{"line", curves.closed.size()}.text() +
                                                  ": it names vertex " + std::to_string(next->vertex_index + 1) +
                                                  ", and there are " + std::to_string(lines.points.size()));
                }
                curves.points.push_back(lines.points[v]);
            }
            next = end;
            curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
            curves.closed.push_back(closed);
        }
    }
    if (curves.closed.empty()) {
        throw Failure(Exit::file, path + ": it has no lines (l)");
    }
    return curves;
}
