// Check whether results are those that a report carries, to the last bit.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/pdf/pdf_archive.h"

namespace covaria {

/// Statement of a report's results.json about how it was made.
struct CarriedResults {
    std::string version;                ///< version of the program
    std::vector<std::string> analyses;  ///< ids, evaluated or failed
    std::set<std::pair<std::string, std::string>> studies =
        {};  ///< ids of an analysis and of its study, evaluated or failed
};
/// Error: there is no results.json, or it is none.
Result<CarriedResults> carried_results(const std::vector<AttachedFile>& files);

struct Comparison {
    std::vector<std::string> differences;  ///< "analysis a, output x (pose 1), standardUncertainty: 1 is 2"
    std::size_t beyond = 0;                ///< how many more
    bool same() const { return differences.empty() && beyond == 0; }
};
/// Compares results and tables byte by byte; where bytes differ, what they say. The version of the program is
/// left out. `now`: what a report of the same project would carry.
Comparison compare_carried(const std::vector<AttachedFile>& then, const std::vector<AttachedFile>& now);

}  // namespace covaria
