// Examples at the end of a command's --help.
#pragma once

#include <initializer_list>
#include <string>

namespace CLI {
class App;
}

namespace covaria {

struct CommandExample {
    std::string line;       ///< without "covaria": "run my.covaria --trials 1e6"
    std::string does = {};  ///< its use, where the line does not tell it
};

/// `more`: what stands below them. tests/app/help_test.cpp runs every example of every command in a folder
/// with the shipped projects.
void add_examples(CLI::App& command, std::initializer_list<CommandExample> examples,
                  const std::string& more = {});

}  // namespace covaria
