// Reads all files of a folder of finished tiles as one mesh, which must fit in memory, and checks it: it knows nothing of how
// they were made. With --sums it has one tile in memory, and checks ids, hashes and the sums over half-edges.
//   tiles_gather [--sums] folder
#include "output.hpp"

#include <iostream>

namespace {
using namespace tiles;

/// The mesh of all tiles; ids count from the first tile's first.
struct Whole {
    std::vector<Point3> points;
    std::vector<uint32_t> corners;
    uint64_t vertices = 0, faces = 0, first_id = 0;
    EdgeSums sums;
    Hash hash;
};

template <class T>
void read(const File &file, T *to, std::size_t count, const std::string &name) {
    if (std::fread(to, sizeof(T), count, file.get()) != count) {
        throw std::runtime_error(name + " is cut short");
    }
}

void add_tile(Whole &whole, uint32_t tile, const std::string &name, bool keep) {
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
    if (header.first_id != whole.first_id + whole.vertices) {
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
    }
    if (hash.value() != header.hash) {
        throw std::runtime_error(name + ": the hash does not fit");
    }
    for (std::size_t i = 0; i < ids.size(); i += 3) {
        whole.sums.add({ids[i], ids[i + 1], ids[i + 2]});
    }
    whole.hash.add(header.hash);
    whole.vertices += header.vertex_count;
    whole.faces += header.face_count;
    if (keep) {
        whole.points.insert(whole.points.end(), points.begin(), points.end());
        for (const uint64_t id : ids) {
            if (id - whole.first_id >= UINT32_MAX) {
                throw std::runtime_error(name + ": too large to be checked as one mesh, or with a wrong id");
            }
            whole.corners.push_back(static_cast<uint32_t>(id - whole.first_id));
        }
    }
}
class Claims {
public:
    void hold(bool so, const char *what) {
        if (!so) {
            std::cerr << "does not hold: " << what << '\n';
            holds_ = false;
        }
    }
    int status() const { return holds_ ? 0 : 1; }

private:
    bool holds_ = true;
};

void check(const Whole &whole, Claims &claims) {
    const gusset::MeshView mesh = gusset::MeshView::triangles(whole.points, whole.corners);
    const gusset::Check check(mesh);
    const gusset_check_view found = check.view();
    bool apart = true; // no two vertices are in one place
    const std::vector<uint32_t> merge = gusset::find_merge(mesh);
    for (uint32_t v = 0; v < merge.size(); ++v) {
        apart = apart && merge[v] == v;
    }
    std::cout << found.vertex_count << " vertices, " << found.edge_count << " edges, " << found.face_count << " faces, "
              << found.component_count << " components, genus " << found.genus << ", Euler characteristic " << found.euler << '\n';
    claims.hold(check.is_closed(), "the whole is closed");
    claims.hold(check.is_manifold(), "the whole is manifold");
    claims.hold(check.is_oriented(), "the whole is oriented");
    claims.hold(found.component_count == 1 && found.genus == 1 && found.euler == 0, "the whole is one torus");
    claims.hold(found.duplicate_faces.count + found.degenerate_faces.count + found.unused_vertices.count == 0,
                "no face or vertex is too many");
    claims.hold(apart, "no two vertices are in one place");
}
} // namespace

int main(int argc, char **argv) try {
    const bool keep = argc == 2;
    if (!keep && (argc != 3 || std::string(argv[1]) != "--sums")) {
        std::cerr << "usage: tiles_gather [--sums] folder\n";
        return 2;
    }
    const std::string folder = argv[argc - 1];
    Whole whole;
    uint32_t count = 0;
    for (std::string name; std::filesystem::exists(name = tile_file(folder, count, "bin")); ++count) {
        add_tile(whole, count, name, keep);
    }
    if (count == 0) {
        throw std::runtime_error("no tiles in " + folder);
    }
    Claims claims;
    std::cout << count << " tiles: ";
    if (keep) {
        check(whole, claims);
    } else {
        std::cout << whole.vertices << " vertices, " << whole.faces << " faces\n";
    }
    claims.hold(whole.sums.forth == whole.sums.back, "each edge is run once in each direction");
    claims.hold(2 * whole.vertices == whole.faces, "a closed torus of triangles has twice as many faces as vertices");
    std::cout << "hash: " << hexadecimal(whole.hash.value()) << std::endl;
    return claims.status();
} catch (const std::exception &error) {
    std::cerr << "tiles_gather: " << error.what() << '\n';
    return 1;
}
