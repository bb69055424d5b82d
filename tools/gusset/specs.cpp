#include "specs.hpp"

#include "values.hpp"

#include <algorithm>
#include <cctype>

const char *const program_summary = "Joins, fills, mends and checks meshes in files.";

const char *const formats_text =
    "Meshes are .obj, .ply, .stl, .off, .gltf or .glb files, or .conf files that list scans and where they lie; curves are "
    "the lines (l) of .obj files; a line that ends where it begins is closed. Colours, normals, texture coordinates and materials are kept: old vertices and faces "
    "have what they had, new ones what they lie between. What a format cannot hold is named on the standard error. "
    "PLY and STL files are written in binary, unless --text is given.";

namespace {
struct FilterCommand {
    const char *name, *filter, *summary, *inputs;
    std::size_t least, most;
    bool makes_mesh;
};

constexpr std::size_t many = 1 << 16;

constexpr FilterCommand filter_commands[] = {
    {"stitch", "stitch", "Joins two open meshes, or two rims of one mesh, by a strip of new faces",
     "The two meshes, or the one", 1, 2, true},
    {"fill", "fill_holes", "Closes the holes of a mesh by new faces", "The mesh", 1, 1, true},
    {"assemble", "assemble", "Joins any number of open meshes where their rims meet or face each other", "The meshes",
     1, many, true},
    {"weld", "weld", "Makes borders that coincide one", "The mesh", 1, 1, true},
    {"orient", "orient", "Turns faces over until neighbours agree", "The mesh", 1, 1, true},
    {"check", "check", "Says what is wrong with a mesh, and how many pieces, edges and handles it has", "The mesh", 1,
     1, false},
};

OptionSpec flag(const char *name, const char *letter, const char *help) {
    return {name, letter, ValueKind::flag, "", help, {}, false, ""};
}

OptionSpec option(const char *name, const char *letter, ValueKind kind, const char *value, const char *help) {
    return {name, letter, kind, value, help, {}, false, ""};
}

OptionSpec json() { return flag("--json", "", "Prints the report as JSON, and refusals too"); }
OptionSpec text() { return flag("--text", "", "Writes PLY and STL files as text"); }

void add_steering(std::vector<OptionSpec> &options) {
    options.push_back(json());
    options.push_back(
        option("--threads", "", ValueKind::count, "N", "Threads; 0: as many as the machine has (default)"));
    options.push_back(flag("--progress", "", "Shows progress, which it does by itself in a terminal"));
    options.push_back(
        option("--cancel-after", "", ValueKind::seconds, "SECONDS", "Cancels the run after so many seconds"));
}

void add_outputs(std::vector<OptionSpec> &options, const char *help, bool repeats) {
    options.push_back(option("--output", "-o", ValueKind::file, "FILE", help));
    options.back().repeats = repeats;
    options.push_back(flag("--dry-run", "-n", "Prints the report and writes no file"));
    options.push_back(text());
}

std::string placeholder(const gusset_param_info &param) {
    switch (param.kind) {
    case GUSSET_PARAM_BOOL:
        return "";
    case GUSSET_PARAM_CHOICE:
        return "CHOICE";
    case GUSSET_PARAM_INT:
        return "N";
    case GUSSET_PARAM_LENGTH:
        return "LENGTH";
    default:
        return param.arity == 1 ? "NUMBER" : "NUMBERS";
    }
}

OptionSpec parameter(const gusset_param_info &param) {
    OptionSpec made;
    made.name = "--" + slug(param.id);
    made.kind = param.kind == GUSSET_PARAM_BOOL ? ValueKind::flag : ValueKind::text;
    made.value = placeholder(param);
    made.help = param.help;
    made.parameter = param.id;
    for (uint32_t c = 0; c < param.choice_count; ++c) {
        made.choices.push_back(slug(param.choices[c].label));
    }
    if (!made.help.empty() && made.help.back() == '.') {
        made.help.pop_back();
    }
    std::string words;
    for (const std::string &choice : made.choices) {
        const auto place = static_cast<std::size_t>(&choice - made.choices.data());
        words += (words.empty() ? "" : ", ") + choice;
        words += static_cast<double>(place) == param.default_values[0] ? " (default)" : "";
    }
    if (!words.empty()) {
        made.help += ": " + words;
    } else if (made.kind != ValueKind::flag) {
        made.help += " (default " + print_value(param, param.default_values) + ')';
    }
    return made;
}
} // namespace

std::string slug(const std::string &label) {
    std::string made;
    for (const char c : label) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) {
            made += static_cast<char>(std::tolower(byte));
        } else if (!made.empty() && made.back() != '-') {
            made += '-';
        }
    }
    while (!made.empty() && made.back() == '-') {
        made.pop_back();
    }
    return made;
}

const std::vector<OptionSpec> &common_options() {
    static const std::vector<OptionSpec> options = {
        option(
            "--plugin", "", ValueKind::file, "LIBRARY",
            "The plugin whose filters are run, looked for as the system looks for libraries; otherwise the library of "
            "gusset"),
    };
    return options;
}

const std::vector<ExitStatus> &exit_statuses() {
    static const std::vector<ExitStatus> statuses = {
        {0, "done, whatever the report says of the mesh"},
        {1, "the command is wrong: no such filter or parameter, a value that is none, too many or too few inputs"},
        {2, "a file or the standard output cannot be read or written, or a file is of an unknown kind"},
        {3, "the plugin cannot be loaded, or broke down"},
        {4, "the filter refused its parameters or its inputs, and said why"},
        {5, "cancelled"},
        {6, "memory could not be had"},
    };
    return statuses;
}

std::vector<CommandSpec> command_specs(const Plugin *plugin) {
    std::vector<CommandSpec> all;
    for (const FilterCommand &of : filter_commands) {
        CommandSpec made{of.name, of.summary, of.filter, {{"input", of.inputs, of.least, of.most, true}}, {}, false};
        if (of.makes_mesh) {
            add_outputs(made.options, "The file of the mesh that comes out", false);
        }
        const gusset_filter *filter = plugin == nullptr ? nullptr : plugin->find_or_null(of.filter);
        if (filter != nullptr) {
            for (const auto *param : params(*filter)) {
                made.options.push_back(parameter(*param));
            }
        }
        add_steering(made.options);
        all.push_back(std::move(made));
    }
    CommandSpec convert{"convert",
                        "Reads a mesh and writes it in another format",
                        "",
                        {{"input", "The mesh", 1, 1, true}},
                        {option("--output", "-o", ValueKind::file, "FILE", "The file that is written"), text(), json()},
                        false};
    CommandSpec filters{
        "filters",
        "Lists all filters, or describes one and its parameters",
        "",
        {{"filter", "The filter to describe", 0, 1, false}, {"input", "Files to suggest values for", 0, many, true}},
        {flag("--ids", "", "Lists the names of the filters alone"), json()},
        false};
    CommandSpec run{"run",
                    "Runs any filter",
                    "",
                    {{"filter", "The filter, as 'gusset filters' names it", 1, 1, false},
                     {"input", "The files that it reads", 0, many, true}},
                    {option("--param", "-p", ValueKind::text, "NAME=VALUE",
                            "A parameter: a choice by its words or number, a vector as x,y,z; may be repeated")},
                    false};
    run.options.back().repeats = true;
    add_outputs(run.options, "The file of the first mesh or curves that come out; again for the next", true);
    add_steering(run.options);
    CommandSpec generate{"generate", "Prints the manual or the completions of a shell",
                         "",         {{"what", "man, bash, zsh or fish", 1, 1, false}},
                         {},         true};
    for (CommandSpec *one : {&convert, &filters, &run, &generate}) {
        all.push_back(std::move(*one));
    }
    return all;
}
