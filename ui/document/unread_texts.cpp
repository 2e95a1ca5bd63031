#include "ui/document/unread_texts.h"

#include <algorithm>

#include "core/project/entry_graph.h"
#include "core/project/links.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

const UnreadText* UnreadTexts::find(const TextPlace& place) const {
    const auto found = texts_.find(place);
    return found == texts_.end() ? nullptr : &found->second;
}

UnreadText UnreadTexts::stamped(UnreadText text, const UnreadText* before) const {
    text.step = before && before->text == text.text ? before->step : step_;
    return text;
}

void UnreadTexts::set(const TextPlace& place, UnreadText text) {
    const UnreadText* before = find(place);
    if (before && *before == text) return;
    text = stamped(std::move(text), before);
    texts_[place] = std::move(text);
    emit changed();
}

bool UnreadTexts::has_since(int step) const {
    return std::any_of(texts_.begin(), texts_.end(),
                       [step](const auto& known) { return known.second.step >= step; });
}

bool UnreadTexts::take_back(int step) {
    if (std::erase_if(texts_, [step](const auto& known) { return known.second.step >= step; }) == 0)
        return false;
    emit changed();
    return true;
}

void UnreadTexts::remove(const TextPlace& place) {
    if (texts_.erase(place) > 0) emit changed();
}

void UnreadTexts::clear() {
    if (texts_.empty()) return;
    texts_.clear();
    emit changed();
}

UnreadTexts::Texts UnreadTexts::under(const SetupAddress& entry, const std::string& part) const {
    Texts found;
    for (const auto& [place, text] : texts_)
        if (place.entry == entry && place.part.starts_with(part)) found[place] = text;
    return found;
}

void UnreadTexts::replace_under(const SetupAddress& entry, const std::string& part, Texts texts) {
    const Texts before = under(entry, part);
    if (before == texts) return;
    for (auto& moved : texts) {
        // Rows that come and go move it.
        const auto same = std::find_if(before.begin(), before.end(),
                                       [&](const auto& known) { return known.second == moved.second; });
        moved.second = stamped(std::move(moved.second), same == before.end() ? nullptr : &same->second);
    }
    std::erase_if(texts_, [&](const auto& known) {
        return known.first.entry == entry && known.first.part.starts_with(part);
    });
    texts_.merge(texts);
    emit changed();
}

int UnreadTexts::count(const Project& project) const {
    return int(std::count_if(texts_.begin(), texts_.end(),
                             [&](const auto& text) { return exists(project, text.first.entry); }));
}

Problems UnreadTexts::problems(const Project& project) const {
    Problems problems;
    for (const auto& [place, text] : texts_)
        if (exists(project, place.entry))
            problems.error(entry_path(project, place.entry) + place.part, to_std(text.reason));
    return problems;
}

UnreadTexts::Held UnreadTexts::held(const Project& project) const {
    Held held;
    for (const auto& [place, text] : texts_) {
        const bool of_results =
            place.entry.owner == SetupOwner::project && place.part.starts_with("/results/");
        if ((place.entry.owner == SetupOwner::project && !of_results) || !exists(project, place.entry))
            continue;
        const bool of_inquiry = place.part.starts_with("/studies/") || place.part.starts_with("/designs/");
        const bool of_analysis = place.entry.owner == SetupOwner::analysis;
        std::vector<std::string> users = of_analysis && !of_inquiry
                                             ? analyses_taking_from(project, place.entry.id)
                                             : std::vector<std::string>{};
        if (of_results) {
            for (const AnalysisEntry& analysis : project.analyses) users.push_back(analysis.id);
        } else if (of_analysis) {
            users.push_back(place.entry.id);
        } else {
            users = analyses_using(project, place.entry.id);
        }
        for (const std::string& id : users) {
            const QString reason = tr("What is typed in a field cannot be read. %1").arg(text.reason);
            held.inquiries.try_emplace(id, reason);
            if (!of_inquiry) held.analyses.try_emplace(id, reason);
        }
    }
    return held;
}

}  // namespace covaria::ui
