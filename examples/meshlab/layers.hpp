// Layers as inputs of a filter, and outputs as layers.
#pragma once

#include "polygons.hpp"
#include "wires.hpp"

#include <common/ml_document/mesh_model.h>
#include <gusset_plugin.h>

#include <deque>
#include <vector>

class Attributes;

/// Inputs of a filter: views of layers, and what had to be copied for them. Everything is in the coordinates of the
/// first layer.
class Inputs {
public:
    /// Adds a layer as an input of this kind. Its vertices stay where they are if the layer lies as the first one does.
    void add(const MeshModel &model, std::uint32_t kind);

    /// The inputs for run and suggest; valid until the next add.
    const std::vector<gusset_input> &list() const { return list_; }
    const MeshModel &layer(std::size_t input) const { return *held_[input].layer; }
    /// The faces of an input that is a mesh; else none.
    const Polygons &faces(std::size_t input) const { return held_[input].faces; }

private:
    struct Held {
        const MeshModel *layer;
        Polygons faces;
        Wires wires;
        std::vector<double> positions;
        gusset_plugin_mesh mesh;
        gusset_plugin_curves curves;
    };

    void add_mesh(const CMeshO &layer, Held &held, const Matrix44m *move);

    std::vector<gusset_input> list_;
    /// Its elements do not move.
    std::deque<Held> held_;
    Matrix44m first_;
};

/// Puts a mesh in the place of the layer's. With the same faces only the vertices move, and all else stays; with
/// others, the layer has these attributes and no more.
void replace(MeshModel &layer, const gusset_plugin_mesh &mesh, const Polygons &before, const Attributes &attributes);

/// Puts polylines in the place of all that the layer has.
void replace(MeshModel &layer, const gusset_plugin_curves &curves);

/// Puts a mesh into a new layer.
void fill(MeshModel &layer, const gusset_plugin_mesh &mesh, const Attributes &attributes);

/// Puts polylines into a new layer.
void fill(MeshModel &layer, const gusset_plugin_curves &curves);
