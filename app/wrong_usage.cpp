#include "app/wrong_usage.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/in_quotes.h"
#include "core/setup/message_text.h"

namespace covaria {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

const CLI::App* find_command(const CLI::App& app, const std::string& name) {
    for (const CLI::App* command : commands_of(app))
        if (command->get_name() == name) return command;
    return nullptr;
}

std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

bool is_among(const std::string& name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// "--trials=5" and "-ofile" without what follows the name; empty: no option ("-5", "file").
std::string option_name(const std::string& word) {
    if (word.size() < 2 || word[0] != '-') return {};
    if (word[1] == '-') return word.size() > 2 ? word.substr(0, word.find('=')) : std::string();
    const bool letter = (word[1] >= 'a' && word[1] <= 'z') || (word[1] >= 'A' && word[1] <= 'Z');
    return letter ? word.substr(0, 2) : std::string();
}

/// The name that was meant: with two neighbours exchanged ("--sa", "--as"), the only longer one ("--cert",
/// "--certificate"), else the nearest in letters. A single letter gives no guess.
std::string guess(const std::string& name, const std::vector<std::string>& names) {
    if (name.find_first_not_of('-') + 1 >= name.size()) return {};
    for (std::size_t i = 1; i < name.size(); ++i) {
        std::string exchanged = name;
        std::swap(exchanged[i - 1], exchanged[i]);
        if (is_among(exchanged, names)) return exchanged;
    }
    const auto longer = [&](const std::string& other) { return other.starts_with(name); };
    if (name.size() > 3 && std::count_if(names.begin(), names.end(), longer) == 1)
        return *std::find_if(names.begin(), names.end(), longer);
    return nearest_name(name, names);
}

std::string with_guess(const std::string& sentence, const std::string& meant) {
    return meant.empty() ? sentence : sentence + " (did you mean '" + meant + "'?)";
}

std::vector<std::string> commands_with(const std::string& name, const CLI::App& app) {
    std::vector<std::string> having;
    for (const CLI::App* command : commands_of(app))
        if (is_among(name, options_of(*command))) having.push_back(command->get_name());
    if (is_among(name, options_of(app))) having.push_back(app.get_name());
    return having;
}

/// "; it is an option of 'report' and 'compare'": of a name that other commands know, or one like it.
std::string where_it_is(const std::string& name, const CLI::App& app) {
    if (const auto having = commands_with(name, app); !having.empty())
        return "; it is an option of " + listed(having);
    constexpr std::size_t telling = 6;  // shorter names are near others by chance
    std::vector<std::string> all = options_of(app);
    for (const CLI::App* command : commands_of(app))
        for (const std::string& option : options_of(*command)) all.push_back(option);
    const std::string meant = name.size() < telling ? std::string() : guess(name, all);
    if (meant.empty()) return {};
    return "; " + in_quotes(meant) + " is an option of " + listed(commands_with(meant, app));
}

std::string no_option(const std::string& word, const std::string& name, const CLI::App& app,
                      const CLI::App& command, const std::string& called) {
    // The words of "-otput" are one option with a value for the parser, and none for people.
    const std::string typed = name.size() == 2 ? word : name;
    const std::string sentence = called + " has no option " + in_quotes(typed);
    const std::string meant = guess(name.size() == 2 ? "-" + word : name, options_of(command));
    return with_guess(sentence, meant) + (meant.empty() ? where_it_is(name, app) : "") + "\n\"" + called +
           " --help\" lists its options.";
}

std::string no_command(const std::string& word, const CLI::App& command, const std::string& called) {
    std::vector<std::string> names;
    for (const CLI::App* one : commands_of(command)) names.push_back(one->get_name());
    const std::string meant = guess(word, names);
    return with_guess(called + " has no command " + in_quotes(word), meant) + "\n\"" + called +
           " --help\" lists its commands.";
}

/// A word that is written like a file stands for one, which may be missing.
bool is_like_a_file(const std::string& word) {
    std::error_code ignored;
    return word.find_first_of("./") != std::string::npos || std::filesystem::exists(word, ignored);
}

}  // namespace

std::string what_does_not_exist(const CLI::App& app, int argc, char** argv) {
    const CLI::App* command = &app;
    std::string called = app.get_name();
    bool may_be_command = true;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--") break;
        if (const std::string name = option_name(word); !name.empty()) {
            if (!is_among(name, options_of(*command))) return no_option(word, name, app, *command, called);
            // The next word may be its value.
            if (command == &app) may_be_command = false;
            continue;
        }
        const CLI::App* inner = find_command(*command, word);
        if (inner) {
            command = inner;
            called += " " + word;
            continue;
        }
        const bool takes_commands = !commands_of(*command).empty();
        if (may_be_command && takes_commands && !is_like_a_file(word))
            return no_command(word, *command, called);
        may_be_command = false;
    }
    return {};
}

}  // namespace covaria
