#include "app/output_folder.h"

#include <system_error>

#include "core/project/project_file.h"

namespace covaria {

Result<void> make_output_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder))
        return fail(ErrorCode::io,
                    "cannot make the folder " + folder.string() + ": " +
                        (failure ? failure.message() : std::string("something else has that name")));
    return {};
}

namespace {

Result<void> write_tables(const std::filesystem::path& folder, const std::string& prefix,
                          const std::vector<DataTable>& tables) {
    for (const DataTable& table : tables)
        if (auto written = write_file_atomically(folder / (prefix + table.id + ".csv"), to_csv(table));
            !written)
            return written;
    return {};
}

}  // namespace

Result<void> write_results(const std::filesystem::path& folder, const Project& project,
                           const AssetLibrary& assets, const std::vector<EvaluatedAnalysis>& analyses) {
    if (auto made = make_output_folder(folder); !made) return made;
    if (auto written = write_file_atomically(folder / "results.json", results_json(project, analyses));
        !written)
        return written;
    for (const EvaluatedAnalysis& evaluated : analyses)
        if (auto written =
                write_tables(folder, evaluated.analysis->id + "-", result_tables(project, evaluated));
            !written)
            return written;
    return write_tables(folder, "", asset_tables(assets));
}

}  // namespace covaria
