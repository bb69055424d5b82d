// PLY files, binary or of text: numbers in single precision where that is enough for all of a kind.
#include "../attributes.hpp"
#include "formats.hpp"
#include "writer.hpp"

#include <algorithm>
#include <limits>

namespace {
/// A kind of numbers, and how they are written.
struct Numbers {
    Writer &out;
    bool text, single;

    void write(double value) const {
        const double shown = value == value ? value : 0;
        if (text) {
            out << ' ' << shown;
        } else if (single) {
            out.raw(static_cast<float>(shown));
        } else {
            out.raw(shown);
        }
    }
    const char *type() const { return single ? "float " : "double "; }
};

template <std::size_t N> bool is_single(const std::vector<std::array<double, N>> &values) {
    return std::all_of(values.begin(), values.end(), [](const auto &value) {
        return std::all_of(value.begin(), value.end(), [](double x) { return ::is_single(x); });
    });
}

void announce(Writer &out, const char *type, std::initializer_list<const char *> names) {
    for (const char *name : names) {
        out << "property " << type << name << '\n';
    }
}

void announce_colours(Writer &out, const std::vector<Colour> &colours, bool opaque) {
    if (!colours.empty()) {
        announce(out, "uchar ", {"red", "green", "blue"});
        announce(out, "uchar ",
                 opaque ? std::initializer_list<const char *>{} : std::initializer_list<const char *>{"alpha"});
    }
}

void write_ply_colour(Writer &out, const Colour &colour, bool opaque, bool text) {
    for (std::size_t k = 0; k < (opaque ? 3 : 4); ++k) {
        if (text) {
            out << ' ' << uint32_t{step_of(colour[k])};
        } else {
            out.raw(step_of(colour[k]));
        }
    }
}

void announce_properties(Writer &out, const Mesh &mesh, bool of_faces) {
    for (const Property &property : mesh.properties) {
        if (property.of_faces == of_faces) {
            out << "property " << property.type << ' ' << property.name << '\n';
        }
    }
}

/// A number as its type has it, the nearest that it can hold.
template <class T> void write_as(Writer &out, double value) {
    constexpr auto low = static_cast<double>(std::numeric_limits<T>::lowest());
    constexpr auto high = static_cast<double>(std::numeric_limits<T>::max());
    out.raw(static_cast<T>(value == value ? std::clamp(value, low, high) : 0));
}

void write_properties(Writer &out, const Mesh &mesh, bool of_faces, std::size_t k, bool text) {
    for (const Property &property : mesh.properties) {
        if (property.of_faces != of_faces) {
            continue;
        }
        const double value = property.values[k];
        const std::string &type = property.type;
        if (text && value != value) {
            out << " nan";
        } else if (text) {
            out << ' ' << value;
        } else if (type == "float") {
            out.raw(static_cast<float>(value));
        } else if (type == "double") {
            out.raw(value);
        } else if (type == "uchar") {
            write_as<uint8_t>(out, value);
        } else if (type == "char") {
            write_as<int8_t>(out, value);
        } else if (type == "ushort") {
            write_as<uint16_t>(out, value);
        } else if (type == "short") {
            write_as<int16_t>(out, value);
        } else if (type == "uint") {
            write_as<uint32_t>(out, value);
        } else {
            write_as<int32_t>(out, value);
        }
    }
}

/// A length or an index.
template <class T> void write_whole(Writer &out, T value, bool text) {
    if (text) {
        out << ' ' << static_cast<uint32_t>(value);
    } else {
        out.raw(value);
    }
}

/// The length of a list: a byte if that is enough for all.
void write_length(Writer &out, std::size_t length, bool small, bool text) {
    if (small) {
        write_whole(out, static_cast<uint8_t>(length), text);
    } else {
        write_whole(out, static_cast<uint32_t>(length), text);
    }
}

void end_line(Writer &out, bool text) {
    if (text) {
        out << '\n';
    }
}
} // namespace

Losses write_ply(const std::string &path, const Mesh &mesh, bool text) {
    Losses losses;
    const auto normals = mesh.normals ? at_vertices(mesh, mesh.normals) : std::nullopt;
    const auto texcoords = mesh.texcoords ? at_vertices(mesh, mesh.texcoords) : std::nullopt;
    const bool at_faces = mesh.texcoords && !texcoords;
    if (mesh.normals && !normals) {
        losses.emplace_back("normals that differ at the corners of a vertex: PLY files hold one for each vertex");
    }
    if (!are_steps(mesh.vertex_colours) || !are_steps(mesh.face_colours)) {
        losses.emplace_back("shades of colours between 256 steps");
    }
    std::size_t widest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        widest = std::max(widest, mesh.degree(f));
    }
    const bool small = 2 * widest <= UINT8_MAX;
    const bool opaque = are_opaque(mesh.vertex_colours), opaque_faces = are_opaque(mesh.face_colours);

    Writer out(path);
    const Numbers points{out, text, ::is_single(mesh.points)};
    const Numbers directions{out, text, !normals || is_single(*normals)};
    const Numbers textures{out, text, !mesh.texcoords || is_single(mesh.texcoords.values)};
    out << "ply\nformat " << (text ? "ascii" : "binary_little_endian") << " 1.0\ncomment gusset\nelement vertex "
        << static_cast<uint32_t>(mesh.points.size()) << '\n';
    announce(out, points.type(), {"x", "y", "z"});
    if (normals) {
        announce(out, directions.type(), {"nx", "ny", "nz"});
    }
    announce_colours(out, mesh.vertex_colours, opaque);
    if (texcoords) {
        announce(out, textures.type(), {"s", "t"});
    }
    announce_properties(out, mesh, false);
    const char *length = small ? "list uchar " : "list uint ";
    out << "element face " << static_cast<uint32_t>(mesh.face_count()) << "\nproperty " << length
        << "int vertex_indices\n";
    announce_colours(out, mesh.face_colours, opaque_faces);
    if (at_faces) {
        out << "property " << length << textures.type() << "texcoord\n";
    }
    announce_properties(out, mesh, true);
    out << "end_header\n";

    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        for (const double x : mesh.points[v]) {
            points.write(x);
        }
        for (std::size_t k = 0; normals && k < 3; ++k) {
            directions.write((*normals)[v][k]);
        }
        if (!mesh.vertex_colours.empty()) {
            write_ply_colour(out, mesh.vertex_colours[v], opaque, text);
        }
        for (std::size_t k = 0; texcoords && k < 2; ++k) {
            textures.write((*texcoords)[v][k]);
        }
        write_properties(out, mesh, false, v, text);
        end_line(out, text);
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        write_length(out, mesh.degree(f), small, text);
        for (uint32_t c = mesh.offsets[f]; c < mesh.offsets[f + 1]; ++c) {
            write_whole(out, mesh.corners[c], text);
        }
        if (!mesh.face_colours.empty()) {
            write_ply_colour(out, mesh.face_colours[f], opaque_faces, text);
        }
        if (at_faces) {
            const auto *first = mesh.texcoords.values.data() + mesh.offsets[f];
            // A face has all of them or none.
            const bool there =
                std::none_of(first, first + mesh.degree(f), [](const auto &value) { return is_missing(value); });
            write_length(out, there ? 2 * mesh.degree(f) : 0, small, text);
            for (std::size_t k = 0; there && k < mesh.degree(f); ++k) {
                textures.write(first[k][0]);
                textures.write(first[k][1]);
            }
        }
        write_properties(out, mesh, true, f, text);
        end_line(out, text);
    }
    out.finish();
    return losses;
}
