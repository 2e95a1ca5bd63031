// The one undo step there is: the project before and after.
#pragma once

#include <QElapsedTimer>
#include <QUndoCommand>

#include "ui/document/document.h"

namespace covaria::ui {

class ProjectCommand : public QUndoCommand {
public:
    struct Merge {
        QString key;     ///< empty: never merges
        int series = 0;  ///< only steps of one series merge
        int window = 0;  ///< ms
    };
    ProjectCommand(Document& document, const QString& text, ProjectSnapshot after, Merge merge);

    void undo() override { document_.set_project(before_); }
    void redo() override { document_.set_project(after_); }
    int id() const override { return merge_.key.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override;

private:
    Document& document_;
    KeptProject::Pointer before_;
    KeptProject::Pointer after_;
    Merge merge_;
    QElapsedTimer age_;  ///< since the last edit of the step
};

}  // namespace covaria::ui
