// covaria import-urdf FILE -o PROJECT: a robot from URDF as an asset of a new or of an existing project.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <sstream>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/extended_project.h"
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

Result<UrdfChoice> choice_of(const ImportRequest& request) {
    UrdfChoice choice{.tip = request.tip, .frozen = {}};
    for (const std::string& text : request.frozen) {
        const std::size_t sign = text.rfind('=');
        FrozenJoint joint;
        std::istringstream value(sign == std::string::npos ? std::string() : text.substr(sign + 1));
        if (sign == 0 || !(value >> joint.value) || !(value >> std::ws).eof())
            return fail(ErrorCode::bad_input, "--freeze " + text +
                                                  ": write NAME=VALUE, in degrees for a joint that turns, in "
                                                  "millimetres for one that slides");
        joint.name = text.substr(0, sign);
        choice.frozen.push_back(std::move(joint));
    }
    return choice;
}

Result<void> import_robot(const ImportRequest& request) {
    const auto text = read_file(request.file);
    if (!text) return fail(text.error());
    const auto choice = choice_of(request);
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
    command->add_option("FILE", request->file, "robot description (*.urdf), xacro macros expanded")
        ->required();
    command
        ->add_option("--output,-o", request->output,
                     "project to write; the robot is added to it if it is there already")
        ->type_name("PROJECT")
        ->required();
    command->add_option("--tip", request->tip, "link at the end of the arm; found without it")
        ->type_name("LINK");
    command
        ->add_option("--freeze", request->frozen,
                     "joint that the arm does not have, at a value in degrees or millimetres: a rail, a "
                     "turntable; repeat for more")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    return {command, [request](const std::stop_token&) -> int {
                const auto done = import_robot(*request);
                if (done) return exit_success;
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
