#include "app/examples_of_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace covaria {

void add_examples(CLI::App& command, std::initializer_list<CommandExample> examples,
                  const std::string& more) {
    std::string text = "Examples:\n";
    for (const CommandExample& example : examples) {
        if (!example.does.empty()) text += "  # " + example.does + "\n";
        text += "  covaria " + example.line + "\n";
    }
    if (!more.empty()) text += "\n" + more;
    command.footer(text);
}

}  // namespace covaria
