#include "placed.hpp"

#include "../failure.hpp"
#include "scanner.hpp"

#include <cmath>
#include <filesystem>

namespace {
/// By a shift and a unit quaternion that turns the axes, and so points the other way.
Pose pose_of(const std::array<double, 7> &numbers) {
    const auto &[tx, ty, tz, i, j, k, w] = numbers;
    return {{{1 - 2 * (j * j + k * k), 2 * (i * j + k * w), 2 * (i * k - j * w), tx},
             {2 * (i * j - k * w), 1 - 2 * (i * i + k * k), 2 * (j * k + i * w), ty},
             {2 * (i * k + j * w), 2 * (j * k - i * w), 1 - 2 * (i * i + j * j), tz}}};
}

void read_conf(const std::string &path, std::vector<InputFile> &files) {
    std::string text = load(path);
    // A mark of the order of bytes is no part of the first word.
    if (text.rfind("\xef\xbb\xbf", 0) == 0) {
        text.erase(0, 3);
    }
    Scanner scanner(path, text, '#');
    const auto folder = std::filesystem::path(path).parent_path();
    const std::size_t before = files.size();
    while (!scanner.at_end()) {
        const auto words = words_of(scanner.rest_of_line());
        if (words.empty() || words[0] != "bmesh") {
            continue;
        }
        std::array<double, 7> numbers{};
        double square = 0;
        for (std::size_t n = 0; n < numbers.size(); ++n) {
            const auto number = words.size() == numbers.size() + 2 ? number_in(words[n + 2]) : std::nullopt;
            if (!number || !std::isfinite(*number)) {
                scanner.fail("\"bmesh\" needs a file, three numbers of a shift and four of a quaternion");
            }
            numbers[n] = *number;
            square += n < 3 ? 0 : *number * *number;
        }
        if (!(square > 0)) {
            scanner.fail("a quaternion of length 0");
        }
        for (std::size_t n = 3; n < numbers.size(); ++n) {
            numbers[n] /= std::sqrt(square);
        }
        files.push_back({(folder / std::string(words[1])).string(), pose_of(numbers)});
    }
    if (files.size() == before) {
        throw Failure(Exit::file, path + ": it lists no scans, each a line \"bmesh FILE ...\"");
    }
}
} // namespace

std::vector<InputFile> input_files(const std::vector<std::string> &paths) {
    std::vector<InputFile> files;
    for (const std::string &path : paths) {
        if (std::filesystem::path(path).extension() == ".conf") {
            read_conf(path, files);
        } else {
            files.push_back({path, std::nullopt});
        }
    }
    return files;
}

void place(Mesh &mesh, const Pose &pose) {
    const auto turn = [&](const auto &p, std::size_t k) {
        return pose[k][0] * p[0] + pose[k][1] * p[1] + pose[k][2] * p[2];
    };
    for (Point &p : mesh.points) {
        p = {turn(p, 0) + pose[0][3], turn(p, 1) + pose[1][3], turn(p, 2) + pose[2][3]};
    }
    for (auto &n : mesh.normals.values) {
        n = {turn(n, 0), turn(n, 1), turn(n, 2)};
    }
}
