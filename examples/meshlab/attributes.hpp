// Attributes of layers beside the positions and faces that filters process.
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
    /// Empty if the plugin does not report the origins of the output.
    Attributes(const Inputs &inputs, const Outputs &outputs, std::uint32_t index);

    /// Gives them to a layer that the output was put into, cut into these triangles.
    void put(MeshModel &layer, const Triangles &triangles) const;

private:
    /// The attributes that an input has, MeshModel::MM_...; the arrays of other attributes are empty.
    int which_ = 0;
    std::vector<std::string> textures_;
    std::map<std::string, QImage> images_;

    // Values of vertices, of faces and of their corners.
    std::vector<vcg::Color4b> vertex_colours_, face_colours_;
    std::vector<Scalarm> vertex_qualities_, face_qualities_;
    std::vector<vcg::Point3f> vertex_coordinates_, corner_coordinates_;
    std::vector<short> vertex_textures_, face_textures_;
};
