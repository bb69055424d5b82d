// The judge as a program: quality FILE FIRST prints measures of the faces from FIRST on, as JSON; angles in degrees, lengths in the
// unit of the points.
#include "mesh.hpp"
#include "mesh_judge.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <stdexcept>

int main(int argc, char **argv) {
    try {
        if (argc != 3) {
            throw std::runtime_error("usage: quality FILE FIRST_NEW_FACE");
        }
        const Triangles mesh = read_triangles(argv[1]);
        const std::size_t first = std::stoul(argv[2]);
        if (first >= mesh.face_count()) {
            throw std::runtime_error("there are no new faces");
        }
        nlohmann::json out = {{"faces", mesh.face_count() - first}};
        shapes(mesh, first, out);
        edges(mesh, first, out);
        intersections(mesh, first, true, out);
        std::cout << out.dump() << '\n';
    } catch (const std::exception &error) {
        std::cerr << "quality: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
