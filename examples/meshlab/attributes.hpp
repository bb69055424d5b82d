// What layers carry beside positions and faces, which are all that filters know of.
#pragma once

#include "layers.hpp"
#include "plugin.hpp"

#include <map>
#include <string>
#include <vector>

/// Colours, quality and texture coordinates of the inputs of a run, mixed for the elements of an output. Copies: the
/// output may replace an input.
class Attributes {
public:
    /// None if the plugin does not tell where the elements of the output come from.
    Attributes(const Inputs &inputs, const Outputs &outputs, std::uint32_t index);

    /// Gives them to a layer that the output was put into, cut into these triangles.
    void put(MeshModel &layer, const Triangles &triangles) const;

private:
    /// Those that any input has, MeshModel::MM_...; the others have no values below.
    int which_ = 0;
    std::vector<std::string> textures_;
    std::map<std::string, QImage> images_;

    // Of vertices, of faces and of their corners.
    std::vector<vcg::Color4b> vertex_colours_, face_colours_;
    std::vector<Scalarm> vertex_qualities_, face_qualities_;
    std::vector<vcg::Point3f> vertex_coordinates_, corner_coordinates_;
    std::vector<short> vertex_textures_, face_textures_;
};
