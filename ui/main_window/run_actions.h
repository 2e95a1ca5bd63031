// Run, run all, stop, live: enabled where they can do something.
#pragma once

#include <QAction>
#include <QObject>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/run/analysis_runner.h"

class QMenu;

namespace covaria::ui {

class RunActions : public QObject {
    Q_OBJECT
public:
    RunActions(Document& document, AnalysisRunner& runner, Selection& selection, QObject* parent = nullptr);
    void add_to(QMenu& menu);

    QAction* run;
    QAction* run_all;
    QAction* stop;
    QAction* live;  ///< checkable, remembered

private:
    void update();

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
};

}  // namespace covaria::ui
