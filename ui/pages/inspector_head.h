// The title of the inspector: what is selected, and the way to the entries before and after it.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/selection.h"

class QToolButton;

namespace covaria::ui {

class ElidedLabel;

class InspectorHead : public QWidget {
    Q_OBJECT
public:
    InspectorHead(Document& document, Selection& selection, QWidget* parent = nullptr);

private:
    void take_name();
    void step(int by);

    Document& document_;
    Selection& selection_;
    ElidedLabel* name_;
    QToolButton* before_;
    QToolButton* after_;
};

}  // namespace covaria::ui
