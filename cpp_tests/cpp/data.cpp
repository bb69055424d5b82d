#include "data.hpp"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

std::optional<std::string> data_folder() {
    const char *given = std::getenv("GUSSET_DATA");
    const std::string folder = given != nullptr ? given : GUSSET_DEFAULT_DATA;
    if (std::ifstream(folder + "/MANIFEST.md")) {
        return folder;
    }
    std::cout << "SKIPPED: no real meshes in " << folder << "; set GUSSET_DATA to the folder that has them\n";
    return std::nullopt;
}

namespace {
std::size_t number(const std::string &text, const char *pattern) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(pattern)) ? std::stoul(found[1]) : 0;
}
} // namespace

std::vector<DataFile> data_files() {
    std::vector<DataFile> files;
    const auto folder = data_folder();
    std::ifstream manifest(folder.value_or("") + "/MANIFEST.md");
    const std::regex row(R"(^\| ((?:meshes|pairs)/[^\s{]+\.(?:off|obj|ply|stl|STL)) \|(.*)$)");
    for (std::string line; folder && std::getline(manifest, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, row) || line.find("b-edges") == std::string::npos) {
            continue;
        }
        const std::string numbers = found[2];
        DataFile file;
        file.name = found[1];
        file.path = *folder + "/" + file.name;
        file.vertices = number(numbers, R"(V=(\d+))");
        file.faces = number(numbers, R"(F=(\d+))");
        file.components = number(numbers, R"(comps=(\d+))");
        file.unused = number(numbers, R"(unused=(\d+))");
        file.euler = numbers.find("chi=-") != std::string::npos ? -long(number(numbers, R"(chi=-(\d+))"))
                                                                : long(number(numbers, R"(chi=(\d+))"));
        file.manifold = numbers.find("NON-manifold") == std::string::npos;
        file.orientable = numbers.find("NON-orientable") == std::string::npos;
        file.non_manifold_edges = number(numbers, R"(NON-manifold \(edges (\d+))");
        file.flipped_edges = number(numbers, R"((\d+) flipped edges)");
        file.boundary_edges = number(numbers, R"(b-edges (\d+))");
        if (numbers.find(" b-comps (") == std::string::npos) {
            file.walks = number(numbers, R"(loops=(\d+))");
        }
        std::smatch longest;
        if (std::regex_search(numbers, longest, std::regex(R"(longest \[([^\]]*)\])"))) {
            std::istringstream list(std::regex_replace(longest[1].str(), std::regex(","), " "));
            for (std::size_t n; list >> n;) {
                file.longest.push_back(n);
            }
        }
        files.push_back(file);
    }
    return files;
}
