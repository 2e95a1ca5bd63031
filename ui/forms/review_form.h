// The review of the project: who prepared, checked and released it, whether it still is what was released,
// and the log of what was done.
#pragma once

#include <QWidget>
#include <vector>

#include "core/project/review.h"
#include "ui/document/document.h"

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace covaria::ui {

class FieldEditor;

/// Follows the document; every edit, the release and a line of the log are one undo step each. A release
/// needs all names and a project without errors; dates that are not stated become today's.
class ReviewForm : public QWidget {
    Q_OBJECT
public:
    explicit ReviewForm(Document& document, QWidget* parent = nullptr);

    /// Gives the focus to the field that a JSON pointer into the project names; false when it names none.
    bool focus_field(const std::string& path);
    /// Shows the state of the release, and says it in `summary_changed`.
    void show_state();

signals:
    /// "draft", "released", "draft again", or nothing.
    void summary_changed(const QString& words);

private:
    struct Row {
        const ReviewStepField* step;
        std::string ReviewStep::*member;
        FieldEditor* editor;
    };
    void add_step(const ReviewStepField& step, QFormLayout& form);
    void add_field(const ReviewStepField& step, std::string ReviewStep::*member, FieldEditor& editor,
                   const std::string& title, QFormLayout& form);
    QWidget* make_log();
    void release_project();
    void add_entry();
    void refresh();
    void refresh_problems();

    Document& document_;
    QLabel *state_, *log_;
    QPushButton* release_;
    QLineEdit *who_, *what_;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
