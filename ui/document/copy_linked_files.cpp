#include "ui/document/copy_linked_files.h"

#include "core/base/own_folder.h"
#include "core/project/linked_files.h"

namespace covaria::ui {

Result<void> copy_linked_files(const Project& project, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    for (const std::string& name : linked_files(project)) {
        const fs::path relative(name);
        const fs::path target = folder / relative;
        std::error_code error;
        if (relative.is_absolute() || is_led_out_of(project.directory, relative) || fs::exists(target, error))
            continue;
        fs::create_directories(target.parent_path(), error);
        if (fs::copy_file(project.directory / relative, target, error)) continue;
        return fail(Error{ErrorCode::io,
                          "The data file " + name + " could not be copied to " + folder.string() + ": " +
                              error.message() + ".",
                          {},
                          target.string(),
                          0});
    }
    for (const fs::path name : context_files(project)) {
        std::error_code error;  // ignored: a missing file is warned of where it is used
        if (!name.is_relative() || is_led_out_of(project.directory, name)) continue;
        fs::create_directories((folder / name).parent_path(), error);
        fs::copy_file(project.directory / name, folder / name, fs::copy_options::skip_existing, error);
    }
    return {};
}

}  // namespace covaria::ui
