// The bottom of the window: problems of the project, and the log.
#pragma once

#include <QMap>
#include <QPlainTextEdit>
#include <QTreeView>

#include "ui/models/problems_model.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

/// A click (or Enter) goes to the field, on a way out takes it.
class ProblemsPane : public QTreeView {
    Q_OBJECT
public:
    explicit ProblemsPane(Document& document, QWidget* parent = nullptr);
    ProblemsModel& problems() { return model_; }

signals:
    /// A place in the project is wanted: a JSON pointer into it.
    void place_wanted(const QString& path);
    /// Tells why a way out cannot be taken.
    void refused(const QString& why);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void show_remedies();
    ProblemsModel model_;
};

/// Messages with their time of day; safe to write to from any thread.
class LogPane : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit LogPane(QWidget* parent = nullptr);
    void write(const QString& message);
    /// Writes the failures of runs, each once, however often an edit runs the analysis again.
    void follow(AnalysisRunner& runner);

private:
    QMap<QString, QString> said_;  ///< last failure of each analysis
};

}  // namespace covaria::ui
