// covaria describe: models and assets with their fields, units and defaults, from the schemas.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/json_output.h"
#include "app/project_parts.h"
#include "app/schema_json.h"
#include "app/schema_text.h"
#include "app/terminal.h"
#include "core/kinds/registries.h"
#include "core/setup/message_text.h"

namespace covaria {
namespace {

void list_everything() {
    std::printf("Measurement models\n");
    for (const ModelDescriptor& model : model_registry())
        std::printf("  %-24s %s\n", model.id.c_str(), model.title.c_str());
    std::printf("\nAssets\n");
    for (const AssetDescriptor& asset : asset_registry())
        std::printf("  %-24s %s\n", asset.kind.c_str(), asset.title.c_str());
    std::printf("\nParts of the project and of every analysis\n");
    for (const ProjectPart& part : project_parts())
        std::printf("  %-24s %s\n", part.name.c_str(), part.title.c_str());
    std::printf("\n\"covaria describe NAME\" shows the fields of one of them.\n");
}

/// Empty: there is no such model, asset or part.
Result<std::string> description(const std::string& name, bool json) {
    if (const ModelDescriptor* model = find_model(name))
        return json ? description_json(*model) : description_of(*model);
    if (const AssetDescriptor* asset = find_asset_kind(name))
        return json ? description_json(*asset) : description_of(*asset);
    const auto part = json ? description_of_part_json(name) : description_of_part(name);
    if (!part) return fail(part.error());
    return part->value_or("");
}

std::string all_names_near(const std::string& name) {
    std::vector<std::string> names;
    for (const ModelDescriptor& model : model_registry()) names.push_back(model.id);
    for (const AssetDescriptor& asset : asset_registry()) names.push_back(asset.kind);
    for (const ProjectPart& part : project_parts()) names.push_back(part.name);
    return did_you_mean(name, names).english();
}

int describe(const std::string& name, bool json) {
    if (name.empty()) {
        if (json)
            std::fputs(list_of_descriptions_json().c_str(), stdout);
        else
            list_everything();
        return exit_success;
    }
    const auto text = description(name, json);
    if (!text) {
        print_error(text.error());
        return exit_bad_input;
    }
    if (!text->empty()) {
        std::fputs(text->c_str(), stdout);
        return exit_success;
    }
    print_message("there is no model, asset or part of an analysis called \"" + name + "\"" +
                  all_names_near(name) + "; \"covaria describe\" lists them");
    return exit_bad_input;
}

struct DescribeArguments {
    std::string name;
    bool json = false;
};

}  // namespace

Command describe_command(CLI::App& app) {
    auto arguments = std::make_shared<DescribeArguments>();
    CLI::App* command = app.add_subcommand(
        "describe", "List models, assets and parts of analyses, or the fields, units and defaults of one");
    add_examples(*command, {{"describe", "all models, assets and parts"},
                            {"describe pose-from-points"},
                            {"describe requirements"},
                            {"describe spherical-instrument --json", "for programs"}});
    command->add_option("NAME", arguments->name,
                        "a model, an asset kind or a part (inputs, options ...); all are listed without it");
    add_json_option(*command, arguments->json);
    return {command,
            [arguments](const std::stop_token&) { return describe(arguments->name, arguments->json); }};
}

}  // namespace covaria
