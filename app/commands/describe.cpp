// covaria describe: models and assets with their fields, units and defaults, from the schemas.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/project_parts.h"
#include "app/schema_text.h"
#include "app/terminal.h"
#include "core/kinds/registries.h"

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

int describe(const std::string& name) {
    if (name.empty()) {
        list_everything();
        return exit_success;
    }
    if (const ModelDescriptor* model = find_model(name)) {
        std::fputs(description_of(*model).c_str(), stdout);
        return exit_success;
    }
    if (const AssetDescriptor* asset = find_asset_kind(name)) {
        std::fputs(description_of(*asset).c_str(), stdout);
        return exit_success;
    }
    const auto part = description_of_part(name);
    if (!part) {
        print_message(part.error().message.english());
        return exit_bad_input;
    }
    if (*part) {
        std::fputs((*part)->c_str(), stdout);
        return exit_success;
    }
    print_message("there is no model, asset or part of an analysis called \"" + name +
                  "\"; \"covaria describe\" lists them");
    return exit_bad_input;
}

}  // namespace

Command describe_command(CLI::App& app) {
    auto name = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(
        "describe", "List models, assets and parts of analyses, or the fields, units and defaults of one");
    command->add_option("NAME", *name,
                        "a model, an asset kind or a part (inputs, options ...); all are listed without it");
    return {command, [name](const std::stop_token&) { return describe(*name); }};
}

}  // namespace covaria
