#include "core/readers/neighbours.h"

#include <algorithm>

#include "core/base/file_io.h"
#include "core/base/in_quotes.h"
#include "core/base/own_folder.h"
#include "core/readers/entry_texts.h"
#include "core/readers/text_encoding.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

Result<std::string> read_beside(const fs::path& folder, const std::string& name) {
    const fs::path relative = fs::path(name).lexically_normal();
    if (name.empty() || name.find('\0') != std::string::npos || relative.is_absolute() ||
        *relative.begin() == "..")
        return fail(ErrorCode::bad_input,
                    tell<"the file %1 must be named relative to the folder of the file that names it, and "
                         "lie in it">(in_quotes(plain_name(name))));
    if (is_led_out_of(folder, relative))
        return fail(ErrorCode::bad_input,
                    tell<"the file %1 is a link that leads out of its folder: put the file itself there">(
                        in_quotes(plain_name(name))));
    auto text = read_file(folder / relative);
    if (!text) return text;
    return text_for_readers(std::move(*text));
}

}  // namespace

Neighbours neighbours_of(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    Neighbours beside;
    beside.read = [folder](const std::string& name) { return read_beside(folder, name); };
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) beside.names.push_back(entry->path().filename().string());
        if (beside.names.size() == Neighbours::most_names) break;
    }
    std::ranges::sort(beside.names);
    return beside;
}

}  // namespace covaria
