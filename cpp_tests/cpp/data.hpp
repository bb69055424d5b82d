// The real meshes that tests run on, and what their manifest says of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

struct DataFile {
    /// The path from the data folder, as in the manifest.
    std::string name;
    std::string path;
    /// Boundary loops walked fan by fan, or nothing where the manifest counts boundary components
    /// instead.
    std::optional<std::size_t> walks;
    std::size_t vertices = 0, faces = 0, components = 0, unused = 0;
    long euler = 0;
    bool manifold = true, orientable = true;
    std::size_t non_manifold_edges = 0, flipped_edges = 0;
    /// Edges with one face.
    std::size_t boundary_edges = 0;
    /// How many of those the largest connected parts of the boundary have, at most four parts.
    std::vector<std::size_t> longest;
};

/// The folder GUSSET_DATA, or ../shared/data beside the repository. If it lacks a manifest, prints this and returns
/// nothing.
std::optional<std::string> data_folder();
/// Every mesh of the manifest's folders meshes and pairs that has faces.
std::vector<DataFile> data_files();
