// The manual and the completions of shells, from the same lists as the help.
#pragma once

#include "specs.hpp"

#include <ostream>
#include <string>
#include <vector>

/// what: "man", "bash", "zsh" or "fish". Throws Failure for anything else.
void generate(std::ostream &out, const std::string &what, const std::vector<CommandSpec> &specs);
