#include "app/commands/commands.h"

namespace covaria {

std::vector<Command> all_commands(CLI::App& app) {
    return {run_command(app),           check_command(app),   seen_command(app),    design_command(app),
            compare_command(app),       report_command(app),  render_command(app),  validate_command(app),
            describe_command(app),      convert_command(app), library_command(app), verify_command(app),
            verify_report_command(app), export_command(app),  import_command(app),  import_urdf_command(app),
            part_command(app),          merge_command(app),   submit_command(app),  manual_command(app),
            impact_command(app),        release_command(app)};
}

}  // namespace covaria
