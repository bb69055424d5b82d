#include "generate.hpp"

#include "failure.hpp"

#include <algorithm>

namespace {
std::vector<CommandSpec> shown(const std::vector<CommandSpec> &specs) {
    std::vector<CommandSpec> all;
    std::copy_if(specs.begin(), specs.end(), std::back_inserter(all),
                 [](const CommandSpec &spec) { return !spec.hidden; });
    return all;
}

std::string replaced(std::string text, const std::string &what, const std::string &by) {
    for (std::size_t place = 0; (place = text.find(what, place)) != std::string::npos; place += by.size()) {
        text.replace(place, what.size(), by);
    }
    return text;
}

// --- the manual

/// Text as troff takes it: hyphens are those that are typed, and no line begins with a command.
std::string troff(const std::string &text) {
    const std::string made = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    return !made.empty() && (made[0] == '.' || made[0] == '\'') ? "\\&" + made : made;
}

void option(std::ostream &out, const OptionSpec &of) {
    out << ".TP\n";
    if (!of.letter.empty()) {
        out << ".BR " << troff(of.letter) << " \", \" " << troff(of.name);
    } else {
        out << ".B " << troff(of.name);
    }
    if (!of.value.empty()) {
        // One line: a name and what it takes, in their own type.
        out << (of.letter.empty() ? " \\fI" : " \" \\fI") << troff(of.value) << (of.letter.empty() ? "\\fR" : "\\fR\"");
    }
    out << '\n' << troff(of.help) << ".\n";
}

std::string argument(const ArgumentSpec &of) {
    std::string name = "\\fI" + of.name + "\\fR";
    name += of.most > 1 ? " ..." : "";
    return of.least == 0 ? '[' + name + ']' : name;
}

void manual(std::ostream &out, const std::vector<CommandSpec> &specs) {
    out << ".TH GUSSET 1 \"\" \"gusset " GUSSET_VERSION "\" \"User Commands\"\n"
        << ".SH NAME\ngusset \\- joins, fills, mends and checks meshes in files\n.SH SYNOPSIS\n";
    for (const CommandSpec &spec : specs) {
        out << ".B gusset " << troff(spec.name) << "\\fR";
        for (const ArgumentSpec &of : spec.arguments) {
            out << ' ' << argument(of);
        }
        out << " [\\fIoption\\fR ...]\n.br\n";
    }
    out << ".B gusset \\-\\-help\n.br\n.B gusset \\-\\-version\n"
        << ".SH DESCRIPTION\n"
        << troff(program_summary) << '\n'
        << troff(formats_text) << "\n.SH OPTIONS\n";
    for (const OptionSpec &of : common_options()) {
        option(out, of);
    }
    option(out,
           {"--help", "-h", ValueKind::flag, "", "Shows what there is; behind a command, its options", {}, false, ""});
    option(
        out,
        {"--version", "", ValueKind::flag, "", "Prints the version of the program and of the library", {}, false, ""});
    out << ".SH COMMANDS\n";
    for (const CommandSpec &spec : specs) {
        out << ".SS gusset " << troff(spec.name) << '\n' << troff(spec.summary) << ".\n";
        if (!spec.filter.empty()) {
            out << "It is the filter\n.BR " << troff(spec.filter) << ".\n";
        }
        for (const ArgumentSpec &of : spec.arguments) {
            out << ".TP\n.I " << troff(of.name) << '\n' << troff(of.help) << ".\n";
        }
        for (const OptionSpec &of : spec.options) {
            option(out, of);
        }
    }
    out << ".SH EXIT STATUS\n";
    for (const ExitStatus &one : exit_statuses()) {
        out << ".TP\n.B " << one.status << '\n' << troff(one.meaning) << '\n';
    }
    out << R"(.SH EXAMPLES
.TP
.B gusset stitch left.ply right.ply \-o joined.ply
Joins the nearest rims of two open meshes by triangles.
.TP
.B gusset stitch left.ply right.ply \-\-rows by\-mean\-edge \-\-fairing fair \-o joined.glb
The same by a smooth strip of several rows, as glTF.
.TP
.B gusset fill scan.obj \-\-inside refined\-and\-fair \-\-keep\-longest \-o filled.obj
Closes all holes but the outline.
.TP
.B gusset check part.stl \-\-json
The defects of a mesh, and their numbers for programs.
.TP
.B gusset \-\-plugin ./other.so filters
The filters of another plugin.
.SH SEE ALSO
The filters with all their parameters:
.IR docs/filters.md ;
plugins:
.IR docs/guides/plugin.md ,
both where the documentation of gusset is installed.
)";
}

// --- completions

std::string names(const std::vector<CommandSpec> &specs) {
    std::string all;
    for (const CommandSpec &spec : specs) {
        all += (all.empty() ? "" : " ") + spec.name;
    }
    return all;
}

std::string words(const std::vector<std::string> &list, const char *between = " ") {
    std::string all;
    for (const std::string &word : list) {
        all += (all.empty() ? "" : between) + word;
    }
    return all;
}

std::string files(const char *between) { return words({"obj", "ply", "stl", "off", "gltf", "glb"}, between); }

/// The options of a command and those of all.
std::vector<OptionSpec> options_of(const CommandSpec &spec) {
    std::vector<OptionSpec> all = spec.options;
    all.insert(all.end(), common_options().begin(), common_options().end());
    return all;
}

bool names_a_filter(const CommandSpec &spec) { return !spec.arguments.empty() && spec.arguments[0].name == "filter"; }

void bash(std::ostream &out, const std::vector<CommandSpec> &specs) {
    out << R"sh(# Completion of gusset for bash.
_gusset() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command='' place=0 k
    for ((k = 1; k < COMP_CWORD; ++k)); do
        case ${COMP_WORDS[k]} in
            --plugin) ((++k)) ;;
            -*) ;;
            *)
                [ -n "$command" ] && ((++place))
                [ -z "$command" ] && command=${COMP_WORDS[k]}
                ;;
        esac
    done
    COMPREPLY=()
    local options=''
    case $command,$before in
)sh";
    for (const CommandSpec &spec : specs) {
        for (const OptionSpec &of : options_of(spec)) {
            const std::string pattern =
                "        " + spec.name + ',' + of.name + (of.letter.empty() ? "" : " | " + spec.name + ',' + of.letter);
            if (!of.choices.empty()) {
                out << pattern << ") COMPREPLY=($(compgen -W '" << words(of.choices) << "' -- \"$word\")); return ;;\n";
            } else if (of.kind == ValueKind::file) {
                out << pattern
                    << ") COMPREPLY=($(compgen -f -- \"$word\")); compopt -o filenames 2>/dev/null; return ;;\n";
            } else if (of.kind != ValueKind::flag) {
                out << pattern << ") return ;;\n";
            }
        }
    }
    out << "    esac\n    case $command in\n        '') COMPREPLY=($(compgen -W '" << names(specs)
        << " --help --version --plugin' -- \"$word\")); return ;;\n";
    for (const CommandSpec &spec : specs) {
        std::string all = "--help";
        for (const OptionSpec &of : options_of(spec)) {
            all += ' ' + of.name;
        }
        out << "        " << spec.name << ") options='" << all << "' ;;\n";
    }
    out << R"sh(    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
        return
    fi
    if [[ $command == run || $command == filters ]] && ((place == 0)); then
        COMPREPLY=($(compgen -W "$("${COMP_WORDS[0]}" filters --ids 2>/dev/null)" -- "$word"))
        return
    fi
    local IFS=$'\n'
    COMPREPLY=($(compgen -f -X '!*.@()sh"
        << files("|") << R"sh()' -- "$word") $(compgen -d -- "$word"))
    compopt -o filenames 2>/dev/null
}
shopt -s extglob
complete -F _gusset gusset
)sh";
}

/// Between single quotes, and for zsh's descriptions without what ends them.
std::string quoted(std::string text, bool zsh) {
    if (zsh) {
        text = replaced(replaced(replaced(replaced(text, "\\", "\\\\"), "[", "\\["), "]", "\\]"), ":", "\\:");
    }
    return replaced(text, "'", "'\\''");
}

void zsh(std::ostream &out, const std::vector<CommandSpec> &specs) {
    out << "#compdef gusset\n# Completion of gusset for zsh.\n_gusset() {\n    local context state line\n    local -a "
           "commands\n    commands=(\n";
    for (const CommandSpec &spec : specs) {
        out << "        '" << spec.name << ':' << quoted(spec.summary, true) << "'\n";
    }
    out << "    )\n    _arguments -C '--help[Shows what there is]' '--version[Prints the version]' \\\n"
           "        '--plugin[The plugin]:library:_files' '1:command:->command' '*::argument:->argument'\n"
           "    case $state in\n        command) _describe command commands ;;\n        argument)\n            case "
           "$words[1] in\n";
    const std::string meshes = "_files -g \"*.(" + files("|") + ")\"";
    for (const CommandSpec &spec : specs) {
        out << "                " << spec.name << ") _arguments '(-h --help)'{-h,--help}'[Shows the options]'";
        for (const OptionSpec &of : options_of(spec)) {
            std::string value;
            if (of.kind != ValueKind::flag) {
                value = ':' + of.value + ':';
                value += !of.choices.empty()          ? '(' + words(of.choices) + ')'
                         : of.kind == ValueKind::file ? "_files"
                                                      : " ";
            }
            const std::string text = '[' + quoted(of.help, true) + ']' + value;
            const std::string many = of.repeats ? "*" : "";
            out << " \\\n                    ";
            if (of.letter.empty()) {
                out << '\'' << many << of.name << text << '\'';
            } else if (of.repeats) {
                out << "'*'{" << of.letter << ',' << of.name << "}'" << text << '\'';
            } else {
                out << "'(" << of.letter << ' ' << of.name << ")'{" << of.letter << ',' << of.name << "}'" << text
                    << '\'';
            }
        }
        if (names_a_filter(spec)) {
            out << " \\\n                    '1:filter:($(_call_program filters gusset filters --ids))'";
        }
        out << " \\\n                    '*:file:" << meshes << "' ;;\n";
    }
    out << "            esac ;;\n    esac\n}\nif [ \"$funcstack[1]\" = _gusset ]; then\n    _gusset \"$@\"\nelse\n    "
           "compdef _gusset gusset\nfi\n";
}

void fish(std::ostream &out, const std::vector<CommandSpec> &specs) {
    const std::string start = "complete -c gusset -n ";
    out << "# Completion of gusset for fish.\nset -l commands " << names(specs) << '\n'
        << start << "\"not __fish_seen_subcommand_from $commands\" -f\n"
        << start << "\"not __fish_seen_subcommand_from $commands\" -l version -d 'Prints the version'\n"
        << "complete -c gusset -s h -l help -d 'Shows what there is'\n";
    for (const OptionSpec &of : common_options()) {
        out << "complete -c gusset -l " << of.name.substr(2) << " -r -F -d '" << quoted(of.help, false) << "'\n";
    }
    for (const CommandSpec &spec : specs) {
        out << start << "\"not __fish_seen_subcommand_from $commands\" -a " << spec.name << " -d '"
            << quoted(spec.summary, false) << "'\n";
        const std::string within = start + "'__fish_seen_subcommand_from " + spec.name + "' ";
        if (names_a_filter(spec)) {
            out << within << "-a '(gusset filters --ids 2>/dev/null)'\n";
        }
        for (const OptionSpec &of : spec.options) {
            out << within << "-l " << of.name.substr(2);
            if (!of.letter.empty()) {
                out << " -s " << of.letter.substr(1);
            }
            if (!of.choices.empty()) {
                out << " -x -a '" << words(of.choices) << '\'';
            } else if (of.kind == ValueKind::file) {
                out << " -r -F";
            } else if (of.kind != ValueKind::flag) {
                out << " -x";
            }
            out << " -d '" << quoted(of.help, false) << "'\n";
        }
    }
}
} // namespace

void generate(std::ostream &out, const std::string &what, const std::vector<CommandSpec> &specs) {
    const auto all = shown(specs);
    if (what == "man") {
        manual(out, all);
    } else if (what == "bash") {
        bash(out, all);
    } else if (what == "zsh") {
        zsh(out, all);
    } else if (what == "fish") {
        fish(out, all);
    } else {
        throw Failure(Exit::usage, "there is no such thing to generate: " + what);
    }
}
