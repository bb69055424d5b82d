// PLY files, of text and binary in either order of bytes. Numbers of single precision are rounded to it in text too, as
// in the binary form of the same mesh.
#include "../attributes.hpp"
#include "../failure.hpp"
#include "bytes.hpp"
#include "formats.hpp"
#include "ply_header.hpp"
#include "range_grid.hpp"

#include <algorithm>

namespace {
std::size_t size_of(PlyType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

const char *name_of(PlyType type) {
    constexpr const char *names[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
    return names[static_cast<std::size_t>(type)];
}

/// The values of elements one after the other, of either form.
class Source {
public:
    Source(std::string path_, const std::string &text_, Scanner scanner_, PlyHeader::Form form_)
        : path(std::move(path_)), text(text_), scanner(std::move(scanner_)), form(form_),
          place(std::min(scanner.at() + 1, text_.size())) {}

    double value(PlyType type, const Element &of) {
        if (form == PlyHeader::Form::text) {
            const double number = scanner.number(of);
            return type == PlyType::f32 ? static_cast<double>(static_cast<float>(number)) : number;
        }
        if (place + size_of(type) > text.size()) {
            fail(of, "the file ends there");
        }
        const std::size_t start = place;
        const bool big = form == PlyHeader::Form::big_endian;
        place += size_of(type);
        switch (type) {
        case PlyType::i8:
            return number_at<int8_t>(text, start, big);
        case PlyType::u8:
            return number_at<uint8_t>(text, start, big);
        case PlyType::i16:
            return number_at<int16_t>(text, start, big);
        case PlyType::u16:
            return number_at<uint16_t>(text, start, big);
        case PlyType::i32:
            return number_at<int32_t>(text, start, big);
        case PlyType::u32:
            return number_at<uint32_t>(text, start, big);
        case PlyType::f32:
            return static_cast<double>(number_at<float>(text, start, big));
        default:
            return number_at<double>(text, start, big);
        }
    }

    /// The properties of an element: numbers, and lists with their lengths.
    void row(const PlyElement &element, const Element &of) {
        numbers.assign(element.properties.size(), 0);
        lists.resize(element.properties.size());
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty &property = element.properties[p];
            lists[p].clear();
            if (!property.count) {
                numbers[p] = value(property.type, of);
                continue;
            }
            const double length = value(*property.count, of);
            if (!(length >= 0 && length <= static_cast<double>(text.size()))) {
                fail(of, "a list of impossible length");
            }
            for (std::size_t k = 0; k < static_cast<std::size_t>(length); ++k) {
                lists[p].push_back(value(property.type, of));
            }
        }
    }

    [[noreturn]] void fail(const Element &of, const std::string &why) const {
        if (form == PlyHeader::Form::text) {
            scanner.fail(of, why);
        }
        throw Failure(Exit::file, path + ": " + of.text() + ": " + why);
    }

    std::vector<double> numbers;
    std::vector<std::vector<double>> lists;

private:
    std::string path;
    const std::string &text;
    Scanner scanner;
    PlyHeader::Form form;
    std::size_t place;
};

/// The places of properties that belong together, if all are there.
template <std::size_t N> using Places = std::optional<std::array<std::size_t, N>>;

/// Names the properties of an element that are asked for, and at last those that are not.
class Properties {
public:
    explicit Properties(const PlyElement &element_) : element(element_), used(element_.properties.size()) {}

    std::optional<std::size_t> one(std::initializer_list<const char *> names, bool list) {
        const auto found = element.find(names);
        if (!found || element.properties[*found].count.has_value() != list) {
            return std::nullopt;
        }
        used[*found] = true;
        return found;
    }

    template <std::size_t N> Places<N> together(const std::array<const char *, N> &names) {
        std::array<std::size_t, N> places{};
        for (std::size_t k = 0; k < N; ++k) {
            const auto found = element.find({names[k]});
            if (!found || element.properties[*found].count) {
                return std::nullopt;
            }
            places[k] = *found;
        }
        for (const std::size_t place : places) {
            used[place] = true;
        }
        return places;
    }

    /// The numbers that are not used yet, which become properties of the mesh.
    std::vector<std::size_t> rest(bool of_faces, Mesh &mesh) {
        std::vector<std::size_t> places;
        for (std::size_t p = 0; p < used.size(); ++p) {
            const PlyProperty &property = element.properties[p];
            if (!used[p] && !property.count) {
                used[p] = true;
                places.push_back(p);
                mesh.properties.push_back({property.name, name_of(property.type), of_faces, {}});
            }
        }
        return places;
    }

    /// "confidence and intensity of vertices"; empty if all are used.
    std::string others(const std::string &of) const {
        std::vector<std::string> names;
        for (std::size_t p = 0; p < used.size(); ++p) {
            if (!used[p]) {
                names.push_back(element.properties[p].name);
            }
        }
        std::string text;
        for (std::size_t n = 0; n < names.size(); ++n) {
            text += (n == 0 ? "" : n + 1 == names.size() ? " and " : ", ") + names[n];
        }
        return text.empty() ? text : text + " of " + of;
    }

private:
    const PlyElement &element;
    std::vector<bool> used;
};

/// The colour of a row: bytes, or parts from 0 to 1.
struct Colours {
    Places<3> parts;
    std::optional<std::size_t> opacity;
    double full = 1;

    Colours(const PlyElement &element, Properties &properties)
        : parts(properties.together<3>({"red", "green", "blue"})) {
        if (!parts) {
            parts = properties.together<3>({"diffuse_red", "diffuse_green", "diffuse_blue"});
        }
        if (parts) {
            opacity = properties.one({"alpha", "opacity"}, false);
            const PlyType type = element.properties[(*parts)[0]].type;
            full = type == PlyType::f32 || type == PlyType::f64 ? 1 : type == PlyType::u16 ? 65535 : 255;
        }
    }

    Colour of(const Source &source) const {
        Colour colour = white;
        for (std::size_t k = 0; k < 3; ++k) {
            colour[k] = static_cast<float>(source.numbers[(*parts)[k]] / full);
        }
        if (opacity) {
            colour[3] = static_cast<float>(source.numbers[*opacity] / full);
        }
        return colour;
    }
};

template <std::size_t N> void enter(const Source &source, const Places<N> &places, Attribute<N> &into) {
    if (places) {
        into.at = Attribute<N>::At::vertices;
        into.values.emplace_back();
        for (std::size_t k = 0; k < N; ++k) {
            into.values.back()[k] = source.numbers[(*places)[k]];
        }
    }
}

/// The values of a row for the last properties of the mesh.
void enter_rest(const Source &source, const std::vector<std::size_t> &places, bool of_faces, Mesh &mesh) {
    auto property = std::find_if(mesh.properties.begin(), mesh.properties.end(),
                                 [&](const Property &one) { return one.of_faces == of_faces; });
    for (const std::size_t place : places) {
        (property++)->values.push_back(source.numbers[place]);
    }
}

void note(Mesh &mesh, const std::string &what) {
    if (!what.empty()) {
        mesh.unread.push_back(what);
    }
}

void read_vertices(const std::string &path, Source &source, const PlyElement &element, Mesh &mesh) {
    Properties properties(element);
    const auto position = properties.together<3>({"x", "y", "z"});
    if (!position) {
        throw Failure(Exit::file, path + ": its vertices have no x, y and z");
    }
    const auto normal = properties.together<3>({"nx", "ny", "nz"});
    Places<2> texcoord;
    for (const auto &names : {std::array{"s", "t"}, std::array{"u", "v"}, std::array{"texture_u", "texture_v"}}) {
        texcoord = texcoord ? texcoord : properties.together<2>(names);
    }
    const Colours colours(element, properties);
    const std::vector<std::size_t> more = properties.rest(false, mesh);
    note(mesh, properties.others("vertices"));
    for (std::size_t v = 0; v < element.count; ++v) {
        source.row(element, {"vertex", v});
        mesh.points.push_back(
            {source.numbers[(*position)[0]], source.numbers[(*position)[1]], source.numbers[(*position)[2]]});
        enter(source, normal, mesh.normals);
        enter(source, texcoord, mesh.texcoords);
        if (colours.parts) {
            mesh.vertex_colours.push_back(colours.of(source));
        }
        enter_rest(source, more, false, mesh);
    }
}

/// The texture coordinates of a face's corners; missing if there are not two for each.
void enter_corners(const std::vector<double> &list, std::size_t degree, Attribute<2> &into) {
    for (std::size_t k = 0; k < degree; ++k) {
        if (list.size() == 2 * degree) {
            into.values.push_back({list[2 * k], list[2 * k + 1]});
        } else {
            into.values.push_back(missing<2>());
        }
    }
}

void read_faces(const std::string &path, Source &source, const PlyElement &element, Mesh &mesh) {
    Properties properties(element);
    const auto vertices = properties.one({"vertex_indices", "vertex_index"}, true);
    if (!vertices) {
        throw Failure(Exit::file, path + ": its faces have no list vertex_indices");
    }
    const auto texcoord = properties.one({"texcoord"}, true);
    // The number of an image, of which there is none.
    static_cast<void>(properties.one({"texnumber"}, false));
    const Colours colours(element, properties);
    const std::vector<std::size_t> more = properties.rest(true, mesh);
    note(mesh, properties.others("faces"));
    Attribute<2> texcoords{Attribute<2>::At::corners, {}};
    for (std::size_t f = 0; f < element.count; ++f) {
        const Element of{"face", f};
        source.row(element, of);
        for (const double v : source.lists[*vertices]) {
            if (!(v >= 0 && v < static_cast<double>(mesh.points.size())) ||
                v != static_cast<double>(static_cast<uint32_t>(v))) {
                char name[32];
                std::snprintf(name, sizeof name, "%.17g", v);
                source.fail(of, std::string("it names vertex ") + name + ", and there are " +
                                    std::to_string(mesh.points.size()) + ", from 0 on");
            }
            mesh.corners.push_back(static_cast<uint32_t>(v));
        }
        mesh.offsets.push_back(static_cast<uint32_t>(mesh.corners.size()));
        if (texcoord) {
            enter_corners(source.lists[*texcoord], source.lists[*vertices].size(), texcoords);
        }
        if (colours.parts) {
            mesh.face_colours.push_back(colours.of(source));
        }
        enter_rest(source, more, true, mesh);
    }
    if (texcoord) {
        mesh.texcoords = std::move(texcoords);
    }
}
/// For each place of the grid a vertex, or none.
std::vector<uint32_t> read_grid(Source &source, const PlyElement &element, const Mesh &mesh) {
    std::vector<uint32_t> grid(element.count, unseen);
    for (std::size_t k = 0; k < element.count; ++k) {
        const Element of{"place of the grid", k};
        source.row(element, of);
        if (source.lists.empty() || source.lists[0].empty()) {
            continue;
        }
        const double v = source.lists[0][0];
        if (!(v >= 0 && v < static_cast<double>(mesh.points.size()))) {
            source.fail(of, "it names a vertex that there is not");
        }
        grid[k] = static_cast<uint32_t>(v);
    }
    return grid;
}
} // namespace

Mesh read_ply(const std::string &path) {
    const std::string text = load(path);
    Scanner scanner(path, text);
    const PlyHeader header = read_ply_header(scanner);
    Source source(path, text, scanner, header.form);
    Mesh mesh;
    bool has_vertices = false;
    for (const PlyElement &element : header.elements) {
        if (element.name == "vertex") {
            read_vertices(path, source, element, mesh);
            has_vertices = true;
        } else if (element.name == "face" && has_vertices) {
            read_faces(path, source, element, mesh);
        } else if (element.name == "range_grid" && has_vertices && header.columns > 0 &&
                   element.count == header.rows * header.columns) {
            add_range_faces(mesh, read_grid(source, element, mesh), header.columns);
        } else {
            for (std::size_t k = 0; k < element.count; ++k) {
                source.row(element, {element.name.c_str(), k});
            }
            note(mesh, element.count == 0 ? "" : number_of(element.count, "element") + ' ' + element.name);
        }
    }
    note(mesh, header.textures.empty() ? "" : "textures");
    simplify(mesh);
    return mesh;
}
