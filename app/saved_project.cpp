#include "app/saved_project.h"

#include "core/project/linked_files.h"
#include "core/project/project_file.h"

namespace covaria {

Result<void> save_with_tables(Project project, const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    std::error_code failure;
    // A file of the working folder has no folder in its name.
    const auto whole = [&](const fs::path& of) {
        return fs::weakly_canonical(fs::current_path(failure) / of, failure);
    };
    const fs::path folder = whole(file.parent_path() / "."), own = whole(project.directory / ".");
    if (folder != own) unlink_tables(project);
    return save_project(project, file);
}

}  // namespace covaria
