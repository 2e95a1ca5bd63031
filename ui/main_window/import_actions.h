// Takes what other programs wrote into the project: a robot from URDF.
#pragma once

#include <QAction>
#include <QObject>

#include "ui/document/document.h"
#include "ui/main_window/dialogs.h"

namespace covaria::ui {

class ImportActions : public QObject {
    Q_OBJECT
public:
    ImportActions(Document& document, Dialogs& dialogs, QObject* parent = nullptr);

    QAction* urdf_action;

    void ask_for_urdf();
    /// Adds the robot to the project, in one undo step; says why not where it cannot.
    void import_urdf_file(const QString& file);

signals:
    void imported(const QString& asset);
    void message(const QString& text);

private:
    Document& document_;
    Dialogs& dialogs_;
};

}  // namespace covaria::ui
