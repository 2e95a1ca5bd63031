#include "core/project/report_contents.h"

#include <algorithm>

#include "core/base/in_quotes.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& key) {
    return std::find(list.begin(), list.end(), key) != list.end();
}

}  // namespace

const std::vector<ReportChapterField>& report_chapters() {
    using enum ReportChapter;
    static const std::vector<ReportChapterField> chapters{
        {models, "models", "Measurement model"},
        {setup, "setup", "Set-up"},
        {inputs, "inputs", "Input quantities"},
        {assets, "assets", "Artefacts and instruments"},
        {budgets, "budgets", "Uncertainty budgets"},
        {influence, "influence", "Sobol indices and contributors"},
        {evaluation, "evaluation", "Evaluation of the set-up"},
        {comparison, "comparison", "Law of propagation beside Monte Carlo"},
        {before, "before", "Results before and after"},
        {regions, "regions", "Joint coverage regions"},
        {distributions, "distributions", "Distributions"},
        {scene, "scene", "Set-up in space"},
        {correlation, "correlation", "Correlation"},
        {studies, "studies", "Studies"},
        {designs, "designs", "Designs"},
        {notes, "notes", "Notes"},
        {provenance, "provenance", "Provenance"}};
    return chapters;
}

bool ReportContents::has_analysis(const std::string& id) const {
    return !contains(without_analyses, id);
}

bool ReportContents::has(ReportChapter chapter) const {
    const auto& all = report_chapters();
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const ReportChapterField& field) { return field.chapter == chapter; });
    return !contains(without_chapters, found->key);
}

void choose(std::vector<std::string>& without, const std::string& key, bool on) {
    std::erase(without, key);
    if (!on) without.push_back(key);
}

void check_report_contents(const ReportContents& contents, const std::vector<std::string>& analyses,
                           Problems& problems) {
    std::vector<std::string> keys;
    for (const ReportChapterField& chapter : report_chapters()) keys.push_back(chapter.key);
    for (std::size_t i = 0; i < contents.without_chapters.size(); ++i)
        if (const std::string& key = contents.without_chapters[i]; !contains(keys, key))
            problems.error("/report/withoutChapters/" + std::to_string(i),
                           tell<"a report has no chapter %1%2">(in_quotes(key), did_you_mean(key, keys)));
    for (std::size_t i = 0; i < contents.without_analyses.size(); ++i)
        if (const std::string& id = contents.without_analyses[i]; !contains(analyses, id))
            problems.warning("/report/withoutAnalyses/" + std::to_string(i),
                             tell<"there is no analysis %1%2">(in_quotes(id), did_you_mean(id, analyses)));
}

}  // namespace covaria
