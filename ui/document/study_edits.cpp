#include "ui/document/study_edits.h"

#include <algorithm>

#include "core/project/study_target.h"
#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

std::string free_id(const AnalysisEntry& analysis) {
    for (int number = 1;; ++number) {
        const std::string id = "study-" + std::to_string(number);
        const bool taken = std::any_of(analysis.studies.begin(), analysis.studies.end(),
                                       [&](const Study& study) { return study.id == id; });
        if (!taken) return id;
    }
}

}  // namespace

const Study* find_study(const Project& project, const std::string& analysis, const std::string& study) {
    const AnalysisEntry* entry = project.find_analysis(analysis);
    if (!entry) return nullptr;
    const auto found = std::find_if(entry->studies.begin(), entry->studies.end(),
                                    [&](const Study& candidate) { return candidate.id == study; });
    return found == entry->studies.end() ? nullptr : &*found;
}

std::string add_study(Document& document, const std::string& analysis) {
    const AnalysisEntry* entry = document.project().find_analysis(analysis);
    if (!entry) return {};
    Study study;
    study.id = free_id(*entry);
    study.name = to_std(Document::tr("Study %1").arg(entry->studies.size() + 1));
    const auto choices = study_targets(document.project(), *entry, nullptr);
    if (!choices.empty()) study.axes.push_back(choices.front().axis);
    document.apply(Document::tr("Add study"), [&](Project& project) {
        find_analysis_entry(project, analysis)->studies.push_back(study);
    });
    return study.id;
}

std::string duplicate_study(Document& document, const std::string& analysis, const std::string& id) {
    const Study* original = find_study(document.project(), analysis, id);
    if (!original) return {};
    Study copy = *original;
    copy.id = free_id(*document.project().find_analysis(analysis));
    copy.name += to_std(Document::tr(" (copy)"));
    document.apply(Document::tr("Duplicate study"), [&](Project& project) {
        find_analysis_entry(project, analysis)->studies.push_back(copy);
    });
    return copy.id;
}

void remove_study(Document& document, const std::string& analysis, const std::string& id) {
    document.apply(Document::tr("Delete study"), [&](Project& project) {
        if (AnalysisEntry* entry = find_analysis_entry(project, analysis))
            std::erase_if(entry->studies, [&](const Study& study) { return study.id == id; });
    });
}

void change_study(Document& document, const std::string& analysis, const std::string& id,
                  const std::function<void(Study&)>& edit, const QString& merge_key) {
    const QString key = merge_key.isEmpty()
                            ? QString()
                            : QStringLiteral("study:%1:%2:%3").arg(to_qt(analysis), to_qt(id), merge_key);
    document.apply(
        Document::tr("Change study"),
        [&](Project& project) {
            AnalysisEntry* entry = find_analysis_entry(project, analysis);
            for (std::size_t i = 0; entry && i < entry->studies.size(); ++i)
                if (entry->studies[i].id == id) edit(entry->studies[i]);
        },
        key);
}

}  // namespace covaria::ui
