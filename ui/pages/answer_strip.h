// The answer of the analysis being looked at, above everything that is said of it.
#pragma once

#include <QString>
#include <QWidget>

#include "core/text/display_units.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/pages/answer.h"
#include "ui/run/analysis_runner.h"
#include "ui/theme/typeset_views.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace covaria::ui {

class Chip;
class TypesetLabel;

/// The statement, k, p and the verdict; below them how it came about and how far a run is. What there is no
/// room for gives way from the right: the method, the figures of the verdict, then k and p.
class AnswerStrip : public QWidget {
    Q_OBJECT
public:
    AnswerStrip(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    void set_units(const DisplayUnits& units);
    void set_digits(int digits);  ///< significant ones of U
    /// Follows the result, state, requirements or selection, one of which is another.
    void take_result();

    /// The choice of the output looked at, among those in view.
    TypesetComboBox& outputs() { return *outputs_; }
    /// The button for the next step of an analysis that is not complete.
    QPushButton& next_step() { return *next_; }
    QToolButton& copy_button() { return *copy_; }
    const TypesetLabel& value() const { return *value_; }
    const TypesetLabel& coverage() const { return *coverage_; }
    const Chip& verdict() const { return *verdict_; }
    const QLabel& state() const { return *state_; }
    /// Text that the button copies.
    QString statements() const;

signals:
    /// A place in the project is wanted: a JSON pointer into it.
    void place_wanted(const QString& path);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void lay_out();
    void show_state();
    void show_next_step();
    void show_way_to_error();
    void show_verdict(const AnalysisStatus& status);
    void show_progress(const QString& id, const RunProgress& progress);
    void give_way();
    QString state_words() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    DisplayUnits units_;
    int digits_ = 2;
    Answer answer_;
    QString progress_;  ///< how far the analysis' run is
    TypesetLabel* value_;
    TypesetLabel* coverage_;
    Chip* verdict_;
    QLabel* state_;
    TypesetComboBox* outputs_;
    QToolButton* copy_;
    QPushButton* next_;
    QString next_place_;
};

}  // namespace covaria::ui
