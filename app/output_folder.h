// Files written by the commands.
#pragma once

#include <filesystem>
#include <string>

#include "core/report/report.h"

namespace covaria {

/// Makes the folder (and its parents). Error{io} in words.
Result<void> make_output_folder(const std::filesystem::path& folder);
/// results.json and the CSV tables of every analysis and asset.
Result<void> write_results(const std::filesystem::path& folder, const Project& project,
                           const AssetLibrary& assets, const std::vector<EvaluatedAnalysis>& analyses);

}  // namespace covaria
