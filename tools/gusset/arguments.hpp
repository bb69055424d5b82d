// The words of a command line, sorted by what they mean.
#pragma once

#include "specs.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

struct Arguments {
    std::string command;
    /// By the names of the arguments and of the options, "--output"; flags that are given have the value "true".
    std::map<std::string, std::vector<std::string>> values;

    bool has(const std::string &name) const { return values.count(name) > 0; }
    std::vector<std::string> all(const std::string &name) const;
    std::string one(const std::string &name, const std::string &otherwise = "") const;
};

/// Nothing if the program is done with it: help was asked for, or the words were wrong; `status` is how it ends then.
std::optional<Arguments> parse(int argc, char **argv, const std::vector<CommandSpec> &specs, const std::string &version,
                               int &status);

/// What --plugin says, before the rest is understood: the options of commands depend on it.
std::string plugin_of(int argc, char **argv);
