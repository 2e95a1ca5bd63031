#include "ui/document/kept_project.h"

#include <algorithm>
#include <utility>

namespace covaria::ui {

namespace {

template <class Entry>
using Entries = std::vector<std::shared_ptr<const Entry>>;

template <class Entry>
Entries<Entry> kept(std::vector<Entry> entries, const Entries<Entry>& of_neighbour) {
    Entries<Entry> all;
    for (Entry& entry : entries) {
        const auto same = std::find_if(of_neighbour.begin(), of_neighbour.end(), [&](const auto& candidate) {
            return candidate->id == entry.id && *candidate == entry;
        });
        all.push_back(same == of_neighbour.end() ? std::make_shared<const Entry>(std::move(entry)) : *same);
    }
    return all;
}

template <class Entry>
bool equal(const Entries<Entry>& a, const Entries<Entry>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& one, const auto& other) { return one == other || *one == *other; });
}

template <class Entry>
std::size_t shared(const Entries<Entry>& a, const Entries<Entry>& b) {
    return static_cast<std::size_t>(std::count_if(
        a.begin(), a.end(), [&](const auto& one) { return std::ranges::find(b, one) != b.end(); }));
}

}  // namespace

KeptProject::Pointer KeptProject::keep(Project project, const KeptProject* neighbour) {
    static const KeptProject none;
    const KeptProject& like = neighbour ? *neighbour : none;
    auto made = std::make_shared<KeptProject>();
    made->assets_ = kept(std::exchange(project.assets, {}), like.assets_);
    made->analyses_ = kept(std::exchange(project.analyses, {}), like.analyses_);
    made->rest_ = std::move(project);
    return made;
}

Project KeptProject::project() const {
    Project whole = rest_;
    for (const auto& asset : assets_) whole.assets.push_back(*asset);
    for (const auto& analysis : analyses_) whole.analyses.push_back(*analysis);
    return whole;
}

bool KeptProject::operator==(const KeptProject& other) const {
    return rest_ == other.rest_ && equal(assets_, other.assets_) && equal(analyses_, other.analyses_);
}

std::size_t KeptProject::shared_with(const KeptProject& other) const {
    return shared(assets_, other.assets_) + shared(analyses_, other.analyses_);
}

}  // namespace covaria::ui
