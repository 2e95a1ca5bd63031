#include "ui/pages/current_results.h"

#include "core/result/comparison.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

Message words_of_kept(const AnalysisRunner& runner, const std::string& analysis) {
    const KeptResult* kept = runner.kept().find(to_qt(analysis));
    return kept && !kept->state.other.empty() ? Message(kept->state.other_name) : tell<"kept results">();
}

}  // namespace

std::vector<EvaluatedAnalysis> current_results(const Project& project, const AnalysisRunner& runner) {
    std::vector<EvaluatedAnalysis> current;
    for (const AnalysisEntry& analysis : project.analyses) {
        const AnalysisStatus& status = runner.status(to_qt(analysis.id));
        if (!status.is_current()) continue;
        current.push_back({status.result_of, status.result, status.warnings});
        if (const ResultPointer before = runner.kept().before(to_qt(analysis.id), status.result))
            current.back().before = std::make_shared<const ResultsBefore>(
                ResultsBefore{words_of_kept(runner, analysis.id), compare_results(before, status.result)});
        for (const Study& study : analysis.studies) {
            const StudyStatus of_study = runner.studies().status(to_qt(analysis.id), to_qt(study.id));
            if (of_study.is_current()) current.back().studies.push_back(of_study.result);
        }
        for (const Design& design : analysis.designs) {
            const DesignStatus of_design = runner.designs().status(to_qt(analysis.id), to_qt(design.id));
            if (of_design.is_current()) current.back().designs.push_back(of_design.result);
        }
    }
    return current;
}

std::vector<FailedAnalysis> failed_results(const Project& project, const AnalysisRunner& runner) {
    std::vector<FailedAnalysis> failed;
    for (const AnalysisEntry& analysis : project.analyses) {
        const AnalysisStatus& status = runner.status(to_qt(analysis.id));
        if (status.state == RunState::failed)
            failed.push_back({analysis.id, analysis.name, {}, to_std(status.message)});
        for (const Study& study : analysis.studies) {
            const StudyStatus of_study = runner.studies().status(to_qt(analysis.id), to_qt(study.id));
            if (of_study.state == RunState::failed)
                failed.push_back({analysis.id, analysis.name, study.id, to_std(of_study.message)});
        }
        for (const Design& design : analysis.designs) {
            const DesignStatus of_design = runner.designs().status(to_qt(analysis.id), to_qt(design.id));
            if (of_design.state == RunState::failed)
                failed.push_back({analysis.id, analysis.name, design.id, to_std(of_design.message)});
        }
    }
    return failed;
}

ReportMaker::Source document_source(DocumentKind kind, const Project& project, const AnalysisRunner& runner) {
    ReportMaker::Source source{kind, runner.made(), current_results(project, runner), {}};
    for (FailedAnalysis& failed : failed_results(project, runner))
        if (project.report.has_analysis(failed.id)) source.failed.push_back(std::move(failed));
    if (kind != DocumentKind::certificate) return source;
    for (const AnalysisEntry& analysis : project.analyses) {
        const AnalysisStatus& status = runner.status(to_qt(analysis.id));
        if (project.report.has_analysis(analysis.id) && !status.is_current() &&
            status.state != RunState::failed)
            source.failed.push_back({analysis.id, analysis.name, {}, "not up to date"});
    }
    return source;
}

QStringList left_out(const Project& project, const std::vector<std::string>& analyses,
                     const AnalysisRunner& runner) {
    QStringList names;
    for (const std::string& id : analyses)
        if (!runner.status(to_qt(id)).is_current()) names << to_qt(project.find_analysis(id)->name);
    return names;
}

}  // namespace covaria::ui
