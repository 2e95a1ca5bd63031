#include "core/report/result_files.h"

#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/report/result_tables.h"

namespace covaria {

namespace {

/// Writes each table under a name of its own, lists it and forgets it.
class TableFiles {
public:
    TableFiles(const std::filesystem::path& folder, ResultListing& listing)
        : folder_(folder), listing_(listing) {}

    void add(const std::string& owner, const std::string& stem, const DataTable& table) {
        const std::string file = names_.unique(file_name_part(stem), ".csv");
        ResultFile listed{file, {}};
        if (!owner.empty()) listed.of.emplace_back("analysis", owner);
        listed.of.emplace_back("table", table.id);
        listing_.files.push_back(std::move(listed));
        if (written) written = write_file_atomically(folder_ / file, to_csv(table));
    }

    Result<void> written = {};

private:
    const std::filesystem::path& folder_;
    ResultListing& listing_;
    FileNames names_;
};

}  // namespace

Result<void> write_result_files(const std::filesystem::path& folder, const MadeProject& made,
                                const std::vector<EvaluatedAnalysis>& analyses, ResultListing listing) {
    TableFiles files(folder, listing);
    for (const EvaluatedAnalysis& one : analyses)
        each_result_table(made.project(), one, [&](const DataTable& table) {
            files.add(one.analysis->id, one.analysis->id + "-" + table.id, table);
        });
    for (const DataTable& table : asset_tables(made.assets())) files.add("", table.id, table);
    if (!files.written) return files.written;
    return write_file_atomically(folder / "results.json", results_json(made.project(), analyses, listing));
}

}  // namespace covaria
