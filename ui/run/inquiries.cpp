#include "ui/run/inquiries.h"

#include <algorithm>

#include "core/project/project_file.h"

namespace covaria::ui {

namespace {

template <class Item>
std::vector<std::string> ids_of(const std::vector<Item>& items) {
    std::vector<std::string> ids;
    for (const Item& item : items) ids.push_back(item.id);
    return ids;
}

template <class Item>
const Item& item_of(const std::vector<Item>& items, const std::string& id) {
    return *std::ranges::find(items, id, &Item::id);
}

/// Run of one sort of inquiry with these two functions of the core.
template <class Prepare, class Run>
auto prepared_and_run(Prepare prepare, Run run, const char* otherwise) {
    return [=](const MadeProject::Pointer& made, const RunKey& key,
               const RunControl& control) -> InquiryKind::Outcome {
        if (control.stop.stop_requested()) return fail(ErrorCode::cancelled, {});
        Problems problems;
        const auto prepared = prepare(made, key.analysis, key.inquiry, problems);
        if (!prepared) return fail(ErrorCode::bad_input, first_error(problems, otherwise));
        auto result = run(*prepared, control);
        if (!result) return fail(result.error());
        using Outcome = typename decltype(result)::value_type;
        return std::make_shared<const Outcome>(*std::move(result));
    };
}

}  // namespace

InquiryKind study_inquiries() {
    return {[](const AnalysisEntry& analysis) { return ids_of(analysis.studies); },
            [](const AnalysisEntry& analysis, const std::string& id) {
                return item_of(analysis.studies, id).name;
            },
            [](const Project& project, const AnalysisEntry& analysis, const std::string& id) {
                return study_part(project, analysis, item_of(analysis.studies, id));
            },
            [](const Project& a, const Project& b) { return same_numbers(a, b); },
            prepared_and_run(prepare_study, run_study, "the study cannot be prepared")};
}

InquiryKind design_inquiries() {
    return {[](const AnalysisEntry& analysis) { return ids_of(analysis.designs); },
            [](const AnalysisEntry& analysis, const std::string& id) {
                return item_of(analysis.designs, id).name;
            },
            [](const Project& project, const AnalysisEntry& analysis, const std::string& id) {
                return design_part(project, analysis, item_of(analysis.designs, id));
            },
            [](const Project& a, const Project& b) { return same_search(a, b); },
            prepared_and_run(prepare_design, run_design, "the design cannot be prepared")};
}

}  // namespace covaria::ui
