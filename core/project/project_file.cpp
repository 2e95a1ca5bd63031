// Reading and saving project files.
#include "core/project/project_file.h"

#include <algorithm>
#include <set>

#include "core/base/counted_problems.h"
#include "core/base/file_io.h"
#include "core/base/guarded.h"
#include "core/project/analysis_json.h"
#include "core/project/json_location.h"
#include "core/project/kind_lookup.h"
#include "core/project/migration.h"
#include "core/project/project_text.h"
#include "core/project/setup_json.h"
#include "core/project/workspace.h"

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
        return fail(Error{
            ErrorCode::bad_input, "a text here is not valid UTF-8 or has a wrong \\ sequence", {}, {}, line});
    }
}

class ProjectReader {
public:
    ProjectReader(const fs::path& directory, Problems& problems) : context_{directory, problems} {}

    Project read(const Json& document) {
        Project project;
        project.directory = context_.directory;
        ObjectReader reader(document, "", "the project", context_.problems);
        reader.find("format");
        reader.find("schemaVersion");
        project.title = reader.text("title", true);
        project.notes = reader.text("notes");
        read_entries(reader, "assets", project.assets);
        read_entries(reader, "analyses", project.analyses);
        reader.refuse_unknown_keys();
        return project;
    }

    const std::vector<CsvOrigin>& csv() const { return context_.csv; }

private:
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
        ObjectReader reader(value, path, "an asset", context_.problems);
        asset.id = reader.text("id", true);
        asset.kind = reader.text("kind", true);
        asset.name = reader.text("name");
        asset.notes = reader.text("notes");
        read_setup(reader, asset);
        reader.refuse_unknown_keys();
    }

    void read_entry(const Json& value, const std::string& path, AnalysisEntry& analysis) {
        ObjectReader reader(value, path, "an analysis", context_.problems);
        analysis.id = reader.text("id", true);
        analysis.model = reader.text("model", true);
        analysis.name = reader.text("name");
        analysis.notes = reader.text("notes");
        read_setup(reader, analysis);
        read_analysis_details(reader, analysis);
        reader.refuse_unknown_keys();
    }

    // Of an unknown kind nothing is known about its fields; check_project reports the kind.
    template <class Entry>
    void read_setup(ObjectReader& reader, Entry& entry) {
        const Json* setup = reader.find("setup");
        const SetupSchema* schema = schema_of(entry);
        if (setup && schema)
            entry.setup = setup_from_json(*setup, *schema, reader.path_of("setup"), context_);
    }

    ReadContext context_;
};

// Places where something was not readable. What lies at, above or below them is not reported a second time.
class UnreadPlaces {
public:
    explicit UnreadPlaces(const Problems& read) {
        for (const Problem& problem : read.items())
            if (problem.severity == Severity::error && !problem.path.empty()) places_.insert(problem.path);
    }

    bool touch(const std::string& path) const {
        const auto below = places_.lower_bound(path + "/");
        if (places_.contains(path) || (below != places_.end() && below->starts_with(path + "/"))) return true;
        for (std::size_t end = path.rfind('/'); end != std::string::npos && end > 0;
             end = path.rfind('/', end - 1))
            if (places_.contains(path.substr(0, end))) return true;
        return false;
    }

private:
    std::set<std::string> places_;
};

// What was not readable (a field, a cell of it) is not reported a second time as missing.
void add_checks(const Project& project, Problems& problems) {
    Problems checks;
    check_project(project, checks);
    const UnreadPlaces unread(problems);
    for (const Problem& found : checks.items())
        if (!unread.touch(found.path)) problems.add(found);
}

void locate_in_csv(Problem& problem, const std::vector<CsvOrigin>& csv) {
    for (const CsvOrigin& origin : csv) {
        const std::string rows = origin.path + "/rows/";
        if (problem.path.compare(0, rows.size(), rows) != 0) continue;
        const std::size_t row = std::strtoul(problem.path.c_str() + rows.size(), nullptr, 10);
        problem.file = origin.file;
        problem.line = row < origin.lines.size() ? origin.lines[row] : 0;
    }
}

void locate(Problems& problems, const JsonLocations& locations, const std::vector<CsvOrigin>& csv,
            const std::string& name) {
    for (Problem& problem : problems.items()) {
        if (problem.file.empty()) locate_in_csv(problem, csv);
        if (!problem.file.empty()) continue;
        problem.file = name;
        // What is missing in the project itself is missing in the object that begins in the first line.
        if (problem.line == 0) problem.line = std::max(1, locations.line(problem.path));
    }
}

std::string too_large(std::size_t bytes) {
    return "it has " + std::to_string(bytes / 1'000'000) + " MB, and projects of up to " +
           std::to_string(largest_project / 1'000'000) +
           " MB are read: put its long tables into CSV files beside it";
}

Result<Json> project_document(const std::string& text) {
    auto document = parse_json(text);
    if (!document) return document;
    const bool is_project =
        document->is_object() && document->contains("format") && (*document)["format"] == "covaria";
    if (!is_project)
        return fail(ErrorCode::bad_input,
                    "this is not a project of Covaria: it does not begin with \"format\": \"covaria\"",
                    "/format");
    return migrate_project(std::move(*document));
}

}  // namespace

LoadedProject parse_project(const std::string& text, const fs::path& directory, const std::string& name) {
    LoadedProject loaded;
    loaded.project.directory = directory;
    const auto locations = JsonLocations::scan(text);
    if (!locations) {
        add_error(loaded.problems, locations.error());
        Problem& problem = loaded.problems.items().back();
        problem.file = name;
        problem.line = std::max(1, problem.line);
        return loaded;
    }
    loaded.problems = locations->duplicate_keys();
    const auto document = project_document(text);
    if (!document) {
        add_error(loaded.problems, document.error());
        locate(loaded.problems, *locations, {}, name);
        return loaded;
    }
    ProjectReader reader(directory, loaded.problems);
    loaded.project = reader.read(*document);
    add_checks(loaded.project, loaded.problems);
    locate(loaded.problems, *locations, reader.csv(), name);
    count_beyond_a_hundred(loaded.problems);
    return loaded;
}

fs::path project_folder(const fs::path& file) {
    std::error_code failure;
    if (!fs::is_symlink(file, failure)) return file.parent_path();
    const fs::path target = fs::canonical(file, failure);
    return failure ? file.parent_path() : target.parent_path();
}

LoadedProject load_project(const fs::path& file, const std::vector<ValueAt>& values) {
    auto read = guarded([&]() -> Result<LoadedProject> {
        Result<std::string> text = read_file(file);
        if (!text) return fail(text.error());
        if (text->size() > largest_project)
            return fail(Error{ErrorCode::io, too_large(text->size()), {}, {}, 1});
        remove_leftovers(file.parent_path());
        if (values.empty()) return parse_project(*text, project_folder(file), file.string());
        text = with_values(*text, values);
        if (!text) return fail(text.error());
        LoadedProject changed = parse_project(*text, project_folder(file), file.string());
        for (Problem& problem : changed.problems.items())
            if (problem.file == file.string()) problem.line = 0;
        return changed;
    });
    if (read && *read) return std::move(**read);
    LoadedProject loaded;
    Error error = read ? read->error() : read.error();
    error.file = file.string();
    add_error(loaded.problems, error);
    return loaded;
}

Result<void> save_project(const Project& project, const fs::path& file) {
    const WrittenProject written = write_project(project);
    if (!written.complete)
        return fail(
            Error{ErrorCode::bad_input,
                  "the project was not saved: it holds a number that is not finite, or fields that belong to "
                  "no known kind of asset or model",
                  {},
                  file.string(),
                  0});
    if (written.text.size() > largest_project)
        return fail(Error{ErrorCode::bad_input,
                          "the project was not saved: " + too_large(written.text.size()),
                          {},
                          file.string(),
                          0});
    return write_file_atomically(file, written.text);
}

}  // namespace covaria
