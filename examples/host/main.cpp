// gusset-host: loads a plugin and runs its filters on files. It knows gusset_plugin.h and no library of ours.
#include "describe.hpp"
#include "failure.hpp"
#include "plugin.hpp"
#include "run.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <iostream>

namespace {
constexpr const char *footer =
    R"(Meshes are .obj, .off, .ply or .stl files, curves are the lines (l) of .obj files; a line
that ends where it begins is closed.

Exit status:
  0  done
  1  the command is wrong: no such filter or parameter, a value that is none, too many or too few inputs
  2  a file or the standard output cannot be read or written, or a file is of an unknown kind
  3  the plugin cannot be loaded, or broke down
  4  the filter refused its parameters or its inputs, and said why
  5  cancelled
  6  memory could not be had)";

int command(int argc, char **argv) {
    CLI::App app("Runs the filters of a plugin on files.", "gusset-host");
    app.footer(footer);
    app.require_subcommand(1);
    // The name that users have; libgusset.so comes with the headers.
    std::string library = "libgusset.so.0.1";
    app.add_option("--plugin", library, "The plugin, looked for as the system looks for libraries")
        ->capture_default_str();

    RunRequest request;
    app.add_subcommand("list", "Shows all filters: id, inputs -> outputs, category and name");

    CLI::App *describing = app.add_subcommand("describe", "Shows what a filter does, and its parameters");
    describing->add_option("filter", request.filter, "The id of the filter")->required();
    describing->add_option("inputs", request.inputs, "Files to suggest values for");

    CLI::App *running = app.add_subcommand("run", "Runs a filter; its texts go to the standard output");
    running->add_option("filter", request.filter, "The id of the filter")->required();
    running->add_option("inputs", request.inputs, "The files that it reads");
    // One argument each time: what follows may be an input.
    running->add_option("-p,--param", request.params, "name=value: a choice by label or number, a vector as x,y,z")
        ->allow_extra_args(false);
    running
        ->add_option("-o,--output", request.outputs,
                     "The file of the first mesh or curves that come out; again for the next")
        ->allow_extra_args(false);
    running->add_option("--threads", request.threads, "0: as many as the machine has")->capture_default_str();
    running->add_flag("--progress", request.progress, "Shows progress, which it does by itself in a terminal");
    running->add_option("--cancel-after", request.cancel_after, "Seconds after which the run is cancelled")
        ->check(CLI::NonNegativeNumber);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        return static_cast<int>(app.exit(error) == 0 ? Exit::done : Exit::usage);
    }

    const Plugin plugin(library);
    if (running->parsed()) {
        request.progress = request.progress || isatty(STDERR_FILENO) != 0;
        run(plugin, request);
    } else if (describing->parsed()) {
        const gusset_filter &filter = *plugin.find(request.filter);
        Suggested suggested{};
        if (!request.inputs.empty()) {
            suggested = suggest(filter, Inputs(filter, request.inputs));
        }
        if (suggested.status != GUSSET_PLUGIN_DONE) {
            throw Failure(exit_of(suggested.status), request.filter + " refuses these inputs (status " +
                                                         std::to_string(suggested.status) + "); 'gusset-host run " +
                                                         request.filter + " ...' says why");
        }
        describe(std::cout, filter, suggested.values);
    } else {
        list(std::cout, plugin);
    }
    if (!std::cout.flush()) {
        throw Failure(Exit::file, "the standard output cannot be written");
    }
    return static_cast<int>(Exit::done);
}
} // namespace

int main(int argc, char **argv) {
    try {
        return command(argc, argv);
    } catch (const Failure &failure) {
        std::cerr << "gusset-host: " << failure.what() << '\n';
        return static_cast<int>(failure.exit);
    } catch (const std::exception &error) {
        // Memory, that is to say.
        std::cerr << "gusset-host: " << error.what() << '\n';
        return static_cast<int>(Exit::memory);
    }
}
