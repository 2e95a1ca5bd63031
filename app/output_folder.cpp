#include "app/output_folder.h"

#include <system_error>

#include "core/base/file_io.h"

namespace covaria {

Result<void> make_output_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder))
        return fail(ErrorCode::io,
                    "cannot make the folder " + folder.string() + ": " +
                        (failure ? failure.message() : std::string("something else has that name")));
    remove_leftovers(folder);
    return {};
}

EarlierResults::EarlierResults(const std::filesystem::path& folder) : kept_(folder / "results.before.json") {
    std::error_code none;
    std::filesystem::rename(folder / "results.json", kept_, none);
}

void EarlierResults::are_replaced() {
    std::error_code none;
    std::filesystem::remove(kept_, none);
}

}  // namespace covaria
