// The middle of the window: the start page, what an empty project can begin with, or the stage.
#pragma once

#include <QStackedWidget>

#include "ui/document/document.h"

namespace covaria::ui {

class EmptyProject;
class StartPage;

/// Once a project has been shown, the stage follows its first entry and the list of beginnings its last.
class MiddlePages : public QStackedWidget {
    Q_OBJECT
public:
    /// The stage: what a project is looked at in.
    MiddlePages(const Document& document, QWidget& stage, QWidget* parent = nullptr);
    StartPage& start() { return *start_; }
    EmptyProject& empty() { return *empty_; }
    void show_start();
    void show_project();

private:
    const Document& document_;
    StartPage* start_;
    EmptyProject* empty_;
    QWidget& stage_;
};

}  // namespace covaria::ui
