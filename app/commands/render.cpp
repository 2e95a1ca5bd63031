// covaria render FILE: a picture of an analysis, or its scene as a file.
#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/pictures.h"
#include "app/section_option.h"
#include "app/terminal.h"
#include "core/project/stated_requirements.h"
#include "viz/scene/camera.h"
#include "viz/scene/context_meshes.h"

namespace covaria {
namespace {

struct RenderArguments {
    RunRequest request;
    PictureRequest picture;
    std::string output = "scene.png";
    std::string before;  ///< project to compare with
};

/// A saved view of that name, else a standard one.
Result<void> take_view(const AnalysisEntry& entry, PictureRequest& picture) {
    if (const SavedView* view = find_view(entry.views, picture.view)) {
        picture.saved = *view;
        return {};
    }
    if (standard_view_from(picture.view)) return {};
    std::string names;
    for (const std::string& name : standard_view_names()) names += (names.empty() ? "" : ", ") + name;
    for (const SavedView& view : entry.views) names += ", \"" + view.name + "\"";
    return fail(ErrorCode::bad_input,
                "analysis " + entry.id + " has no view \"" + picture.view + "\"; there are: " + names);
}

Result<void> render(RenderArguments arguments, const std::stop_token& stop) {
    auto opened = open_project(arguments.request.file, arguments.request.values, arguments.request.analyses);
    if (!opened) return fail(opened.error());
    if ((*opened)->project().analyses.empty())
        return fail(ErrorCode::bad_input, "the project has no analysis to draw");
    if (arguments.request.analyses.empty())
        arguments.request.analyses = {(*opened)->project().analyses.front().id};
    const AnalysisEntry* entry = (*opened)->project().find_analysis(arguments.request.analyses.front());
    if (entry) {
        if (auto known = take_view(*entry, arguments.picture); !known) return known;
    }
    arguments.request.studies = !arguments.picture.study.empty();
    arguments.request.study = arguments.picture.study;
    arguments.request.designs = !arguments.picture.design.empty();
    arguments.request.design = arguments.picture.design;
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    if (auto complete = check_complete(*evaluation); !complete) return complete;
    arguments.picture.context = context_meshes(**opened);
    if (entry) arguments.picture.verdicts = judge(*evaluation->analyses.front().result, *entry);
    if (!arguments.before.empty())
        if (auto compared = compare_with(arguments.before, arguments.request, *evaluation, stop); !compared)
            return compared;
    return write_picture(evaluation->analyses.front(), arguments.picture, arguments.output);
}

}  // namespace

Command render_command(CLI::App& app) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command =
        app.add_subcommand("render", "Evaluate an analysis and draw its scene as PNG (needs no display)");
    add_examples(*command,
                 {{"render projects/stewart-platform.covaria --group \"pose 13\" --view top -o top.png"},
                  {"render projects/lsm-network.covaria --trials 2e4 --width 1600 --height 1000 --dark -o "
                   "network.png"},
                  {"render projects/stewart-platform.covaria --section -y=0 --view front -o half.png",
                   "half of it, cut at y = 0"},
                  {"render projects/stewart-platform.covaria --trials 2e4 -o scene.gltf",
                   "the scene itself, for viewers"}});
    add_run_options(*command, arguments->request);
    PictureRequest& picture = arguments->picture;
    command
        ->add_option(
            "--output,-o", arguments->output,
            "file to write: a picture (.png), or the scene itself for viewers (.gltf) or ParaView (.vtp)")
        ->type_name("FILE.png|.gltf|.vtp")
        ->capture_default_str();
    command->add_option("--group", picture.group, "group of outputs to show, e.g. \"pose 7\"")
        ->type_name("NAME");
    command->add_option("--study", picture.study, "the map of the study with this id")->type_name("ID");
    command
        ->add_option("--design", picture.design,
                     "what the design with this id finds: the candidates and the way of the search")
        ->type_name("ID")
        ->excludes("--study");
    command
        ->add_option("--quantity", picture.quantity,
                     "of the study, e.g. \"u(3D), B\" or \"U(x), B\"; the first without it")
        ->type_name("TITLE");
    command
        ->add_option("--before", arguments->before, "project file: its ellipsoids beside these (see compare)")
        ->type_name("FILE")
        ->excludes("--study")
        ->excludes("--design");
    command->add_flag("--ellipsoids", picture.ellipsoids, "ellipsoids at the grid points of the study");
    command
        ->add_option(
            "--view", picture.view,
            "iso, top, front, right, bottom, back, left, or the name of a view saved with the analysis")
        ->type_name("NAME")
        ->capture_default_str();
    add_section_option(*command, picture.section);
    command->add_option("--width", picture.width, "pixels")
        ->check(CLI::Range(64, 16384))
        ->capture_default_str();
    command->add_option("--height", picture.height, "pixels")
        ->check(CLI::Range(64, 16384))
        ->capture_default_str();
    command->add_option("--magnification", picture.magnification, "of the uncertainty; automatic without it")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--probability", picture.probability, "of the ellipsoids; the analysis' own without it")
        ->check(CLI::Range(0.01, 0.9999));
    CLI::Option* orthographic = command->add_flag_callback(
        "--orthographic", [&picture] { picture.perspective = false; },
        "parallel lines stay parallel: the default, but for a view that was saved with perspective");
    command
        ->add_flag_callback(
            "--perspective", [&picture] { picture.perspective = true; }, "what is nearer is larger")
        ->excludes(orthographic);
    command->add_flag("--dark", picture.dark, "dark background");
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = render(*arguments, stop);
                if (done) return int(exit_success);
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
