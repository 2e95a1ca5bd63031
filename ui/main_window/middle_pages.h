// The middle of the window: the start page, what an empty project can begin with, or the scene.
#pragma once

#include <QStackedWidget>

#include "ui/document/document.h"

namespace covaria::ui {

class EmptyProject;
class ScenePanel;
class StartPage;

/// Once a project has been shown, the scene follows its first entry and the list of beginnings its last.
class MiddlePages : public QStackedWidget {
    Q_OBJECT
public:
    MiddlePages(const Document& document, ScenePanel& scene, QWidget* parent = nullptr);
    StartPage& start() { return *start_; }
    EmptyProject& empty() { return *empty_; }
    void show_start();
    void show_project();

private:
    const Document& document_;
    StartPage* start_;
    EmptyProject* empty_;
    ScenePanel& scene_;
};

}  // namespace covaria::ui
