// Compares random cases with independent truth. An argument bounds their number:
//   campaign [--family NAME] [--cases N] [--seed S]
// Case k of a family has the seed S + k, so that each failure is repeated by its own seed and
// --cases 1. The exit status is 1 if any case failed.
#include "campaign.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace {
using campaign::Case;
using campaign::Family;

constexpr Family families[] = {
    {"loops", campaign::loops, 400},       {"validity", campaign::validity, 60},
    {"intersections", campaign::intersections, 60}, {"surfaces", campaign::surfaces, 3},
    {"curves", campaign::curves, 60},      {"gluings", campaign::gluings, 150},
    {"overlaps", campaign::overlaps, 6},    {"sections", campaign::sections, 40},
    {"real_sections", campaign::real_sections, 6},
};

struct Row {
    std::size_t cases = 0, checks = 0, failures = 0;
    std::map<std::string, std::size_t> notes;
};

/// More sentences of one case say little more.
constexpr std::size_t max_sentences = 3;

void run(const Family &family, uint64_t seed, Row &row) {
    Case one(seed);
    try {
        family.run(one);
    } catch (const std::exception &error) {
        one.failed.push_back(std::string("an exception: ") + error.what());
    }
    ++row.cases;
    row.checks += one.checks;
    row.failures += one.failed.empty() ? 0 : 1;
    for (const auto &[what, count] : one.notes) {
        row.notes[what] += count;
    }
    for (std::size_t k = 0; k < one.failed.size() && k < max_sentences; ++k) {
        std::printf("--family %s --seed %llu --cases 1: %s\n", family.name, static_cast<unsigned long long>(seed), one.failed[k].c_str());
    }
    if (one.failed.size() > max_sentences) {
        std::printf("  and %zu checks more\n", one.failed.size() - max_sentences);
    }
    std::fflush(stdout);
}

int usage() {
    std::fputs("campaign [--family NAME] [--cases N] [--seed S]; families:", stderr);
    for (const Family &family : families) {
        std::fprintf(stderr, " %s", family.name);
    }
    std::fputc('\n', stderr);
    return 2;
}
} // namespace

int main(int count, char **words) {
    const char *name = nullptr;
    std::size_t cases = 0;
    uint64_t seed = 1;
    for (int k = 1; k < count; k += 2) {
        const std::string option = words[k];
        char *end = nullptr;
        if (k + 1 == count) {
            return usage();
        } else if (option == "--family") {
            name = words[k + 1];
            continue;
        } else if (option == "--cases") {
            cases = std::strtoull(words[k + 1], &end, 10);
        } else if (option == "--seed") {
            seed = std::strtoull(words[k + 1], &end, 10);
        } else {
            return usage();
        }
        if (end == words[k + 1] || *end != '\0') {
            return usage();
        }
    }
    std::vector<std::pair<const Family *, Row>> table;
    for (const Family &family : families) {
        if (name != nullptr && std::strcmp(name, family.name) != 0) {
            continue;
        }
        table.push_back({&family, {}});
        for (std::size_t k = 0; k < (cases != 0 ? cases : family.few); ++k) {
            run(family, seed + k, table.back().second);
        }
    }
    if (table.empty()) {
        return usage();
    }
    std::printf("%-14s %10s %12s %10s\n", "family", "cases", "checks", "failures");
    bool passed = true;
    for (const auto &[family, row] : table) {
        std::printf("%-14s %10zu %12zu %10zu\n", family->name, row.cases, row.checks, row.failures);
        for (const auto &[what, times] : row.notes) {
            std::printf("  %10zu  %s\n", times, what.c_str());
        }
        passed = passed && row.failures == 0;
    }
    return passed ? 0 : 1;
}
