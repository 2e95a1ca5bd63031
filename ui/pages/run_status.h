// What the status bar says about computing: which analysis, how far, how fast, how long still.
#pragma once

#include <QWidget>

#include "ui/run/analysis_runner.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace covaria::ui {

class RunStatus : public QWidget {
    Q_OBJECT
public:
    explicit RunStatus(AnalysisRunner& runner, QWidget* parent = nullptr);

private:
    void show_progress(const QString& id, const RunProgress& progress);
    void show_idle();

    QLabel* text_;
    QProgressBar* bar_;
    QToolButton* stop_;
};

/// "1 234 000 trials", "2.3 million trials/s", "4 s left" in words for people.
QString progress_words(const RunProgress& progress);

}  // namespace covaria::ui
