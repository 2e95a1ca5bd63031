// covaria library: the assets that can be copied into projects.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/made/library.h"

namespace covaria {
namespace {

int list_library() {
    const Library library = load_library();
    std::string collection;
    for (const LibraryItem& item : library.items) {
        if (item.collection != collection) std::printf("%s\n", item.collection.c_str());
        collection = item.collection;
        std::printf("  %-24s %s\n", item.asset.name.c_str(), item.asset.notes.c_str());
    }
    std::printf("\nOwn collections are project files in %s\n", own_library_folder().c_str());
    for (const Problem& problem : library.problems.items()) print_message(problem.message);
    return library.problems.has_errors() ? exit_bad_input : exit_success;
}

}  // namespace

Command library_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("library", "List the instruments and robots of the library");
    return {command, [](const std::stop_token&) { return list_library(); }};
}

}  // namespace covaria
