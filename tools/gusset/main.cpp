// gusset: runs the filters of a plugin on files. It knows gusset_plugin.h and no library of ours.
#include "arguments.hpp"
#include "describe.hpp"
#include "failure.hpp"
#include "generate.hpp"
#include "plugin.hpp"
#include "run.hpp"

#include <unistd.h>

#include <charconv>
#include <iostream>

namespace {
/// Found beside the program, whose search path leads there, or else where the system looks.
constexpr const char *own_library = GUSSET_LIBRARY;

/// The plugin, or why there is none: help is to be had without.
struct Loaded {
    std::optional<Plugin> plugin;
    std::optional<Failure> failure;

    const Plugin &get() const {
        if (failure) {
            throw *failure;
        }
        return *plugin;
    }
};

Loaded load_plugin(const std::string &name) {
    Loaded loaded;
    try {
        loaded.plugin.emplace(name.empty() ? own_library : name);
    } catch (const Failure &failure) {
        loaded.failure = failure;
    }
    return loaded;
}

RunRequest request_of(const Arguments &arguments, const CommandSpec &spec) {
    RunRequest request;
    request.command = arguments.command;
    request.filter = spec.filter.empty() ? arguments.one("filter") : spec.filter;
    request.inputs = input_files(arguments.all("input"));
    request.params = arguments.all("--param");
    for (const OptionSpec &option : spec.options) {
        if (!option.parameter.empty() && arguments.has(option.name)) {
            request.params.push_back(option.parameter + '=' + arguments.one(option.name));
        }
    }
    request.outputs = arguments.all("--output");
    request.dry = arguments.has("--dry-run");
    request.text = arguments.has("--text");
    request.json = arguments.has("--json");
    // The parser has looked at these.
    const std::string threads = arguments.one("--threads", "0");
    std::from_chars(threads.data(), threads.data() + threads.size(), request.threads);
    if (arguments.has("--cancel-after")) {
        request.cancel_after = std::stod(arguments.one("--cancel-after"));
    }
    request.progress = arguments.has("--progress") || isatty(STDERR_FILENO) != 0;
    return request;
}

void show_filters(const Plugin &plugin, const Arguments &arguments) {
    const bool json = arguments.has("--json");
    if (!arguments.has("filter")) {
        if (arguments.has("--ids")) {
            for (const auto *filter : plugin.filters()) {
                std::cout << filter->id << '\n';
            }
        } else if (json) {
            Json all = Json::array();
            for (const auto *filter : plugin.filters()) {
                all.push_back(json_of(*filter, {}, false));
            }
            std::cout << all.dump(2) << '\n';
        } else {
            list(std::cout, plugin);
        }
        return;
    }
    const gusset_filter &filter = *plugin.find(arguments.one("filter"));
    const auto inputs = arguments.all("input");
    Suggested suggested{};
    if (!inputs.empty()) {
        suggested = suggest(filter, Inputs(filter, input_files(inputs)));
    }
    if (suggested.status != GUSSET_PLUGIN_DONE) {
        throw Failure(exit_of(suggested.status), std::string(filter.id) + " refuses these inputs (status " +
                                                     std::to_string(suggested.status) + "); 'gusset run " + filter.id +
                                                     " ...' says why");
    }
    if (json) {
        std::cout << json_of(filter, suggested.values, true).dump(2) << '\n';
    } else {
        describe(std::cout, filter, suggested.values);
    }
}

void dispatch(const Arguments &arguments, const std::vector<CommandSpec> &specs, const Loaded &loaded) {
    const auto spec =
        std::find_if(specs.begin(), specs.end(), [&](const CommandSpec &one) { return one.name == arguments.command; });
    if (arguments.command == "generate") {
        static_cast<void>(loaded.get());
        generate(std::cout, arguments.one("what"), specs);
    } else if (arguments.command == "filters") {
        show_filters(loaded.get(), arguments);
    } else if (arguments.command == "convert") {
        convert(request_of(arguments, *spec));
    } else {
        run(loaded.get(), request_of(arguments, *spec));
    }
    if (!std::cout.flush()) {
        throw Failure(Exit::file, "the standard output cannot be written");
    }
}

int fail(const Failure &failure, const Arguments *arguments) {
    std::cerr << "gusset: " << failure.what() << '\n';
    if (arguments != nullptr && arguments->has("--json")) {
        std::cout << Json{{"command", arguments->command}, {"error", json_of(failure)}}.dump(2) << '\n' << std::flush;
    }
    return static_cast<int>(failure.exit);
}

int command(int argc, char **argv) {
    const Loaded loaded = load_plugin(plugin_of(argc, argv));
    const auto specs = command_specs(loaded.plugin ? &*loaded.plugin : nullptr);
    const std::string library = loaded.plugin ? std::string((*loaded.plugin)->name) + ' ' + (*loaded.plugin)->version
                                              : std::string("none: ") + loaded.failure->what();
    int status = 0;
    const auto arguments = parse(argc, argv, specs, "gusset " GUSSET_VERSION "\nlibrary: " + library, status);
    if (!arguments) {
        // Without a library a command has fewer options, and what it lacks is said.
        if (status != 0 && loaded.failure) {
            return fail(*loaded.failure, nullptr);
        }
        return status;
    }
    try {
        dispatch(*arguments, specs, loaded);
        return static_cast<int>(Exit::done);
    } catch (const Failure &failure) {
        return fail(failure, &*arguments);
    } catch (const std::bad_alloc &) {
        return fail({Exit::memory, "memory could not be had"}, &*arguments);
    }
}
} // namespace

int main(int argc, char **argv) {
    try {
        return command(argc, argv);
    } catch (const Failure &failure) {
        return fail(failure, nullptr);
    } catch (const std::exception &error) {
        // Memory, that is to say.
        std::cerr << "gusset: " << error.what() << '\n';
        return static_cast<int>(Exit::memory);
    }
}
