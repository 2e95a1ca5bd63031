// The folder that a command writes to.
#pragma once

#include <filesystem>

#include "core/base/error.h"

namespace covaria {

/// Makes the folder (and its parents); removes what a killed run has left unfinished in it. Error{io} in
/// words.
Result<void> make_output_folder(const std::filesystem::path& folder);

/// results.json of an earlier run, out of the way while a run is going on: what it leaves when it fails, or
/// is killed, must not look like its own. It goes when the run has written its results, and stays as
/// results.before.json else.
class EarlierResults {
public:
    explicit EarlierResults(const std::filesystem::path& folder);
    void are_replaced();

private:
    std::filesystem::path kept_;
};

}  // namespace covaria
