// Adding, changing and removing what an analysis is asked beside its result (studies, designs), each as one
// undo step.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/document/document.h"

namespace covaria::ui {

/// One of the lists of an analysis. Instances: study_list(), design_list().
template <class Item>
class InquiryList {
public:
    /// Words of undo steps and names, and the beginning of ids.
    struct Words {
        QString add, duplicate, remove, change;
        QString name;  ///< "Study %1"
        QString id;
    };
    using Member = std::vector<Item> AnalysisEntry::*;
    InquiryList(Member list, std::function<Words()> words) : list_(list), words_(std::move(words)) {}

    const std::vector<Item>& of(const AnalysisEntry& analysis) const { return analysis.*list_; }
    /// Null when there is none.
    const Item* find(const Project& project, const std::string& analysis, const std::string& id) const;
    /// Adds an item with an id and a name of its own; returns the id.
    std::string add(Document& document, const std::string& analysis, Item item) const;
    std::string duplicate(Document& document, const std::string& analysis, const std::string& id) const;
    void remove(Document& document, const std::string& analysis, const std::string& id) const;
    /// `merge_key`: changes of one field that follow each other closely are one step.
    void change(Document& document, const std::string& analysis, const std::string& id,
                const std::function<void(Item&)>& edit, const QString& merge_key = {}) const;

private:
    std::string free_id(const AnalysisEntry& analysis) const;

    Member list_;
    std::function<Words()> words_;
};

const InquiryList<Study>& study_list();
const InquiryList<Design>& design_list();

/// The study offered first: it moves an instrument by a metre to each side, maps what the second and
/// third joint of a robot do, or else varies what a user would change first.
Study new_study(const Project& project, const AnalysisEntry& analysis);
/// The first number that can be chosen, besides those that are already: where an instrument stands before
/// other numbers, and what was measured only where there is nothing else. Between half and one and a half
/// times its present value or as far as makes sense. None: there is no further number.
std::optional<DesignVariable> next_variable(const Project& project, const AnalysisEntry& analysis,
                                            const std::vector<DesignVariable>& before);
/// A design that chooses the first of those variables.
Design new_design(const Project& project, const AnalysisEntry& analysis);

}  // namespace covaria::ui
