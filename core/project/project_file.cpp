// Reading and saving project files.
#include "core/project/project_file.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "core/base/file_io.h"
#include "core/base/in_quotes.h"
#include "core/project/amendment_fields.h"
#include "core/project/analysis_fields.h"
#include "core/project/asset_certificate_fields.h"
#include "core/project/certificate_json.h"
#include "core/project/entry_names.h"
#include "core/project/json_location.h"
#include "core/project/kind_lookup.h"
#include "core/project/migration.h"
#include "core/project/project_results_json.h"
#include "core/project/project_text.h"
#include "core/project/report_contents_fields.h"
#include "core/project/review_fields.h"
#include "core/project/setup_json.h"

namespace covaria {

namespace {

namespace fs = std::filesystem;

void add_error(Problems& problems, const Error& error) {
    problems.add({Severity::error, error.path, error.message, error.file, error.line});
}

// The JSON value of a text that has passed the scanner.
Result<Json> parse_json(const std::string& text) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const int line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
        return fail(Error{ErrorCode::bad_input,
                          tell<"a text here is not valid UTF-8 or has a wrong \\ sequence">(),
                          {},
                          {},
                          line});
    } catch (const Json::out_of_range&) {
        return fail(ErrorCode::bad_input,
                    tell<"a number here is larger than any that can be computed with (1.8e308)">());
    }
}

class ProjectReader {
public:
    ProjectReader(const fs::path& directory, Problems& problems) : context_{directory, problems} {}

    Project read(const Json& document) {
        Project project;
        project.directory = context_.directory;
        ObjectReader reader(document, "", tell<"the project">(), context_.problems);
        reader.find("format");
        reader.find("schemaVersion");
        project.title = reader.text("title", true);
        project.notes = reader.text("notes");
        project.author = reader.text("author");
        project.number = reader.text("number");
        ObjectOf{review_fields()}.read(reader, "review", false, project.review);
        if (const Json* certificate = reader.find("certificate"))
            project.certificate =
                certificate_from_json(*certificate, reader.path_of("certificate"), context_.problems);
        ObjectOf{amendment_fields()}.read(reader, "amendment", false, project.amendment);
        if (const Json* report = reader.find("report"))
            project.report =
                report_contents_fields().read(*report, reader.path_of("report"), context_.problems);
        read_evaluated(reader, project);
        read_kept(reader, project);
        reader.refuse_unknown_keys();
        return project;
    }

    const std::vector<CsvOrigin>& csv() const { return context_.csv; }

private:
    /// Reads the part that a project and a state of it have alike.
    void read_evaluated(ObjectReader& reader, Project& project) {
        if (const Json* results = reader.find("results"))
            project.results =
                project_results_from_json(*results, reader.path_of("results"), context_.problems);
        read_entries(reader, "assets", project.assets);
        read_entries(reader, "analyses", project.analyses);
    }

    void read_kept(ObjectReader& reader, Project& project) {
        const Json* list = reader.list("kept");
        for (std::size_t i = 0; list && i < list->size(); ++i) {
            const std::string path = reader.path_of("kept") + "/" + std::to_string(i);
            ObjectReader of_state((*list)[i], path, tell<"a kept state">(), context_.problems);
            const std::string analysis = of_state.text("analysis", true), at = of_state.text("at", true);
            const std::string other = of_state.text("other", false);
            const std::string other_name = of_state.text("otherName", false);
            Project state;
            state.directory = context_.directory;
            read_evaluated(of_state, state);
            of_state.refuse_unknown_keys();
            if (other.empty() != other_name.empty() || (!other.empty() && !state.find_analysis(other)))
                context_.problems.error(
                    of_state.path_of("other"),
                    tell<"it must be an analysis of the kept state and have a name (otherName)">());
            if (find_kept(project.kept, analysis))
                context_.problems.error(of_state.path_of("analysis"),
                                        tell<"two states of the analysis %1 are kept; one can be">(
                                            in_quotes(shown_name(project, analysis, true))));
            else
                project.kept.push_back(state_of_other(state, other, other_name, analysis, at));
        }
    }

    template <class Entry>
    void read_entries(ObjectReader& reader, const std::string& key, std::vector<Entry>& entries) {
        const Json* list = reader.list(key);
        for (std::size_t i = 0; list && i < list->size(); ++i) {
            Entry entry;
            read_entry((*list)[i], reader.path_of(key) + "/" + std::to_string(i), entry);
            entries.push_back(std::move(entry));
        }
    }

    void read_entry(const Json& value, const std::string& path, AssetEntry& asset) {
        ObjectReader reader(value, path, tell<"an asset">(), context_.problems);
        asset.id = reader.text("id", true);
        asset.kind = reader.text("kind", true);
        asset.name = reader.text("name");
        asset.notes = reader.text("notes");
        read_setup(reader, asset);
        ListOf{asset_certificate_fields()}.read(reader, "certificates", false, asset.certificates);
        reader.refuse_unknown_keys();
    }

    void read_entry(const Json& value, const std::string& path, AnalysisEntry& analysis) {
        ObjectReader reader(value, path, tell<"an analysis">(), context_.problems);
        analysis.id = reader.text("id", true);
        analysis.model = reader.text("model", true);
        analysis.name = reader.text("name");
        analysis.notes = reader.text("notes");
        read_setup(reader, analysis);
        analysis_fields().read_into(reader, analysis);
        reader.refuse_unknown_keys();
    }

    // Reads a set-up. The fields of an unknown kind are not known; making it reports the kind.
    template <class Entry>
    void read_setup(ObjectReader& reader, Entry& entry) {
        const Json* setup = reader.find("setup");
        const SetupSchema* schema = schema_of(entry);
        if (setup && schema)
            entry.setup = setup_from_json(*setup, *schema, reader.path_of("setup"), context_);
    }

    ReadContext context_;
};

void locate_in_csv(Problem& problem, const std::vector<CsvOrigin>& csv) {
    for (const CsvOrigin& origin : csv) {
        const std::string rows = origin.path + "/rows/";
        if (problem.path.compare(0, rows.size(), rows) != 0) continue;
        const std::size_t row = std::strtoul(problem.path.c_str() + rows.size(), nullptr, 10);
        problem.file = origin.file;
        problem.line = row < origin.lines.size() ? origin.lines[row] : 0;
    }
}

/// The places of the values of a text, and its name.
struct Places {
    std::string name;
    std::optional<JsonLocations> locations = {};
    std::vector<CsvOrigin> csv = {};
    MovedEntries moved = {};

    void locate(Problems& problems) const {
        for (Problem& problem : problems.items()) {
            if (problem.file.empty()) locate_in_csv(problem, csv);
            if (!problem.file.empty()) continue;
            problem.file = name;
            // A gap of the project itself is one of the object that begins in the first line.
            if (problem.line == 0)
                problem.line =
                    std::max(1, locations ? locations->line(moved.place_in_file(problem.path)) : 0);
        }
    }
};

Result<MigratedProject> project_document(const std::string& text) {
    auto document = parse_json(text);
    if (!document) return fail(document.error());
    const bool is_project =
        document->is_object() && document->contains("format") && (*document)["format"] == "covaria";
    if (!is_project)
        return fail(
            ErrorCode::bad_input,
            tell<"this is not a project of Covaria: it does not begin with \"format\": \"covaria\"">(),
            "/format");
    return migrate_project(std::move(*document));
}

}  // namespace

Message too_large(std::size_t bytes) {
    return tell<
        "it has %1 MB, and projects of up to %2 MB are read: put its long tables into CSV files beside it">(
        bytes / 1'000'000, largest_project / 1'000'000);
}

ReadProject read_project(const std::string& text, const fs::path& directory, const std::string& name) {
    ReadProject read;
    read.project.directory = directory;
    auto places = std::make_shared<Places>(Places{name});
    read.locate = [places](Problems& problems) { places->locate(problems); };
    auto locations = JsonLocations::scan(text);
    if (!locations) {
        add_error(read.problems, locations.error());
        return read;
    }
    read.problems = locations->duplicate_keys();
    places->locations = std::move(*locations);
    const auto migrated = project_document(text);
    if (!migrated) {
        add_error(read.problems, migrated.error());
        return read;
    }
    places->moved = migrated->moved;
    ProjectReader reader(directory, read.problems);
    read.project = reader.read(migrated->document);
    read.is_project = true;
    places->csv = reader.csv();
    return read;
}

fs::path project_folder(const fs::path& file) {
    std::error_code failure;
    if (!fs::is_symlink(file, failure)) return file.parent_path();
    const fs::path target = fs::canonical(file, failure);
    return failure ? file.parent_path() : target.parent_path();
}

Result<void> save_project(const Project& project, const fs::path& file) {
    const WrittenProject written = write_project(project);
    if (!written.complete)
        return fail(Error{
            ErrorCode::bad_input,
            tell<"the project was not saved: it holds a number that is not finite, or fields that belong to "
                 "no known kind of asset or model">(),
            {},
            file.string(),
            0});
    if (written.text.size() > largest_project)
        return fail(Error{ErrorCode::bad_input,
                          tell<"the project was not saved: %1">(too_large(written.text.size())),
                          {},
                          file.string(),
                          0});
    return write_file_atomically(file, written.text);
}

}  // namespace covaria
