#include "core/result_files/result_files.h"

#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/made/evaluated_analysis.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/result_files/results_json.h"

namespace covaria {

namespace {

/// Writes each table under a name of its own, lists it and forgets it.
class TableFiles {
public:
    TableFiles(const std::filesystem::path& folder, ResultListing& listing)
        : folder_(folder), listing_(listing) {}

    void add(const std::string& owner, const std::string& stem, const std::string& id,
             const std::string& csv) {
        const std::string file = names_.unique(file_name_part(stem), ".csv");
        ResultFile listed{file, {}};
        if (!owner.empty()) listed.of.emplace_back("analysis", owner);
        listed.of.emplace_back("table", id);
        listing_.files.push_back(std::move(listed));
        if (written) written = write_file_atomically(folder_ / file, csv);
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
        each_result_file(made.project(), one, [&](const std::string& id, const std::string& csv) {
            files.add(one.analysis->id, one.analysis->id + "-" + id, id, csv);
        });
    for (const Table& table : asset_tables(made.assets())) files.add("", table.id, table.id, to_csv(table));
    if (!files.written) return files.written;
    listing.made = &made;
    return write_file_atomically(folder / "results.json", results_json(made.project(), analyses, listing));
}

}  // namespace covaria
