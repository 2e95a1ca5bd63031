#include "core/carried/carried_project.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "core/base/file_io.h"
#include "core/base/guarded.h"
#include "core/base/in_quotes.h"
#include "core/carried/report_data.h"
#include "core/project/linked_files.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

tl::unexpected<Error> refused(const fs::path& report, const Message& message) {
    return fail(Error{ErrorCode::bad_input, message, {}, report.string(), 0});
}

/// A new folder that nobody else may read, removed with what is in it.
class TemporaryFolder {
public:
    static Result<TemporaryFolder> make() {
        std::error_code failure;
        const fs::path base = fs::temp_directory_path(failure);
        std::string name = ((failure ? fs::path("/tmp") : base) / "covaria-report-XXXXXX").string();
        if (!mkdtemp(name.data()))
            return fail(ErrorCode::io, tell<"no folder could be made in %1: %2">(
                                           base.string(), std::system_category().message(errno)));
        return TemporaryFolder(name);
    }
    TemporaryFolder(TemporaryFolder&& other) noexcept : folder(std::exchange(other.folder, {})) {}
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!folder.empty()) fs::remove_all(folder, ignored);
    }
    fs::path folder;

private:
    explicit TemporaryFolder(fs::path made) : folder(std::move(made)) {}
};

/// Within a folder: no root, no way up.
bool stays_within(const std::string& name) {
    const fs::path path(name);
    if (name.empty() || name.find('\0') != std::string::npos || name.find('\\') != std::string::npos ||
        path.is_absolute() || !path.has_filename())
        return false;
    return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

const AttachedFile* find(const std::vector<AttachedFile>& files, const std::string& name) {
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const AttachedFile& file) { return file.name == name; });
    return found == files.end() ? nullptr : &*found;
}

Result<void> take_out(const std::vector<AttachedFile>& files, const fs::path& folder) {
    for (const AttachedFile& file : files)
        if (!stays_within(file.name))
            return fail(ErrorCode::bad_input,
                        tell<"the attached file %1 would leave its folder; nothing was taken out">(
                            in_quotes(plain_name(file.name))));
    for (const AttachedFile& file : files) {
        const fs::path path = folder / fs::path(file.name).lexically_normal();
        std::error_code failure;
        fs::create_directories(path.parent_path(), failure);
        if (failure || fs::is_directory(path, failure))
            return fail(ErrorCode::bad_input,
                        tell<"the attached file %1 cannot be taken out: another one is in its way">(
                            in_quotes(plain_name(file.name))));
        if (auto written = write_file_atomically(path, file.bytes); !written) return written;
    }
    return {};
}

LoadedProject not_loaded(const fs::path& report, const Error& error) {
    LoadedProject loaded;
    loaded.problems.add({Severity::error, error.path, error.message, report.string(), error.line});
    return loaded;
}

}  // namespace

bool is_pdf(std::string_view beginning) {
    return beginning.substr(0, 1024).find("%PDF-") != std::string_view::npos;
}

Result<std::vector<AttachedFile>> carried_files(const fs::path& report) {
    const auto bytes = read_file(report);
    if (!bytes) return fail(bytes.error());
    if (!is_pdf(*bytes)) return refused(report, tell<"it is no PDF">());
    auto files = files_in_pdf(*bytes);
    if (!files) return refused(report, files.error().message);
    if (!find(*files, carried::project))
        return refused(report, tell<"it carries no project: it is no report of Covaria, or one of a version "
                                    "before 0.2.0, or another program has written it anew">());
    return files;
}

LoadedProject load_carried(const fs::path& report, const std::vector<AttachedFile>& files) {
    auto read = guarded([&]() -> Result<LoadedProject> {
        const auto temporary = TemporaryFolder::make();
        if (!temporary) return fail(temporary.error());
        if (auto taken = take_out(files, temporary->folder); !taken) return fail(taken.error());
        const std::string& text = find(files, carried::project)->bytes;
        if (text.size() > largest_project) return fail(ErrorCode::io, too_large(text.size()));
        LoadedProject loaded =
            parse_project(text, temporary->folder, report.string() + ": " + carried::project);
        if (!loaded.made) return loaded;
        unlink_tables(loaded.project);
        loaded.project.directory.clear();
        loaded.made = MadeProject::make(loaded.project, loaded.made);
        return loaded;
    });
    if (read && *read) return std::move(**read);
    return not_loaded(report, read ? read->error() : read.error());
}

LoadedProject load_carried(const fs::path& report) {
    const auto files = carried_files(report);
    return files ? load_carried(report, *files) : not_loaded(report, files.error());
}

}  // namespace covaria
