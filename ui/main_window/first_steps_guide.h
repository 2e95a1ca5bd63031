// The first steps beside the window: sees what was done, shows where the next is done.
#pragma once

#include <QObject>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/pages/first_steps.h"
#include "ui/run/analysis_runner.h"

class QDockWidget;
class QMainWindow;

namespace covaria::ui {

class BudgetPage;
class ExportActions;
class FirstStepsPanel;
class HighlightFrame;
class ResultsPane;

/// Made when it is first asked for; never in the way of anything.
class FirstStepsGuide : public QObject {
    Q_OBJECT
public:
    struct Parts {
        QMainWindow& window;
        Document& document;
        AnalysisRunner& runner;
        Selection& selection;
        BudgetPage& budget;
        ResultsPane& results;
        ExportActions& exports;
    };
    explicit FirstStepsGuide(const Parts& parts);

    /// Begins when there is a project.
    void begin();
    FirstStepsPanel& panel() const { return *panel_; }
    /// The steps that project and window show to be taken at this moment.
    StepsTaken taken() const;
    /// Opens what a step is about and puts the frame around it; where it is not there yet, the first step
    /// that is still to be done.
    void show_step(int step);

private:
    void connect_parts();
    void look();
    void start_over();
    void show_target(int step);
    QWidget* reveal_target(const FirstStep& step);

    Parts parts_;
    QDockWidget* dock_;
    FirstStepsPanel* panel_;
    HighlightFrame* frame_;
    bool exported_ = false;
};

}  // namespace covaria::ui
