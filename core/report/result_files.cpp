#include "core/report/result_files.h"

#include "core/base/file_io.h"
#include "core/base/file_names.h"

namespace covaria {

namespace {

struct NamedTable {
    std::string file;
    DataTable table;
};

/// Names the tables and lists them.
class TableNaming {
public:
    explicit TableNaming(ResultListing& listing) : listing_(listing) {}

    void add(const std::string& owner, const std::string& stem, DataTable table) {
        const std::string file = names_.unique(file_name_part(stem), ".csv");
        ResultFile listed{file, {}};
        if (!owner.empty()) listed.of.emplace_back("analysis", owner);
        listed.of.emplace_back("table", table.id);
        listing_.files.push_back(std::move(listed));
        tables.push_back({file, std::move(table)});
    }

    std::vector<NamedTable> tables;

private:
    ResultListing& listing_;
    FileNames names_;
};

}  // namespace

Result<void> write_result_files(const std::filesystem::path& folder, const Project& project,
                                const AssetLibrary& assets, const std::vector<EvaluatedAnalysis>& analyses,
                                ResultListing listing) {
    TableNaming naming(listing);
    for (const EvaluatedAnalysis& one : analyses)
        for (DataTable& table : result_tables(project, one)) {
            const std::string stem = one.analysis->id + "-" + table.id;
            naming.add(one.analysis->id, stem, std::move(table));
        }
    for (DataTable& table : asset_tables(assets)) {
        const std::string stem = table.id;
        naming.add("", stem, std::move(table));
    }
    auto written = write_file_atomically(folder / "results.json", results_json(project, analyses, listing));
    for (const NamedTable& named : naming.tables)
        if (written) written = write_file_atomically(folder / named.file, to_csv(named.table));
    return written;
}

}  // namespace covaria
