// Lists of scans and where each lies, as the Stanford 3D Scanning Repository has them: .conf files with lines
// "bmesh FILE tx ty tz qx qy qz qw".
#pragma once

#include "../mesh.hpp"

#include <optional>

/// A rotation and a shift: three rows of four numbers.
using Pose = std::array<std::array<double, 4>, 3>;

/// A file to be read, and where what it holds lies.
struct InputFile {
    std::string path;
    std::optional<Pose> pose;
};

/// The files that are named, and in place of a .conf file those that it lists. Throws Failure.
std::vector<InputFile> input_files(const std::vector<std::string> &paths);
/// Moves points, and turns normals.
void place(Mesh &mesh, const Pose &pose);
