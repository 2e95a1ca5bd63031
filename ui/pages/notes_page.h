// The name and the notes of an asset or an analysis, or of the project.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/setup_address.h"

class QLineEdit;
class QPlainTextEdit;

namespace covaria::ui {

class NotesPage : public QWidget {
    Q_OBJECT
public:
    NotesPage(Document& document, SetupAddress entry, QWidget* parent = nullptr);

private:
    void refresh();
    void take_name();

    Document& document_;
    SetupAddress entry_;
    QLineEdit* name_;
    QPlainTextEdit* notes_;
};

}  // namespace covaria::ui
