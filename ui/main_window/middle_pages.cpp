#include "ui/main_window/middle_pages.h"

#include "ui/pages/empty_project.h"
#include "ui/pages/start_page.h"

namespace covaria::ui {

MiddlePages::MiddlePages(const Document& document, QWidget& stage, QWidget* parent)
    : QStackedWidget(parent),
      document_(document),
      start_(new StartPage),
      empty_(new EmptyProject),
      stage_(stage) {
    for (QWidget* page : {static_cast<QWidget*>(start_), static_cast<QWidget*>(empty_), &stage_})
        addWidget(page);
    connect(&document_, &Document::project_changed, this, [this] {
        if (currentWidget() != start_) show_project();
    });
}

void MiddlePages::show_start() {
    setCurrentWidget(start_);
}

void MiddlePages::show_project() {
    const Project& project = document_.project();
    const bool is_empty = project.analyses.empty() && project.assets.empty();
    setCurrentWidget(is_empty ? static_cast<QWidget*>(empty_) : &stage_);
}

}  // namespace covaria::ui
