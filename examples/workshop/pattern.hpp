// A development drawn as a pattern to cut: faces coloured by how much lengths in them change, the outline, the cuts.
#pragma once

#include "workshop.hpp"

#include <map>
#include <utility>

namespace workshop {
/// White where lengths are kept, redder the more some of them change. `limit`: the logarithm of the factor that has the
/// full colour.
inline page::Colour stretch_colour(const std::array<double, 2> &factors, double limit) {
    const double change = std::max(std::abs(std::log(factors[0])), std::abs(std::log(factors[1])));
    const double part = std::min(change / limit, 1.0);
    const auto byte = [](double value) { return static_cast<uint8_t>(std::lround(value)); };
    return {byte(252 - 66 * part), byte(252 - 192 * part), byte(250 - 214 * part)};
}
inline std::string text(const page::Colour &colour) {
    return "rgb(" + std::to_string(colour[0]) + ',' + std::to_string(colour[1]) + ',' + std::to_string(colour[2]) + ')';
}

/// Prints how much a development distorts its first chart.
inline void print_chart(const char *what, const gusset::Development &flat) {
    const gusset_chart &chart = flat.charts()[0];
    std::cout << what << ": " << flat.darts() << " darts, energy " << chart.energy
              << " (4 keeps all lengths), lengths by " << chart.min_stretch << " to " << chart.max_stretch
              << ", area " << chart.area << " dm2, flat " << chart.flat_area << " dm2, "
              << chart.overlaps << " overlaps\n";
}

/// The pattern on a sheet of 960 units of width, with a scale of one unit of length.
class Pattern {
public:
    explicit Pattern(const gusset::Development &flat) : flat_(flat) {
        low_ = high_ = flat.points()[0];
        for (const auto &p : flat.points()) {
            for (std::size_t k = 0; k < 2; ++k) {
                low_[k] = std::min(low_[k], p[k]), high_[k] = std::max(high_[k], p[k]);
            }
        }
        scale_ = std::min(900 / (high_[0] - low_[0]), 560 / (high_[1] - low_[1]));
        left_ = 480 - scale_ * (high_[0] - low_[0]) / 2;
    }

    void write(const std::string &file, const std::string &unit, double limit) const {
        const double height = scale_ * (high_[1] - low_[1]) + 130;
        std::ofstream out(file);
        out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 960 " << std::lround(height)
            << "' font-family='sans-serif' font-size='15' stroke-linejoin='round' stroke-linecap='round'>\n"
            << "<rect width='100%' height='100%' rx='8' fill='#fbfaf7'/>\n<g stroke-width='0.4'>\n";
        for (std::size_t f = 0; f < flat_.mesh().face_count(); ++f) {
            const gusset::Indices face = flat_.mesh().face(f);
            const std::string colour = text(stretch_colour(flat_.stretches()[f], limit));
            out << "<path d='" << path({face.begin(), face.end()}) << "z' fill='" << colour << "' stroke='" << colour
                << "'/>\n";
        }
        out << "</g>\n";
        lines(out);
        key(out, height - 62, unit, limit);
        out << "</svg>\n";
        if (!out.flush()) {
            throw std::runtime_error("cannot write " + file);
        }
    }

private:
    std::string path(const std::vector<uint32_t> &vertices) const {
        std::ostringstream text;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const auto &p = flat_.points()[vertices[k]];
            // Tenths of a unit are fine enough, and read the same everywhere.
            const long x = std::lround(10 * (left_ + scale_ * (p[0] - low_[0])));
            const long y = std::lround(10 * (30 + scale_ * (high_[1] - p[1])));
            text << (k == 0 ? 'M' : 'L') << 0.1 * static_cast<double>(x) << ' ' << 0.1 * static_cast<double>(y);
        }
        return text.str();
    }

    /// The outline: thin where the surface ended, thick where it was cut, and red along darts.
    void lines(std::ostream &out) const {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> kinds;
        const gusset::Indices edges = flat_.cut_edges();
        for (std::size_t e = 0; e < flat_.cut_kinds().size(); ++e) {
            kinds[std::minmax(edges[2 * e], edges[2 * e + 1])] = flat_.cut_kinds()[e];
        }
        const gusset::Boundary borders(flat_.mesh());
        for (const gusset::Loop border : borders) {
            for (std::size_t k = 0; k < border.vertices.size(); ++k) {
                const uint32_t a = border.vertices[k], b = border.vertices[(k + 1) % border.vertices.size()];
                const auto cut = kinds.find(std::minmax(flat_.vertex_map()[a], flat_.vertex_map()[b]));
                const bool dart = cut != kinds.end() && cut->second == GUSSET_CUT_DART;
                out << "<path d='" << path({a, b}) << "' fill='none' stroke='" << (dart ? "#b0185a" : "#28323c")
                    << "' stroke-width='" << (cut == kinds.end() ? 1.2 : 2.6) << "'/>\n";
            }
        }
    }

    void key(std::ostream &out, double y, const std::string &unit, double limit) const {
        for (int k = 0; k < 40; ++k) {
            const double by = std::exp((k + 0.5) / 40 * limit);
            out << "<rect x='" << 520 + 10 * k << "' y='" << y << "' width='10.5' height='12' fill='"
                << text(stretch_colour({by, by}, limit)) << "'/>\n";
        }
        out << "<text x='520' y='" << y + 32 << "' fill='#333'>all lengths kept</text>\n<text x='920' y='" << y + 32
            << "' text-anchor='end' fill='#333'>some change by " << std::lround(100 * std::exp(limit) - 100)
            << " % or more</text>\n<path d='M30 " << y + 12 << "h" << scale_
            << "' stroke='#28323c' stroke-width='2'/>\n<text x='30' y='" << y + 32 << "' fill='#333'>1 " << unit
            << "</text>\n";
    }

    const gusset::Development &flat_;
    std::array<double, 2> low_{}, high_{};
    double scale_ = 1, left_ = 0;
};
} // namespace workshop
