// The way to the window that tells what hangs on a certificate.
#pragma once

#include <QAction>
#include <QObject>

#include "ui/document/document.h"
#include "ui/document/selection.h"

namespace covaria::ui {

class FileActions;
class ImpactDialog;

class ImpactActions : public QObject {
    Q_OBJECT
public:
    ImpactActions(QWidget& window, Document& document, Selection& selection, FileActions& files);

    QAction* action;
    /// Asks about a certificate by its number; an empty one leaves what was asked before.
    void ask_about(const QString& certificate);
    /// Made when it is first asked for.
    ImpactDialog& dialog();

private:
    QWidget& window_;
    Document& document_;
    Selection& selection_;
    FileActions& files_;
    ImpactDialog* dialog_ = nullptr;
};

}  // namespace covaria::ui
