#include "core/made/evaluated_analysis.h"

namespace covaria {

std::vector<std::string> ids_of(const std::vector<EvaluatedAnalysis>& analyses) {
    std::vector<std::string> ids;
    for (const EvaluatedAnalysis& one : analyses) ids.push_back(one.analysis->id);
    return ids;
}

}  // namespace covaria
