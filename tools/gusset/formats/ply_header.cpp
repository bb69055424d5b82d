#include "ply_header.hpp"

#include "../failure.hpp"

#include <algorithm>
#include <map>

namespace {
PlyType type_of(const Scanner &scanner, std::string_view name) {
    static const std::map<std::string_view, PlyType> known = {
        {"char", PlyType::i8},   {"int8", PlyType::i8},     {"uchar", PlyType::u8},   {"uint8", PlyType::u8},
        {"short", PlyType::i16}, {"int16", PlyType::i16},   {"ushort", PlyType::u16}, {"uint16", PlyType::u16},
        {"int", PlyType::i32},   {"int32", PlyType::i32},   {"uint", PlyType::u32},   {"uint32", PlyType::u32},
        {"float", PlyType::f32}, {"float32", PlyType::f32}, {"double", PlyType::f64}, {"float64", PlyType::f64},
    };
    const auto found = known.find(name);
    if (found == known.end()) {
        scanner.fail("there is no type \"" + std::string(name) + '"');
    }
    return found->second;
}

void format(Scanner &scanner, PlyHeader &header, const std::vector<std::string_view> &words) {
    const std::string_view form = words.size() > 1 ? words[1] : "";
    if (form == "ascii") {
        header.form = PlyHeader::Form::text;
    } else if (form == "binary_little_endian") {
        header.form = PlyHeader::Form::little_endian;
    } else if (form == "binary_big_endian") {
        header.form = PlyHeader::Form::big_endian;
    } else {
        scanner.fail("there is no format \"" + std::string(form) + '"');
    }
}

void property(Scanner &scanner, PlyHeader &header, const std::vector<std::string_view> &words) {
    const bool is_list = words.size() > 1 && words[1] == "list";
    if (words.size() < (is_list ? 5U : 3U)) {
        scanner.fail("a property without a type or a name");
    }
    if (header.elements.empty()) {
        scanner.fail("a property of no element");
    }
    PlyProperty made{std::string(words.back()), type_of(scanner, words[is_list ? 3 : 1]), std::nullopt};
    if (is_list) {
        made.count = type_of(scanner, words[2]);
    }
    header.elements.back().properties.push_back(std::move(made));
}
} // namespace

std::optional<std::size_t> PlyElement::find(std::initializer_list<const char *> names) const {
    for (const char *wanted : names) {
        const auto found = std::find_if(properties.begin(), properties.end(),
                                        [&](const PlyProperty &property) { return property.name == wanted; });
        if (found != properties.end()) {
            return static_cast<std::size_t>(found - properties.begin());
        }
    }
    return std::nullopt;
}

PlyHeader read_ply_header(Scanner &scanner) {
    PlyHeader header;
    if (scanner.rest_of_line() != "ply") {
        scanner.fail("it does not begin with \"ply\"");
    }
    while (true) {
        if (scanner.at_end()) {
            scanner.fail("the file ends in its header");
        }
        const std::string_view line = scanner.rest_of_line();
        const auto words = words_of(line);
        if (words[0] == "end_header") {
            return header;
        }
        if (words[0] == "format") {
            format(scanner, header, words);
        } else if (words[0] == "element") {
            const auto count = words.size() == 3 ? number_in(words[2]) : std::nullopt;
            if (!count || *count < 0 || *count > UINT32_MAX - 1) {
                scanner.fail("an element needs a name and a count");
            }
            header.elements.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
        } else if (words[0] == "property") {
            property(scanner, header, words);
        } else if (words[0] == "comment" && words.size() > 2 && words[1] == "TextureFile") {
            header.textures.emplace_back(words[2]);
        } else if (words[0] == "obj_info" && words.size() == 3 && (words[1] == "num_rows" || words[1] == "num_cols")) {
            const auto count = number_in(words[2]);
            if (!count || !(*count >= 0 && *count <= UINT32_MAX)) {
                scanner.fail("a grid needs a count of its rows and columns");
            }
            (words[1] == "num_rows" ? header.rows : header.columns) = static_cast<std::size_t>(*count);
        } else if (words[0] != "comment" && words[0] != "obj_info") {
            scanner.fail("\"" + std::string(words[0]) + "\" means nothing in a header");
        }
    }
}
