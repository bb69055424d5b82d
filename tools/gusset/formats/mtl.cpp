// The lines of a material stay what they are but for the names of files, which are those seen from the new library.
#include "mtl.hpp"

#include "scanner.hpp"
#include "writer.hpp"

#include <algorithm>
#include <filesystem>

namespace {
namespace fs = std::filesystem;

/// The file that ends a line like "map_Kd -s 1 1 1 an image.png", and where its name begins: names may have spaces, so
/// it is the longest one that there is.
struct NamedFile {
    std::size_t start;
    fs::path file;
};

bool names_a_file(std::string_view statement) {
    return statement.compare(0, 4, "map_") == 0 || statement == "bump" || statement == "disp" || statement == "decal" ||
           statement == "refl" || statement == "norm";
}

std::optional<NamedFile> file_in(const std::string &line, const std::string &folder) {
    const auto words = words_of(line);
    if (words.size() < 2 || !names_a_file(words[0])) {
        return std::nullopt;
    }
    const std::size_t end = static_cast<std::size_t>(words.back().data() - line.data()) + words.back().size();
    const auto from = [&](std::size_t w) {
        const auto start = static_cast<std::size_t>(words[w].data() - line.data());
        std::string name = line.substr(start, end - start);
        // As Windows writes them.
        std::replace(name.begin(), name.end(), '\\', '/');
        return NamedFile{start, fs::path(folder) / name};
    };
    for (std::size_t w = 1; w < words.size(); ++w) {
        std::error_code error;
        if (fs::is_regular_file(from(w).file, error)) {
            return from(w);
        }
    }
    // There is none: as if there were, and behind options it were one word.
    return from(words[1][0] == '-' ? words.size() - 1 : 1);
}

/// A file as it is named from a folder.
std::string seen_from(const fs::path &folder, const fs::path &file) {
    std::error_code error;
    const fs::path base = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
    const fs::path seen = fs::proximate(fs::absolute(file, error), base, error);
    return error ? file.string() : seen.string();
}

/// What every format has: the colour and its image.
void enter(Material &material, const std::string &line) {
    const auto words = words_of(line);
    const auto number = [&](std::size_t w) { return w < words.size() ? number_in(words[w]) : std::nullopt; };
    if (words[0] == "Kd") {
        for (std::size_t k = 0; k < 3; ++k) {
            material.colour[k] = static_cast<float>(number(k + 1).value_or(1));
        }
    } else if (words[0] == "d") {
        material.colour[3] = static_cast<float>(number(words.size() - 1).value_or(1));
    } else if (words[0] == "Tr") {
        material.colour[3] = 1 - static_cast<float>(number(words.size() - 1).value_or(0));
    } else if (words[0] == "map_Kd") {
        if (const auto found = file_in(line, material.folder)) {
            material.image.file = fs::absolute(found->file).string();
        }
    }
}

void write_colour(Writer &out, const Material &material, const fs::path &library, const std::string &name) {
    out << "Kd";
    for (std::size_t k = 0; k < 3; ++k) {
        out << ' ' << static_cast<double>(material.colour[k]);
    }
    out << '\n';
    if (material.colour[3] < 1) {
        out << "d " << static_cast<double>(material.colour[3]) << '\n';
    }
    if (material.image.empty()) {
        return;
    }
    fs::path file = material.image.file;
    if (file.empty()) {
        const std::string ending = type_of(material.image.bytes) == "image/png" ? ".png" : ".jpg";
        std::string plain = library.stem().string() + '_' + name;
        std::replace_if(plain.begin(), plain.end(), [](char c) { return c == '/' || c == '\\' || c == ' '; }, '_');
        file = library.parent_path() / (plain + ending);
        Writer image(file.string());
        image << material.image.bytes;
        image.finish();
    }
    out << "map_Kd " << seen_from(library.parent_path(), file) << '\n';
}
} // namespace

bool read_mtl(const std::string &path, std::map<std::string, Material> &into) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return false;
    }
    const std::string text = load(path), folder = fs::path(path).parent_path().string();
    Material *material = nullptr;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        std::string line = text.substr(start, end - start);
        start = end + 1;
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) {
            line.pop_back();
        }
        const auto words = words_of(line);
        if (words.empty() || words[0][0] == '#') {
            continue;
        }
        if (words[0] == "newmtl") {
            const std::string name = words.size() < 2 ? "" : line.substr(static_cast<std::size_t>(words[1].data() - line.data()));
            material = &into[name];
            *material = Material{};
            material->name = name;
            material->folder = folder;
        } else if (material != nullptr) {
            enter(*material, line);
            material->lines.push_back(std::move(line));
        }
    }
    return true;
}

void write_mtl(const std::string &path, const UsedMaterials &materials) {
    const fs::path library = path;
    Writer out(path);
    for (std::size_t m = 0; m < materials.all.size(); ++m) {
        const Material &material = *materials.all[m];
        out << "newmtl " << materials.names[m] << '\n';
        for (const std::string &line : material.lines) {
            const auto found = file_in(line, material.folder);
            out << (found ? line.substr(0, found->start) + seen_from(library.parent_path(), found->file) : line) << '\n';
        }
        if (material.lines.empty()) {
            write_colour(out, material, library, materials.names[m]);
        }
    }
    out.finish();
}
