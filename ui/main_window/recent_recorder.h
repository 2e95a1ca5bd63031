// Remembers of a saved project what the start page shows of it.
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

class AnswerStrip;
class SceneView;

/// When runs have ended and the project is as its file: its answer, verdict and picture.
class RecentRecorder : public QObject {
    Q_OBJECT
public:
    struct Seen {
        Document& document;
        AnalysisRunner& runner;
        Selection& selection;
        AnswerStrip& answer;
        SceneView& scene;
    };
    RecentRecorder(const Seen& seen, QObject* parent);
    /// At once.
    void record();

signals:
    void recorded(const QString& file);

private:
    Seen seen_;
    QTimer later_;  ///< the picture comes behind the result
};

}  // namespace covaria::ui
