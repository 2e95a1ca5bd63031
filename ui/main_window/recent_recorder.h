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

/// Keeps answer, verdict and picture of a project for its card, when runs have ended and it is as its file.
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
    /// Keeps them at once.
    void record();

signals:
    void recorded(const QString& file);

private:
    Seen seen_;
    QTimer later_;  ///< the picture comes behind the result
};

}  // namespace covaria::ui
