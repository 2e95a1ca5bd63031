// covaria import-urdf FILE -o PROJECT: a robot from URDF as an asset of a new or of an existing project.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/extended_project.h"
#include "app/frozen_joints.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/kinds/robot/urdf.h"
#include "core/project/project_file.h"
#include "core/project/project_id.h"

namespace covaria {
namespace {

struct ImportRequest {
    std::string file, output, tip;
    std::vector<std::string> frozen;  ///< NAME=VALUE
};

Result<void> import_robot(const ImportRequest& request) {
    const auto text = read_file(request.file);
    if (!text) return fail(text.error());
    const auto choice = urdf_choice(request.tip, request.frozen);
    if (!choice) return fail(choice.error());
    auto imported = import_urdf(*text, *choice);
    if (!imported) {
        Error error = imported.error();
        error.file = request.file;
        return fail(std::move(error));
    }
    auto project = project_to_extend(request.output, imported->name);
    if (!project) return fail(project.error());
    const std::string id = free_id(project_id_of(imported->name, "robot"),
                                   [&](const std::string& i) { return project->find_asset(i) != nullptr; });
    project->assets.push_back(
        {id, imported->kind, imported->name, imported->notes, std::move(imported->setup)});
    auto saved = save_project(*project, request.output);
    if (!saved) return saved;
    std::printf("%s: robot \"%s\"\n", request.output.c_str(), project->assets.back().id.c_str());
    for (const Message& line : imported->report) std::printf("  %s\n", line.english().c_str());
    return {};
}

}  // namespace

Command import_urdf_command(CLI::App& app) {
    auto request = std::make_shared<ImportRequest>();
    CLI::App* command = app.add_subcommand("import-urdf", "Make a serial robot from a URDF file");
    add_examples(*command, {{"import-urdf arm.urdf -o arm.covaria"},
                            {"import-urdf arm.urdf -o rest.covaria --freeze shoulder=30",
                             "a joint that the arm does not have, at 30 degrees"}});
    command->add_option("FILE", request->file, "robot description (*.urdf), xacro macros expanded")
        ->required();
    command
        ->add_option("--output,-o", request->output,
                     "project to write; the robot is added to it if it is there already")
        ->type_name("PROJECT")
        ->required();
    add_robot_options(*command, request->tip, request->frozen);
    return {command, [request](const std::stop_token&) -> int {
                const auto done = import_robot(*request);
                if (done) return exit_success;
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
