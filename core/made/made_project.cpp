// The parts of a made project put together.
#include "core/made/made_project.h"

#include <algorithm>
#include <set>

#include "core/base/in_quotes.h"
#include "core/made/applicability.h"
#include "core/made/certificate_gaps.h"
#include "core/made/project_making.h"
#include "core/project/certificate_logo.h"
#include "core/project/links.h"
#include "core/project/project_id.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

template <class Entry>
void check_ids(const std::vector<Entry>& entries, const std::string& place, Problems& problems) {
    std::set<std::string> known;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string path = place + "/" + std::to_string(i) + "/id";
        const std::string& id = entries[i].id;
        if (!is_project_id(id))
            problems.error(path, tell<"its id must be made of letters, digits, '-' and '_'">());
        else if (!known.insert(id).second)
            problems.error(path, tell<"another one has the same id">());
    }
}

bool is_of_long_chain(const Problem& problem) {
    return problem.message == chain_too_long();
}

}  // namespace

MadeProject::Pointer MadeProject::make(std::shared_ptr<const Project> project, const Pointer& before) {
    return ProjectMaking(std::move(project), before.get()).make();
}

MadeProject::Pointer MadeProject::make(Project project, const Pointer& before) {
    return make(std::make_shared<const Project>(std::move(project)), before);
}

const MadeAnalysis* MadeProject::find_analysis(const std::string& id) const {
    const AnalysisEntry* entry = project_->find_analysis(id);
    return entry ? &made_analysis(static_cast<std::size_t>(entry - project_->analyses.data())) : nullptr;
}

std::shared_ptr<const PreparedAnalysis> MadeProject::analysis(const std::string& id) const {
    const MadeAnalysis* made = find_analysis(id);
    return made ? made->prepared : nullptr;
}

std::vector<std::string> MadeProject::assets_used_by(const std::string& analysis) const {
    std::vector<std::string> ids;
    const AnalysisEntry* entry = project_->find_analysis(analysis);
    if (!entry) return ids;
    const auto index = static_cast<std::size_t>(entry - project_->analyses.data());
    for (const std::size_t used : graph_.used_by(graph_.number_of_analysis(index)))
        if (graph_.is_asset(used)) ids.push_back(project_->assets[used].id);
    return ids;
}

Problems MadeProject::problems() const {
    Problems all;
    check_ids(project_->assets, "/assets", all);
    check_ids(project_->analyses, "/analyses", all);
    check_review(project_->review, all);
    check_certificate(project_->certificate, all);
    check_certificate_logo(*project_, all);
    check_accredited_probability(*project_, all);
    std::vector<std::string> analyses;
    for (const AnalysisEntry& analysis : project_->analyses) analyses.push_back(analysis.id);
    check_report_contents(project_->report, analyses, all);
    for (const std::size_t entry : graph_.order())  // causes before what follows from them
        if (graph_.is_asset(entry)) all.take(entries_[entry]->problems, "/assets/" + std::to_string(entry));
    bool said_too_long = false;
    for (std::size_t i = 0; i < project_->analyses.size(); ++i) {
        const std::string place = "/analyses/" + std::to_string(i);
        Problems own = made_analysis(i).problems;
        if (said_too_long)  // once: every further analysis of the chain has the same to say
            std::erase_if(own.items(), is_of_long_chain);
        said_too_long = said_too_long || std::ranges::any_of(own.items(), is_of_long_chain);
        all.take(own, place);
        all.take(made_analysis(i).of_studies, place);
    }
    check_figures(*this, all);
    return all;
}

Problems MadeProject::problems_of_analysis(const std::string& id) const {
    Problems found;
    if (const AnalysisEntry* entry = project_->find_analysis(id)) {
        const auto index = static_cast<std::size_t>(entry - project_->analyses.data());
        found.take(made_analysis(index).problems, "/analyses/" + std::to_string(index));
        return found;
    }
    std::vector<std::string> ids;
    for (const AnalysisEntry& analysis : project_->analyses) ids.push_back(analysis.id);
    found.error("", tell<"there is no analysis %1%2">(in_quotes(id), did_you_mean(id, ids)));
    return found;
}

std::vector<Message> MadeProject::warnings_of(const std::string& analysis) const {
    std::vector<Message> warnings;
    const AnalysisEntry* entry = project_->find_analysis(analysis);
    if (!entry) return warnings;
    const auto add = [&](const Problems& problems, const AssetEntry* asset) {
        for (const Problem& problem : problems.items())
            if (problem.severity == Severity::warning)
                warnings.push_back(
                    asset ? tell<"asset %1: %2">(in_quotes(asset->name.empty() ? asset->id : asset->name),
                                                 problem.message)
                          : problem.message);
    };
    const auto index = static_cast<std::size_t>(entry - project_->analyses.data());
    for (const std::size_t used : graph_.used_by(graph_.number_of_analysis(index)))
        if (graph_.is_asset(used)) add(entries_[used]->problems, &project_->assets[used]);
    add(made_analysis(index).problems, nullptr);
    for (const CertificateUse& use : figures_used(*this, analysis).certificates)
        if (is_refused(use.verdict.verdict))
            warnings.push_back(tell<"%1: %2">(in_quotes(use.holder), sentence_of(use)));
    return warnings;
}

Message first_error(const Problems& problems, const Message& otherwise) {
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error) return problem.message;
    return otherwise;
}

}  // namespace covaria
