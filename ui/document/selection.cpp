#include "ui/document/selection.h"

#include "ui/theme/strings.h"

namespace covaria::ui {

void Selection::select_entry(const SetupAddress& entry) {
    if (entry == entry_) return;
    const bool other_analysis = entry.owner == SetupOwner::analysis && to_qt(entry.id) != analysis_;
    entry_ = entry;
    field_.clear();
    if (other_analysis) {
        analysis_ = to_qt(entry.id);
        output_ = -1;
        study_.clear();
        design_.clear();
    }
    // Who is told of the one looks at the other as well: both are as they are now before anybody is told.
    if (other_analysis) emit analysis_changed(analysis_);
    emit entry_changed();
}

void Selection::select_group(const QString& group) {
    if (group == group_) return;
    group_ = group;
    emit group_changed(group);
}

void Selection::select_output(int output) {
    if (output == output_) return;
    output_ = output;
    emit output_changed(output);
}

void Selection::select_field(const QString& field) {
    if (field == field_) return;
    field_ = field;
    emit field_changed(field);
}

void Selection::select_study(const QString& study) {
    if (study == study_) return;
    study_ = study;
    emit study_changed(study);
}

void Selection::select_design(const QString& design) {
    if (design == design_) return;
    design_ = design;
    emit design_changed(design);
}

void Selection::clear() {
    entry_ = {};
    analysis_.clear();
    group_.clear();
    field_.clear();
    study_.clear();
    design_.clear();
    output_ = -1;
    emit entry_changed();
    emit analysis_changed(analysis_);
}

void Selection::leave_what_is_gone(const Project& project) {
    if (analysis_.isEmpty() || project.find_analysis(to_std(analysis_))) return;
    const SetupAddress entry = entry_;
    clear();
    if (exists(project, entry)) select_entry(entry);
}

}  // namespace covaria::ui
