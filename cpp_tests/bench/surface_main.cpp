// Benchmarks of surfaces: ours, trees of triangles and kernels of CAD in one process, by turns. Prints a table and writes a report.
#include "surface_cases.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

int main(int argc, char **argv) {
    CLI::App app("Surfaces beside trees of triangles and kernels of CAD; ratio = peer / ours");
    surface::Bench::Options options;
    std::string out = "surface.json", questions;
    app.add_option("--only", options.only, "cases whose names contain this");
    app.add_option("--runs", options.runs, "runs of each; medians are reported")->check(CLI::Range(1, 1000));
    app.add_option("--patience", options.patience, "milliseconds after which one that is slow has no more runs");
    app.add_flag("--processor", options.by_processor, "time of the processor, all threads together: for a machine that is busy");
    app.add_option("--out", out, "the report");
    app.add_option("--questions", questions, "also write what the kernels of CAD are asked into this file");
    app.add_flag("--slow", options.slow, "also what takes half a minute a run");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!questions.empty()) {
            surface::write_questions(questions);
        }
        surface::Bench bench(options);
        surface::same_nodes(bench);
        surface::many_nodes(bench);
        surface::kernels(bench);
        bench.write(out);
    } catch (const std::exception &error) {
        std::cerr << "surface: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
