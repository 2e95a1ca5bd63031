// The bottom of the window: problems of the project, and the log.
#pragma once

#include <QPlainTextEdit>
#include <QTreeView>

#include "ui/models/problems_model.h"

namespace covaria::ui {

/// A click (or Enter) goes to the field, on a way out takes it.
class ProblemsPane : public QTreeView {
    Q_OBJECT
public:
    explicit ProblemsPane(Document& document, QWidget* parent = nullptr);
    ProblemsModel& problems() { return model_; }

signals:
    /// JSON pointer into the project.
    void place_wanted(const QString& path);
    /// A way out cannot be taken: why.
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
};

}  // namespace covaria::ui
