// A smooth surface beside CGAL on a fine mesh of it.
#pragma once

#include "oracle.hpp"

#include <gusset.hpp>

#include <utility>

struct Fine {
    gusset::Sheet sheet;
    gusset::Surface surface;
    double deviation;
    Oracle oracle;

    explicit Fine(gusset::Sheet given, double tolerance = 5e-4)
        : sheet(std::move(given)), surface(sheet), deviation(0), oracle(meshed(sheet, tolerance, deviation)) {}

private:
    static Oracle meshed(const gusset::Sheet &sheet, double tolerance, double &deviation) {
        gusset::SheetMeshOptions options;
        options.tolerance = tolerance;
        options.triangles = true;
        const gusset::SheetMesh mesh(sheet, options);
        deviation = mesh.deviation();
        return Oracle(mesh.mesh());
    }
};
