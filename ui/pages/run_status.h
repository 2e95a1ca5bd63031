// Words of the status bar on computing: the state of the analysis looked at, and while a run goes on, how
// far, how fast, how long still.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/run/analysis_runner.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace covaria::ui {

class RunStatus : public QWidget {
    Q_OBJECT
public:
    RunStatus(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);
    /// "Pose: up to date" as shown.
    QString words() const;

private:
    void show_progress(const QString& id, const RunProgress& progress);
    void show_inquiry_progress(const QString& name, const RunProgress& progress);
    void show_bar(const QString& words, const RunProgress& progress);
    void show_state();
    void show_idle();
    void set_picture(const QString& icon);
    QString name_of(const QString& id) const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    QLabel* picture_;
    QLabel* text_;
    QProgressBar* bar_;
    QToolButton* stop_;
    bool running_ = false;
};

/// "1 234 000 trials", "2.3 million trials/s", "4 s left" in words for people.
QString progress_words(const RunProgress& progress);
/// "40 s left", "9 min left", "2.5 h left".
QString time_left_words(double seconds);

}  // namespace covaria::ui
