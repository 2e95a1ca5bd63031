// covaria library: the assets that can be copied into projects.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

#include "app/asset_picture.h"
#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/json_output.h"
#include "app/terminal.h"
#include "core/kinds/registries.h"
#include "core/made/library.h"
#include "core/project/setup_json.h"
#include "core/setup/message_text.h"

namespace covaria {
namespace {

int tell_problems(const Library& library) {
    for (const Problem& problem : library.problems.items()) print_message(problem.message.english());
    return library.problems.has_errors() ? exit_bad_input : exit_success;
}

/// Hint for words that match nothing: the nearest of names and kinds: " (did you mean 'leica'?)".
std::string words_meant(const Library& library, const std::string& words) {
    std::vector<std::string> known;
    for (const LibraryItem& item : library.items) {
        std::istringstream texts(item.asset.id + ' ' + item.asset.name + ' ' + item.collection);
        for (std::string word; texts >> word;) known.push_back(word);
        std::string id = item.asset.id;
        std::replace(id.begin(), id.end(), '-', ' ');
        std::istringstream parts(id);
        for (std::string word; parts >> word;) known.push_back(word);
    }
    std::string meant;
    bool is_other = false;
    std::istringstream wanted(words);
    for (std::string word; wanted >> word;) {
        const bool is_known = std::any_of(library.items.begin(), library.items.end(), [&](const auto& item) {
            return has_words(searched_texts(item), word);
        });
        const std::string near = is_known ? word : nearest_name(word, known);
        if (near.empty()) return {};
        is_other = is_other || near != word;
        meant += (meant.empty() ? "" : " ") + near;
    }
    return is_other ? " (did you mean '" + meant + "'?)" : std::string();
}

int list_library(const std::string& words) {
    const Library library = load_library();
    std::string collection;
    bool any = false;
    for (const LibraryItem& item : library.items) {
        if (!has_words(searched_texts(item), words)) continue;
        if (item.collection != collection) std::printf("%s%s\n", any ? "\n" : "", item.collection.c_str());
        collection = item.collection;
        any = true;
        std::printf("  %-24s %s\n", item.asset.id.c_str(), item.asset.name.c_str());
    }
    if (words.empty())
        std::printf(
            "\n\"covaria library show ID\" tells the source of its figures.\n"
            "Own collections are project files in %s\n",
            own_library_folder().c_str());
    else if (!any)
        print_message("nothing in the library has the words \"" + words + "\"" + words_meant(library, words) +
                      "; \"covaria library list\" shows all of it");
    const int status = tell_problems(library);
    return any || words.empty() ? status : exit_bad_input;
}

OrderedJson item_json(const LibraryItem& item) {
    return {{"id", item.asset.id},           {"name", item.asset.name}, {"kind", item.asset.kind},
            {"collection", item.collection}, {"own", item.own},         {"notes", item.asset.notes}};
}

int list_library_json(const std::string& words) {
    const Library library = load_library();
    OrderedJson json = json_document("covaria-library");
    json["items"] = OrderedJson::array();
    for (const LibraryItem& item : library.items)
        if (has_words(searched_texts(item), words)) json["items"].push_back(item_json(item));
    json["problems"] = problems_json(library.problems);
    std::fputs(json_text(json).c_str(), stdout);
    return library.problems.has_errors() || json["items"].empty() ? exit_bad_input : exit_success;
}

/// The item with its set-up, as a project file has it.
std::string shown_json(const LibraryItem& item, const AssetDescriptor& kind) {
    OrderedJson json = json_document("covaria-library");
    json["item"] = item_json(item);
    JsonWriter setup;
    write_setup(setup, item.asset.setup, kind.schema);
    json["item"]["setup"] = OrderedJson::parse(setup.take());
    return json_text(json);
}

void show_texts(const LibraryItem& item, const AssetDescriptor* kind) {
    std::printf("%s (%s%s%s)\n%s\n", item.asset.name.c_str(), item.collection.c_str(), kind ? ": " : "",
                kind ? kind->title.c_str() : "", item.asset.notes.c_str());
}

int show_item(const std::string& id, const std::string& picture, bool json) {
    const Library library = load_library();
    for (const LibraryItem& item : library.items) {
        if (item.asset.id != id) continue;
        const AssetDescriptor* kind = find_asset_kind(item.asset.kind);
        if (json && kind)
            std::fputs(shown_json(item, *kind).c_str(), stdout);
        else
            show_texts(item, kind);
        if (picture.empty()) return exit_success;
        if (const auto written = write_asset_picture(item.asset, picture); !written) {
            print_error(written.error());
            return exit_status_of(written.error());
        }
        return exit_success;
    }
    std::vector<std::string> ids;
    for (const LibraryItem& item : library.items) ids.push_back(item.asset.id);
    print_message("there is nothing with the id \"" + id + "\" in the library" +
                  did_you_mean(id, ids).english() + "; \"covaria library list\" shows the ids");
    tell_problems(library);
    return exit_bad_input;
}

struct LibraryArguments {
    std::vector<std::string> words;
    std::string id, picture;
    bool json = false;
};

std::string joined_words(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

}  // namespace

Command library_command(CLI::App& app) {
    auto arguments = std::make_shared<LibraryArguments>();
    CLI::App* command =
        app.add_subcommand("library", "List and search the instruments and robots of the library");
    add_examples(*command, {{"library"},
                            {"library search leica at960"},
                            {"library show leica-at500"},
                            {"library show leica-at500 --json"}});
    command->require_subcommand(0, 1);
    CLI::App* list = command->add_subcommand("list", "List everything (as without a subcommand)");
    CLI::App* search =
        command->add_subcommand("search", "List what has all the words in name, kind or source");
    search->add_option("WORD", arguments->words, "words, in any order and case")->required();
    CLI::App* show = command->add_subcommand("show", "Show where the figures of one come from");
    show->add_option("ID", arguments->id, "as listed")->required();
    show->add_option("--picture", arguments->picture, "draw its body as well")->type_name("FILE.png");
    for (CLI::App* one : {command, list, search, show}) add_json_option(*one, arguments->json);
    return {command, [arguments, search, show](const std::stop_token&) {
                if (show->parsed()) return show_item(arguments->id, arguments->picture, arguments->json);
                const std::string words = search->parsed() ? joined_words(arguments->words) : std::string();
                return arguments->json ? list_library_json(words) : list_library(words);
            }};
}

}  // namespace covaria
