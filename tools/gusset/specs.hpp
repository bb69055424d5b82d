// The command line as data: help, the manual and the completions of shells are made from the same lists.
#pragma once

#include "plugin.hpp"

#include <cstdint>
#include <string>
#include <vector>

enum class ValueKind { flag, text, file, count, seconds };

struct OptionSpec {
    /// "--output".
    std::string name;
    /// "-o", or empty.
    std::string letter;
    ValueKind kind = ValueKind::flag;
    /// What stands for the value in help: "FILE". Of flags nothing.
    std::string value;
    std::string help;
    /// The words that it takes, if it takes no others.
    std::vector<std::string> choices;
    bool repeats = false;
    /// The parameter of the filter that it sets, if it does.
    std::string parameter;
};

struct ArgumentSpec {
    std::string name, help;
    std::size_t least, most;
    bool is_file;
};

struct CommandSpec {
    std::string name, summary;
    /// The filter that it runs, or empty.
    std::string filter;
    std::vector<ArgumentSpec> arguments;
    std::vector<OptionSpec> options;
    /// Made for the build, not for people.
    bool hidden = false;
};

/// All commands. Without a plugin, commands that run a filter of its have no parameters.
std::vector<CommandSpec> command_specs(const Plugin *plugin);
/// Options before or after any command.
const std::vector<OptionSpec> &common_options();

/// A line in --help and in the manual each.
struct ExitStatus {
    int status;
    const char *meaning;
};
const std::vector<ExitStatus> &exit_statuses();

extern const char *const program_summary;
extern const char *const formats_text;

/// "By mean edge" as a word: "by-mean-edge".
std::string slug(const std::string &label);
