// The focus of the window: one entry of the project, and within an analysis a group, an output, a
// set-up field.
#pragma once

#include <QObject>
#include <QString>

#include "ui/document/setup_address.h"

namespace covaria::ui {

/// Tree, tables, charts and scene all write to it and follow it: selecting a thing in one selects it
/// everywhere. Every setter is silent when nothing changes, so that followers may write back what they were
/// told.
class Selection : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const SetupAddress& entry() const { return entry_; }
    /// The analysis last looked at: results stay in view while an asset is edited.
    const QString& analysis() const { return analysis_; }
    const QString& group() const { return group_; }
    int output() const { return output_; }             ///< index into the result's outputs; -1 = none
    const QString& study() const { return study_; }    ///< id of a study of the analysis
    const QString& design() const { return design_; }  ///< id of a design of the analysis
    const QString& field() const { return field_; }    ///< JSON pointer within the entry's set-up

    void select_entry(const SetupAddress& entry);
    void select_group(const QString& group);
    void select_output(int output);
    void select_field(const QString& field);
    void select_study(const QString& study);
    void select_design(const QString& design);
    void clear();
    /// Leaves an analysis that the project no longer has: its results and scene would stand for ever.
    void leave_what_is_gone(const Project& project);

signals:
    void entry_changed();
    void analysis_changed(const QString& analysis);
    void group_changed(const QString& group);
    void output_changed(int output);
    void field_changed(const QString& field);
    void study_changed(const QString& study);
    void design_changed(const QString& design);

private:
    SetupAddress entry_;
    QString analysis_, group_, field_, study_, design_;
    int output_ = -1;
};

}  // namespace covaria::ui
