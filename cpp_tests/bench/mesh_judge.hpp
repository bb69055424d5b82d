// Measures of the new faces of a joined mesh, those from `first` on, into a JSON object.
#pragma once

#include "mesh.hpp"

#include <nlohmann/json_fwd.hpp>

/// `min_angle` is in degrees. `under_15` is the share of faces with an angle below 15 degrees. `aspect` is
/// circumradius / (2 inradius), and null if a face is degenerate. `area` is the total area.
void shapes(const Triangles &mesh, std::size_t first, nlohmann::json &out);

/// `closed`: every edge of the new faces has two faces that run it in opposite directions; `dihedral_p95` and `dihedral_max` in
/// degrees, 0 where the surface is flat.
void edges(const Triangles &mesh, std::size_t first, nlohmann::json &out);

/// `intersections`: pairs of faces that intersect, a new one among them; `intersections_all` where the mesh is searched `everywhere`
/// and is not large.
void intersections(const Triangles &mesh, std::size_t first, bool everywhere, nlohmann::json &out);

/// `rms`: how far the new faces are from the surface `truth` and it from them, the root of the mean square both ways.
void distance(const Triangles &mesh, std::size_t first, const Triangles &truth, nlohmann::json &out);
