// Meshes with the colours of their files: of vertices, of faces, or none.
#pragma once

#include "host.hpp"

#include "../page/showcase.hpp"

#include <gusset.hpp>

#include <array>
#include <string>
#include <vector>

struct Coloured {
    HostMesh mesh;
    bool has_vertex_colours = false, has_face_colours = false;
};

/// Throws where there is no such file, or it is none that OpenMesh reads.
Coloured read(const std::string &path);

/// Both pieces and the strip between them, with colours; without the strip, both pieces.
struct Joined {
    HostMesh mesh;
    bool has_vertex_colours = false;
    /// Vertices or faces have the colours of the files.
    bool is_coloured = false;
};

/// Colours of vertices if a piece has some, else of faces; `paints`: what faces of the left piece, of the right one and of the
/// strip have where they have no colours of their own. New vertices have those of the rims that they are between.
Joined joined(const Coloured &left, const Coloured &right, const gusset::Stitch &stitch, const std::array<page::Colour, 3> &paints,
              bool with_strip);

/// Writes STEM.ply where vertices have colours, for OpenMesh has no other format for them, else STEM.obj with its materials beside
/// it. Returns its path.
std::string write(const HostMesh &mesh, bool has_vertex_colours, const std::string &stem);
