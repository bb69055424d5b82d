// Reads all files of a folder of finished tiles as one mesh, which must fit in memory, and checks it: it knows nothing of how
// they were made.
//   tiles_gather folder
#include "output.hpp"

#include <iomanip>
#include <iostream>

namespace {
using namespace tiles;

/// The mesh of all tiles; ids count from the first tile's first.
struct Whole {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;
    Hash hash;
    uint64_t first_id = 0;
};

template <class T>
void read(const File &file, T *to, std::size_t count, const std::string &name) {
    if (std::fread(to, sizeof(T), count, file.get()) != count) {
        throw std::runtime_error(name + " is cut short");
    }
}

void add_tile(Whole &whole, uint32_t tile, const std::string &name) {
    const File file(std::fopen(name.c_str(), "rb"));
    if (!file) {
        throw std::runtime_error("cannot read " + name);
    }
    TileHeader header;
    read(file, &header, 1, name);
    const uint64_t words = 3 * (header.vertex_count + header.face_count);
    if (header.magic != TileHeader().magic || header.tile != tile ||
        std::filesystem::file_size(name) != sizeof header + words * sizeof(uint64_t)) {
        throw std::runtime_error(name + " is no file of tile " + std::to_string(tile));
    }
    if (tile == 0) {
        whole.first_id = header.first_id;
    }
    if (header.first_id != whole.first_id + whole.points.size()) {
        throw std::runtime_error(name + ": ids do not go on where the tile before ended");
    }
    Hash hash = hash_of(header);
    std::vector<Point3> points(header.vertex_count);
    std::vector<uint64_t> ids(3 * header.face_count);
    read(file, points.data(), points.size(), name);
    read(file, ids.data(), ids.size(), name);
    for (const Point3 &p : points) {
        for (const double x : p) {
            hash.add(word(x));
        }
    }
    for (const uint64_t id : ids) {
        hash.add(id);
        if (id - whole.first_id >= UINT32_MAX) {
            throw std::runtime_error(name + ": too large to be checked as one mesh, or with a wrong id");
        }
        whole.corners.push_back(static_cast<uint32_t>(id - whole.first_id));
    }
    if (hash.value() != header.hash) {
        throw std::runtime_error(name + ": the hash does not fit");
    }
    whole.points.insert(whole.points.end(), points.begin(), points.end());
    whole.hash.add(header.hash);
}
} // namespace

int main(int argc, char **argv) try {
    if (argc != 2) {
        std::cerr << "usage: tiles_gather folder\n";
        return 2;
    }
    Whole whole;
    uint32_t count = 0;
    for (std::string name; std::filesystem::exists(name = tile_file(argv[1], count, "bin")); ++count) {
        add_tile(whole, count, name);
    }
    if (count == 0) {
        throw std::runtime_error(std::string("no tiles in ") + argv[1]);
    }
    const gusset::MeshView mesh = gusset::MeshView::triangles(whole.points, whole.corners);
    const gusset::Check check(mesh);
    const gusset_check_view found = check.view();
    bool apart = true; // no two vertices are in one place
    const std::vector<uint32_t> merge = gusset::find_merge(mesh);
    for (uint32_t v = 0; v < merge.size(); ++v) {
        apart = apart && merge[v] == v;
    }
    std::cout << count << " tiles: " << found.vertex_count << " vertices, " << found.edge_count << " edges, " << found.face_count
              << " faces, " << found.component_count << " components, genus " << found.genus << ", Euler characteristic " << found.euler
              << "\nhash: " << std::hex << std::setw(16) << std::setfill('0') << whole.hash.value() << std::endl;
    bool holds = true;
    const auto hold = [&](bool so, const char *what) {
        if (!so) {
            std::cerr << "does not hold: " << what << '\n';
            holds = false;
        }
    };
    hold(check.is_closed(), "the whole is closed");
    hold(check.is_manifold(), "the whole is manifold");
    hold(check.is_oriented(), "the whole is oriented");
    hold(found.component_count == 1 && found.genus == 1 && found.euler == 0, "the whole is one torus");
    hold(found.duplicate_faces.count + found.degenerate_faces.count + found.unused_vertices.count == 0, "no face or vertex is too many");
    hold(apart, "no two vertices are in one place");
    return holds ? 0 : 1;
} catch (const std::exception &error) {
    std::cerr << "tiles_gather: " << error.what() << '\n';
    return 1;
}
