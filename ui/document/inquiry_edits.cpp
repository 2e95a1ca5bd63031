#include "ui/document/inquiry_edits.h"

#include <algorithm>
#include <numbers>

#include "core/kinds/registries.h"
#include "core/project/study_target.h"
#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

template <class Item>
const Item* InquiryList<Item>::find(const Project& project, const std::string& analysis,
                                    const std::string& id) const {
    const AnalysisEntry* entry = project.find_analysis(analysis);
    if (!entry) return nullptr;
    const auto found = std::ranges::find(of(*entry), id, &Item::id);
    return found == of(*entry).end() ? nullptr : &*found;
}

template <class Item>
std::string InquiryList<Item>::free_id(const AnalysisEntry& analysis) const {
    for (int number = 1;; ++number) {
        const std::string id = to_std(words_().id) + "-" + std::to_string(number);
        if (std::ranges::count(of(analysis), id, &Item::id) == 0) return id;
    }
}

template <class Item>
std::string InquiryList<Item>::add(Document& document, const std::string& analysis, Item item) const {
    const AnalysisEntry* entry = document.project().find_analysis(analysis);
    if (!entry) return {};
    item.id = free_id(*entry);
    item.name = to_std(words_().name.arg(of(*entry).size() + 1));
    document.apply(words_().add, [&](Project& project) {
        (find_analysis_entry(project, analysis)->*list_).push_back(item);
    });
    return item.id;
}

template <class Item>
std::string InquiryList<Item>::duplicate(Document& document, const std::string& analysis,
                                         const std::string& id) const {
    const Item* original = find(document.project(), analysis, id);
    if (!original) return {};
    Item copy = *original;
    copy.id = free_id(*document.project().find_analysis(analysis));
    copy.name += to_std(Document::tr(" (copy)"));
    document.apply(words_().duplicate, [&](Project& project) {
        (find_analysis_entry(project, analysis)->*list_).push_back(copy);
    });
    return copy.id;
}

template <class Item>
void InquiryList<Item>::remove(Document& document, const std::string& analysis, const std::string& id) const {
    document.apply(words_().remove, [&](Project& project) {
        if (AnalysisEntry* entry = find_analysis_entry(project, analysis))
            std::erase_if(entry->*list_, [&](const Item& item) { return item.id == id; });
    });
}

template <class Item>
void InquiryList<Item>::change(Document& document, const std::string& analysis, const std::string& id,
                               const std::function<void(Item&)>& edit, const QString& merge_key) const {
    const QString key =
        merge_key.isEmpty()
            ? QString()
            : QStringLiteral("%1:%2:%3:%4").arg(words_().id, to_qt(analysis), to_qt(id), merge_key);
    document.apply(
        words_().change,
        [&](Project& project) {
            AnalysisEntry* entry = find_analysis_entry(project, analysis);
            if (!entry) return;
            for (Item& item : entry->*list_)
                if (item.id == id) edit(item);
        },
        key);
}

template class InquiryList<Study>;
template class InquiryList<Design>;

const InquiryList<Study>& study_list() {
    static const InquiryList<Study> list(&AnalysisEntry::studies, [] {
        return InquiryList<Study>::Words{Document::tr("Add study"),    Document::tr("Duplicate study"),
                                         Document::tr("Delete study"), Document::tr("Change study"),
                                         Document::tr("Study %1"),     QStringLiteral("study")};
    });
    return list;
}

const InquiryList<Design>& design_list() {
    static const InquiryList<Design> list(&AnalysisEntry::designs, [] {
        return InquiryList<Design>::Words{Document::tr("Add design"),    Document::tr("Duplicate design"),
                                          Document::tr("Delete design"), Document::tr("Change design"),
                                          Document::tr("Design %1"),     QStringLiteral("design")};
    });
    return list;
}

namespace {

/// Rank of a choice: poses of instruments are chosen most and come first, measured values come last.
int rank_as_variable(const Project& project, const StudyTargetChoice& choice) {
    const StudyTarget& target = choice.target;
    if (target.measured) return 4;
    if (target.kind == StudyTarget::Kind::column) return 3;  // all rows by one factor
    if (target.kind != StudyTarget::Kind::pose) return 2;
    if (target.asset == StudyTarget::analysis) return 1;
    const AssetDescriptor* kind = find_asset_kind(project.assets[target.asset].kind);
    return kind && kind->category == AssetCategory::instrument ? 0 : 2;
}

}  // namespace

std::optional<DesignVariable> next_variable(const Project& project, const AnalysisEntry& analysis,
                                            const std::vector<DesignVariable>& before) {
    std::optional<DesignVariable> next;
    int best = 0;
    for (const StudyTargetChoice& choice : study_targets(project, analysis, nullptr)) {
        const auto is_it = [&](const DesignVariable& variable) {
            return variable.number.asset == choice.axis.asset && variable.number.target == choice.axis.target;
        };
        if (choice.target.whole || std::ranges::any_of(before, is_it)) continue;
        const int rank = rank_as_variable(project, choice);
        if (next && rank >= best) continue;
        next = DesignVariable{choice.axis, 0.0};
        best = rank;
    }
    if (!next) return next;
    next->number.values = 2;
    next->number.spacing = StudySpacing::linear;
    return next;
}

namespace {

bool is_angle(const Unit& unit) {
    return unit.dimension() == Unit::of("rad").dimension();
}

/// The axis of a choice: a place is moved, and a joint turned, by what can be seen in the scene, unless the
/// number may not be that.
StudyAxis wide_axis(const Project& project, const AnalysisEntry& analysis, const StudyTargetChoice& choice) {
    constexpr double metres = 1.0, radians = 0.25 * std::numbers::pi;  // to each side
    using Kind = StudyTarget::Kind;
    const StudyTarget& target = choice.target;
    const bool turns = target.kind == Kind::cell && is_angle(target.unit);
    const bool moves = target.kind == Kind::pose && target.unit.dimension() == Unit::of("m").dimension();
    if (!turns && !moves) return choice.axis;
    StudyAxis wide = choice.axis;
    const double half = wide.unit.interval_from_si(turns ? radians : metres);
    wide.from = target.current - half;
    wide.to = target.current + half;
    Problems problems;
    check_study_axis(project, analysis, nullptr, wide, {}, problems);
    return problems.has_errors() ? choice.axis : wide;
}

/// Whether two angles stand in one row, as the readings of a robot's joints do.
bool turn_the_same(const StudyTarget& first, const StudyTarget& second) {
    return first.kind == StudyTarget::Kind::cell && second.kind == first.kind && is_angle(first.unit) &&
           is_angle(second.unit) && second.asset == first.asset && second.upstream == first.upstream &&
           second.key == first.key && second.row == first.row;
}

}  // namespace

Study new_study(const Project& project, const AnalysisEntry& analysis) {
    Study study;
    const auto choices = study_targets(project, analysis, nullptr);
    const auto best = std::ranges::min_element(
        choices, {}, [&](const StudyTargetChoice& choice) { return rank_as_variable(project, choice); });
    if (best == choices.end()) return study;
    std::vector<StudyTargetChoice> varied{*best};
    std::vector<StudyTargetChoice> joints;
    std::ranges::copy_if(choices, std::back_inserter(joints), [&](const StudyTargetChoice& choice) {
        return turn_the_same(best->target, choice.target);
    });
    // The first joint turns the whole arm, which makes no place better than another.
    if (joints.size() > 2) varied = {joints[1], joints[2]};
    for (const StudyTargetChoice& choice : varied) study.axes.push_back(wide_axis(project, analysis, choice));
    return study;
}

Design new_design(const Project& project, const AnalysisEntry& analysis) {
    Design design;
    if (auto first = next_variable(project, analysis, {})) design.variables.push_back(std::move(*first));
    return design;
}

}  // namespace covaria::ui
