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

}  // namespace covaria
