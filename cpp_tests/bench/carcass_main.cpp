// Benchmarks of carcasses: ours, trees of triangles and kernels of CAD in one process, by turns. Prints a table and writes a report.
#include "carcass_cases.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

int main(int argc, char **argv) {
    CLI::App app("Carcasses beside trees of triangles and kernels of CAD; ratio = peer / ours");
    carcass::Bench::Options options;
    std::string out = "carcass.json", questions;
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
            carcass::write_questions(questions);
        }
        carcass::Bench bench(options);
        carcass::same_nodes(bench);
        carcass::many_nodes(bench);
        carcass::kernels(bench);
        bench.write(out);
    } catch (const std::exception &error) {
        std::cerr << "carcass: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
