#include "arguments.hpp"

#include "failure.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <string_view>

std::vector<std::string> Arguments::all(const std::string &name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::vector<std::string>() : found->second;
}

std::string Arguments::one(const std::string &name, const std::string &otherwise) const {
    const auto found = all(name);
    return found.empty() ? otherwise : found.back();
}

namespace {
std::string footer() {
    std::string text = std::string("\n") + formats_text + "\n\nExit status:\n";
    for (const ExitStatus &one : exit_statuses()) {
        text += "  " + std::to_string(one.status) + "  " + one.meaning + '\n';
    }
    return text + "\n'gusset COMMAND --help' shows the options of a command; see also gusset(1).";
}

CLI::Option *add(CLI::App &app, const OptionSpec &of, std::vector<std::string> &values) {
    const std::string names = of.letter.empty() ? of.name : of.letter + ',' + of.name;
    if (of.kind == ValueKind::flag) {
        return app.add_flag(names, values, of.help);
    }
    CLI::Option *made = app.add_option(names, values, of.help)->type_name(of.value);
    // One value each time: what follows may be an input.
    made->allow_extra_args(false);
    made->multi_option_policy(of.repeats ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::Throw);
    if (!of.repeats) {
        made->expected(1);
    }
    if (of.kind == ValueKind::count) {
        made->check(CLI::TypeValidator<uint32_t>("N"), "a whole number");
        made->type_name(of.value);
    } else if (of.kind == ValueKind::seconds) {
        made->check(CLI::NonNegativeNumber);
        made->type_name(of.value);
    }
    return made;
}
/// An option that the command does not have, in words: the parser may speak of what follows it instead.
std::string unknown_option(int argc, char **argv, const std::vector<CommandSpec> &specs) {
    const auto named = [](const std::vector<OptionSpec> &options, const std::string &name) {
        return std::any_of(options.begin(), options.end(),
                           [&](const OptionSpec &option) { return option.name == name; });
    };
    const CommandSpec *command = nullptr;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        const std::string name = word.substr(0, word.find('='));
        if (command == nullptr) {
            const auto found =
                std::find_if(specs.begin(), specs.end(), [&](const CommandSpec &spec) { return spec.name == word; });
            command = found == specs.end() ? nullptr : &*found;
        } else if (name.size() > 2 && name.compare(0, 2, "--") == 0 && name != "--help" && name != "--version" &&
                   !named(command->options, name) && !named(common_options(), name)) {
            return command->name + " has no option " + name + "; 'gusset " + command->name +
                   " --help' lists those it has";
        }
    }
    return "";
}
} // namespace

std::string plugin_of(int argc, char **argv) {
    constexpr std::string_view name = "--plugin";
    for (int k = 1; k < argc; ++k) {
        const std::string_view word = argv[k];
        if (word == name && k + 1 < argc) {
            return argv[k + 1];
        }
        if (word.substr(0, name.size() + 1) == "--plugin=") {
            return std::string(word.substr(name.size() + 1));
        }
    }
    return "";
}

std::optional<Arguments> parse(int argc, char **argv, const std::vector<CommandSpec> &specs, const std::string &version,
                               int &status) {
    CLI::App app(program_summary, "gusset");
    app.footer(footer());
    app.set_version_flag("--version", version, "Prints the version of the program and of the library");
    app.require_subcommand(1);
    app.fallthrough();
    // Stable while the parser writes to them.
    std::map<std::string, std::map<std::string, std::vector<std::string>>> values;
    std::map<std::string, CLI::App *> commands;
    std::map<std::string, std::vector<std::string>> common;
    for (const OptionSpec &option : common_options()) {
        add(app, option, common[option.name]);
    }
    for (const CommandSpec &spec : specs) {
        CLI::App *command = app.add_subcommand(spec.name, spec.summary);
        commands[spec.name] = command;
        if (spec.hidden) {
            command->group("");
        }
        auto &own = values[spec.name];
        for (const ArgumentSpec &argument : spec.arguments) {
            CLI::Option *made = command->add_option(argument.name, own[argument.name], argument.help);
            made->type_name(argument.is_file ? "FILE" : "NAME");
            made->expected(1, static_cast<int>(argument.most));
            made->allow_extra_args(argument.most > 1);
            made->required(argument.least > 0);
        }
        for (const OptionSpec &option : spec.options) {
            add(*command, option, own[option.name]);
        }
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        const std::string unknown = unknown_option(argc, argv, specs);
        if (error.get_exit_code() != 0 && !unknown.empty()) {
            std::cerr << "gusset: " << unknown << '\n';
            status = static_cast<int>(Exit::usage);
            return std::nullopt;
        }
        status = static_cast<int>(app.exit(error) == 0 ? Exit::done : Exit::usage);
        return std::nullopt;
    }
    Arguments made;
    made.values = common;
    for (const auto &[name, command] : commands) {
        if (command->parsed()) {
            made.command = name;
            made.values.insert(values[name].begin(), values[name].end());
        }
    }
    for (auto next = made.values.begin(); next != made.values.end();) {
        next = next->second.empty() ? made.values.erase(next) : std::next(next);
    }
    return made;
}
