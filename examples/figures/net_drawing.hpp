// The nodes and links of a net, drawn in the plane.
#pragma once

#include "figure.hpp"

namespace figures {
/// Nodes of a net in the picture: by their numbers, or where they are in the plane of x and y.
class Grid {
public:
    /// By numbers, `step` apart round a middle.
    Grid(std::size_t rows, std::size_t columns, const Spot &middle, double step) : rows_(rows), columns_(columns) {
        for (std::size_t i = 0; i < rows; ++i) {
            for (std::size_t j = 0; j < columns; ++j) {
                spots_.push_back({middle[0] + step * (static_cast<double>(j) - 0.5 * static_cast<double>(columns - 1)),
                                  middle[1] + step * (static_cast<double>(i) - 0.5 * static_cast<double>(rows - 1))});
            }
        }
    }
    /// Places in the picture; `scale` is the length of a unit of space. The first row is above.
    Grid(const gusset::Net &net, const Spot &middle, double scale) : Grid(net.rows(), net.columns(), middle, 0) {
        const double sign = net.at(0, 0)[1] <= net.at(rows_ - 1, 0)[1] ? 1 : -1;
        for (std::size_t k = 0; k < spots_.size(); ++k) {
            const Point3 p = net.at(k / columns_, k % columns_);
            spots_[k] = {middle[0] + scale * p[0], middle[1] + scale * sign * p[1]};
        }
    }
    /// The same, with the nodes that are one point gathered in the middle between them: all the way by 1.
    Grid gathered(const gusset::Net &net, double part) const {
        Grid made = *this;
        const std::vector<uint32_t> of = net.classes();
        std::vector<Spot> sum(spots_.size());
        std::vector<double> count(spots_.size());
        for (std::size_t k = 0; k < spots_.size(); ++k) {
            sum[of[k]][0] += spots_[k][0], sum[of[k]][1] += spots_[k][1], ++count[of[k]];
        }
        for (std::size_t k = 0; k < spots_.size(); ++k) {
            made.spots_[k] = between(spots_[k], {sum[of[k]][0] / count[of[k]], sum[of[k]][1] / count[of[k]]}, part);
        }
        return made;
    }
    const Spot &spot(std::size_t i, std::size_t j) const { return spots_[i * columns_ + j]; }
    const Spot &spot(std::size_t node) const { return spots_[node]; }

    void lines(Figure &figure, const Pen &pen) const {
        for (std::size_t i = 0; i < rows_; ++i) {
            for (std::size_t j = 0; j < columns_; ++j) {
                if (j + 1 < columns_) {
                    figure.line({spot(i, j), spot(i, j + 1)}, pen);
                }
                if (i + 1 < rows_) {
                    figure.line({spot(i, j), spot(i + 1, j)}, pen);
                }
            }
        }
    }
    /// The links that the matrix of the net contracts, and their number; those that close the net get a stub.
    std::size_t contracted(Figure &figure, const gusset::Net &net, double width = 4) const {
        const std::vector<uint8_t> matrix = net.matrix();
        std::size_t ones = 0;
        for (std::size_t k = 0; k < matrix.size(); ++k) {
            if (matrix[k] == 0) {
                continue;
            }
            ++ones;
            const std::size_t i = k / columns_ / 2, j = k % columns_;
            const bool vertical = k / columns_ % 2 != 0, last = vertical ? i + 1 == rows_ : j + 1 == columns_;
            const Spot from = spot(i, j),
                       to = last       ? vertical ? Spot{from[0], from[1] + 14} : Spot{from[0] + 14, from[1]}
                            : vertical ? spot(i + 1, j)
                                       : spot(i, j + 1);
            figure.line({from, to}, {red, width, ""});
        }
        return ones;
    }
    void dots(Figure &figure, const std::function<Colour(std::size_t, std::size_t)> &colour_of,
              double radius = 3.5) const {
        for (std::size_t i = 0; i < rows_; ++i) {
            for (std::size_t j = 0; j < columns_; ++j) {
                figure.dot(spot(i, j), radius, colour_of(i, j), colour_of(i, j));
            }
        }
    }

private:
    std::size_t rows_, columns_;
    std::vector<Spot> spots_;
};

/// Figures 4 to 6 of Deryagin's paper, the gluings, in deryagin_gluing.cpp.
std::string gluings(const std::string &file);
std::string closures(const std::string &file);
std::string cube(const std::string &file);
} // namespace figures
