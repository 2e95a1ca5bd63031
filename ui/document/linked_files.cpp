// Walks all set-ups for tables read from files.
#include "ui/document/linked_files.h"

#include <set>

namespace covaria::ui {

std::vector<std::string> linked_files(const Project& project) {
    std::set<std::string> names;
    const auto collect = [&](const Setup& setup) {
        for (const auto& [key, value] : setup.values)
            if (const auto* table = std::get_if<SetupTable>(&value); table && !table->csv_file.empty())
                names.insert(table->csv_file);
    };
    for (const AssetEntry& asset : project.assets) collect(asset.setup);
    for (const AnalysisEntry& analysis : project.analyses) collect(analysis.setup);
    return {names.begin(), names.end()};
}

Result<void> copy_linked_files(const Project& project, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    for (const std::string& name : linked_files(project)) {
        const fs::path relative(name);
        const fs::path target = folder / relative;
        std::error_code error;
        if (relative.is_absolute() || fs::exists(target, error)) continue;
        fs::create_directories(target.parent_path(), error);
        if (fs::copy_file(project.directory / relative, target, error)) continue;
        return fail(Error{ErrorCode::io,
                          "The data file " + name + " could not be copied to " + folder.string() + ": " +
                              error.message() + ".",
                          {},
                          target.string(),
                          0});
    }
    return {};
}

}  // namespace covaria::ui
