#include "core/carried/report_data.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/base/own_folder.h"
#include "core/project/certificate_logo.h"
#include "core/project/csv_table.h"
#include "core/project/kind_lookup.h"
#include "core/project/linked_files.h"
#include "core/project/project_file.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "core/result_files/results_json.h"
#include "core/writers/writers.h"

namespace covaria {

namespace {

namespace fs = std::filesystem;

/// Larger results stay outside: a report is to be sent and opened.
constexpr std::size_t largest_results = 50'000'000;
constexpr std::size_t largest_meshes = 50'000'000;  ///< all together

/// The file still says what was read from it.
bool is_as_read(const fs::path& file, const SetupTable& table, const FieldSpec& field) {
    const CsvTable now = table_from_csv_file(file, field, table.csv_columns);
    return !now.problems.has_errors() && now.table.rows == table.rows && now.table.units == table.units;
}

class DataCollection {
public:
    explicit DataCollection(const ReportSource& content) : content_(content) {}

    std::vector<AttachedFile> take() && {
        add_project();
        add_results();
        add_certificate();
        return std::move(files_);
    }

private:
    void add_project() {
        Project project = content_.made.project();
        project.kept.clear();  // not of what is reported, and nothing that its reader was meant to see
        std::vector<AttachedFile> linked;
        for_linked_tables(project, [&](SetupTable& table, const FieldSpec& field) {
            const std::string name = fs::path(table.csv_file).lexically_normal().generic_string();
            const fs::path file = project.directory / name;
            auto bytes = read_file(file);
            if (is_ours(name) || !bytes || is_led_out_of(project.directory, name) ||
                !is_as_read(file, table, field)) {
                table.csv_file.clear();
                table.csv_columns.clear();
            } else if (taken_.insert(name).second) {
                linked.push_back({name, std::move(*bytes), "text/csv",
                                  "Data of the project: it has to lie beside it", AttachedAs::source});
            }
        });
        add_logo(project, linked);
        add_meshes(project, linked);
        files_.push_back({carried::project, project_text(project), "application/json",
                          "The project that this report was made of (open it with Covaria)",
                          AttachedAs::source});
        files_.insert(files_.end(), std::make_move_iterator(linked.begin()),
                      std::make_move_iterator(linked.end()));
    }

    /// Beside the project too; one that lies elsewhere is not carried.
    void add_logo(Project& project, std::vector<AttachedFile>& files) {
        std::string& name = project.certificate.logo;
        auto logo = certificate_logo(project);
        const fs::path path = fs::path(name).lexically_normal();
        const bool beside = logo && !logo->empty() && path.is_relative() && *path.begin() != "..";
        if (!beside || is_ours(path.generic_string())) {
            name.clear();
            return;
        }
        if (taken_.insert(path.generic_string()).second)
            files.push_back({path.generic_string(), std::move(logo->bytes), logo->media_type,
                             "Logo of the certificate", AttachedAs::source});
    }

    /// Adds the meshes that set-ups name beside the project; those too large, or elsewhere, are left out, and
    /// the project says so when it is read.
    void add_meshes(const Project& project, std::vector<AttachedFile>& files) {
        std::size_t bytes_carried = 0;
        for (const AssetEntry& asset : project.assets) {
            const SetupSchema* schema = schema_of(asset);
            if (!schema) continue;
            for (const NamedFile& named : named_files(project, *schema, asset.setup)) {
                const fs::path path = fs::path(named.name).lexically_normal();
                if (path.is_absolute() || *path.begin() == ".." || is_ours(path.generic_string())) continue;
                if (is_led_out_of(project.directory, path)) continue;
                auto bytes = read_file(named.path);
                if (!bytes || bytes_carried + bytes->size() > largest_meshes) continue;
                if (!taken_.insert(path.generic_string()).second) continue;
                bytes_carried += bytes->size();
                files.push_back({path.generic_string(), *std::move(bytes), "model/stl",
                                 "Context of the scene: it influences no number", AttachedAs::source});
            }
        }
    }

    static bool is_ours(const std::string& name) {
        return name == carried::project || name == carried::results || name == carried::certificate;
    }

    void add_results() {
        ResultListing listing{content_.failed, {}, &content_.made};
        std::vector<AttachedFile> budgets;
        for (const EvaluatedAnalysis& one : content_.analyses)
            for (const Table& table : result_tables(content_.made.project(), one)) {
                if (table.id != "budget") continue;
                std::string name = names_.unique(file_name_part(one.analysis->id + "-budget"), ".csv");
                while (taken_.contains(name))
                    name = names_.unique(file_name_part(one.analysis->id + "-budget"), ".csv");
                listing.files.push_back({name, {{"analysis", one.analysis->id}, {"table", table.id}}});
                budgets.push_back({name, to_csv(table), "text/csv",
                                   "Uncertainty budget of analysis " + one.analysis->id, AttachedAs::data});
            }
        std::string results = results_json(content_.made.project(), content_.analyses, listing);
        if (results.size() > largest_results) return;
        files_.push_back({carried::results, std::move(results), "application/json",
                          "All results with every digit", AttachedAs::data});
        for (AttachedFile& budget : budgets)
            if (budget.bytes.size() <= largest_results) files_.push_back(std::move(budget));
    }

    void add_certificate() {
        const Writer& writer = *find_writer("dcc");
        if (writer.missing(content_.made.project()).has_errors()) return;
        // A result that it has no place for is in the other files.
        if (auto written = writer.write({content_.made, content_.analyses}); written)
            files_.push_back({carried::certificate, std::move(written->bytes), "application/xml",
                              writer.title + ", not signed", AttachedAs::alternative});
    }

    const ReportSource& content_;
    std::vector<AttachedFile> files_;
    std::set<std::string> taken_;  ///< names of linked files
    FileNames names_;
};

}  // namespace

std::vector<AttachedFile> report_data(const ReportSource& content) {
    return DataCollection(content).take();
}

}  // namespace covaria
