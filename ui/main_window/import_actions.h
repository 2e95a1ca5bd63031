// Takes what other programs wrote into the project: what the readers read, a robot from URDF.
#pragma once

#include <QAction>
#include <QObject>

#include "core/readers/reader.h"
#include "ui/document/document.h"
#include "ui/document/setup_address.h"
#include "ui/main_window/dialogs.h"

namespace covaria::ui {

class ImportActions : public QObject {
    Q_OBJECT
public:
    ImportActions(Document& document, Dialogs& dialogs, QObject* parent = nullptr);

    QAction* import_action;
    QAction* urdf_action;

    void ask_for_file();
    /// Shows what would become of it; adds it, in one undo step, when that is accepted.
    void import_file(const QString& file);
    void ask_for_urdf();
    /// Adds the robot to the project, in one undo step; says why not where it cannot.
    void import_urdf_file(const QString& file);

signals:
    /// Somebody accepted an import: a project that it can be added to must be there now.
    void accepted();
    void imported(const SetupAddress& entry);
    void message(const QString& text);

private:
    void take_over(const QString& name, const Proposals& proposals);

    Document& document_;
    Dialogs& dialogs_;
};

}  // namespace covaria::ui
