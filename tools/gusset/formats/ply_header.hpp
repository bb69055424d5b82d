// The header of a PLY file: which elements it has, and what is said of each.
#pragma once

#include "scanner.hpp"

#include <optional>
#include <string>
#include <vector>

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };

struct PlyProperty {
    std::string name;
    PlyType type;
    /// Of a list, the type of its length.
    std::optional<PlyType> count;
};

struct PlyElement {
    std::string name;
    std::size_t count;
    std::vector<PlyProperty> properties;
    /// The place of the first of these names among the properties.
    std::optional<std::size_t> find(std::initializer_list<const char *> names) const;
};

struct PlyHeader {
    enum class Form { text, little_endian, big_endian };
    Form form = Form::text;
    std::vector<PlyElement> elements;
    std::vector<std::string> textures;
    /// Of a range image, if its header says so: the grid's size.
    std::size_t rows = 0, columns = 0;
};

/// Leaves the scanner where the elements begin. Throws Failure.
PlyHeader read_ply_header(Scanner &scanner);
