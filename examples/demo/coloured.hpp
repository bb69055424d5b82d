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

/// Throws if the file does not exist, or if OpenMesh cannot read it.
Coloured read(const std::string &path);

/// Both pieces and the strip between them, with colours; without the strip, both pieces.
struct Joined {
    HostMesh mesh;
    bool has_vertex_colours = false;
    /// Vertices or faces have the colours of the files.
    bool is_coloured = false;
};

/// Colours of vertices if a piece has some, else of faces; `paints`: colours of faces of the left piece, the right
/// piece and the strip that lack their own colours. New vertices get the colours of the rims beside them.
Joined joined(const Coloured &left, const Coloured &right, const gusset::Stitch &stitch, const std::array<page::Colour, 3> &paints,
              bool with_strip);

/// Writes STEM.ply if vertices have colours, because OpenMesh stores them in no other format; otherwise STEM.obj with
/// its materials. Returns its path.
std::string write(const HostMesh &mesh, bool has_vertex_colours, const std::string &stem);
