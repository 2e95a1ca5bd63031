#include "core/made/load_project.h"

#include <set>

#include "core/base/counted_problems.h"
#include "core/base/file_io.h"
#include "core/base/guarded.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

// Places of what was not readable. Problems at, above or below them are not reported a second time.
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

// Adds the problems of checks; a field or cell that was not readable is not reported as missing too.
void add_checks(const MadeProject& made, Problems& problems) {
    const UnreadPlaces unread(problems);
    const Problems checks = made.problems();
    for (const Problem& found : checks.items())
        if (!unread.touch(found.path)) problems.add(found);
}

}  // namespace

LoadedProject parse_project(const std::string& text, const fs::path& directory, const std::string& name) {
    ReadProject read = read_project(text, directory, name);
    const bool is_whole = read.is_project && !read.problems.has_errors();
    LoadedProject loaded{std::move(read.project), std::move(read.problems), nullptr, is_whole};
    if (read.is_project) {
        loaded.made = MadeProject::make(loaded.project);
        add_checks(*loaded.made, loaded.problems);
    }
    read.locate(loaded.problems);
    count_beyond_a_hundred(loaded.problems);
    return loaded;
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
    const Error error = read ? read->error() : read.error();
    loaded.problems.add({Severity::error, error.path, error.message, file.string(), error.line});
    return loaded;
}

}  // namespace covaria
