// The plan of a torus of tiles: neighbours, owners of shared elements, positions of grid points.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace tiles {
/// Mixes the bits of a number, one to one (Steele, Lea and Flood 2014, SplitMix64).
inline uint64_t mixed_bits(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The sides of a tile in the order of its rim, with the surface on the left. Corner k is where side k begins.
enum Side : uint32_t { south, east, north, west };
inline uint32_t opposite(uint32_t side) { return (side + 2) % 4; }

/// One of the four corners that meet at a junction.
struct TileCorner {
    uint32_t tile, corner;
};

/// Rows and columns of tiles, closed both ways. A tile is a grid of cells; between tiles nothing or one cell.
struct Plan {
    uint32_t rows = 4, columns = 4;
    /// Cells along each side of a tile.
    uint32_t cells = 64;
    /// Tiles are apart by one cell; else they have coincident rims.
    bool gap = false;
    /// Half of the tiles have half as many cells along each side.
    bool mixed = false;

    uint32_t count() const { return rows * columns; }
    /// Tiles are numbered row by row, as DIY numbers the blocks of a decomposition.
    uint32_t tile(uint32_t row, uint32_t column) const { return row % rows * columns + column % columns; }
    uint32_t row(uint32_t tile) const { return tile / columns; }
    uint32_t column(uint32_t tile) const { return tile % columns; }

    uint32_t neighbour(uint32_t of, uint32_t side) const {
        const uint32_t r = row(of), c = column(of);
        switch (side) {
        case south: return tile(r + rows - 1, c);
        case east: return tile(r, c + 1);
        case north: return tile(r + 1, c);
        default: return tile(r, c + columns - 1);
        }
    }
    /// A seam is computed, and its coincident vertices are numbered, by the lower of its two tiles.
    bool owns_side(uint32_t tile, uint32_t side) const { return tile < neighbour(tile, side); }

    /// The four corners that meet where corner k of a tile is, counterclockwise seen from outside.
    std::array<TileCorner, 4> junction(uint32_t of, uint32_t k) const {
        // The tile south-west of the junction.
        const uint32_t r = row(of) + (k < 2 ? rows - 1 : 0), c = column(of) + (k == 0 || k == 3 ? columns - 1 : 0);
        return {{{tile(r, c), 2}, {tile(r, c + 1), 3}, {tile(r + 1, c + 1), 0}, {tile(r + 1, c), 1}}};
    }
    /// The lowest of the four.
    uint32_t junction_owner(uint32_t tile, uint32_t k) const {
        const auto four = junction(tile, k);
        return std::min({four[0].tile, four[1].tile, four[2].tile, four[3].tile});
    }

    /// Grid cells between neighbouring vertices of a tile: 2 if it is one of the coarse ones.
    uint32_t step(uint32_t tile) const { return mixed && (mixed_bits(tile) & 1) != 0 ? 2 : 1; }
    uint32_t segments(uint32_t tile) const { return cells / step(tile); }
    uint64_t grid_rows() const { return uint64_t{rows} * (cells + (gap ? 1 : 0)); }
    uint64_t grid_columns() const { return uint64_t{columns} * (cells + (gap ? 1 : 0)); }
    uint64_t first_grid_row(uint32_t tile) const { return uint64_t{row(tile)} * (cells + (gap ? 1 : 0)); }
    uint64_t first_grid_column(uint32_t tile) const { return uint64_t{column(tile)} * (cells + (gap ? 1 : 0)); }
};

using PointF = std::array<float, 3>;

/// The grid points of a tile. They follow from indices in the whole grid alone, so that tiles agree on them to the bit.
class TileGrid {
public:
    TileGrid(const Plan &plan, uint32_t tile) {
        const uint32_t count = plan.segments(tile) + 1, step = plan.step(tile);
        for (uint32_t k = 0; k < count; ++k) {
            columns_.push_back(circle(plan.first_grid_column(tile) + uint64_t{k} * step, plan.grid_columns(), 5));
            rows_.push_back(circle(plan.first_grid_row(tile) + uint64_t{k} * step, plan.grid_rows(), 3));
        }
    }
    /// A torus about the z axis with waves on it, in single precision, as scanners deliver it.
    PointF point(uint32_t row, uint32_t column) const {
        const Circle &u = columns_[column], &v = rows_[row];
        const double thick = 1 + 0.06 * u.wave * v.wave, far = 3 + thick * v.cosine;
        return {static_cast<float>(far * u.cosine), static_cast<float>(far * u.sine), static_cast<float>(thick * v.sine)};
    }
    /// Corner k of the tile.
    PointF corner(uint32_t k) const {
        const auto last = static_cast<uint32_t>(rows_.size()) - 1;
        return point(k < 2 ? 0 : last, k == 0 || k == 3 ? 0 : last);
    }

private:
    struct Circle {
        double cosine, sine, wave;
    };
    static Circle circle(uint64_t index, uint64_t period, int waves) {
        const double angle = 6.283185307179586 * static_cast<double>(index % period) / static_cast<double>(period);
        return {std::cos(angle), std::sin(angle), std::sin(waves * angle)};
    }
    std::vector<Circle> columns_, rows_;
};
} // namespace tiles
