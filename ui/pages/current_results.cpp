#include "ui/pages/current_results.h"

#include "ui/theme/strings.h"

namespace covaria::ui {

std::vector<EvaluatedAnalysis> current_results(const Project& project, const AnalysisRunner& runner) {
    std::vector<EvaluatedAnalysis> current;
    for (const AnalysisEntry& analysis : project.analyses) {
        const AnalysisStatus& status = runner.status(to_qt(analysis.id));
        if (!status.is_current()) continue;
        current.push_back({status.result_of, status.result, status.warnings});
        for (const Study& study : analysis.studies) {
            const StudyStatus& of_study = runner.studies().status(to_qt(analysis.id), to_qt(study.id));
            if (of_study.is_current()) current.back().studies.push_back(of_study.result);
        }
    }
    return current;
}

QStringList left_out(const Project& project, const AnalysisRunner& runner) {
    QStringList names;
    for (const AnalysisEntry& analysis : project.analyses)
        if (!runner.status(to_qt(analysis.id)).is_current()) names << to_qt(analysis.name);
    return names;
}

}  // namespace covaria::ui
