// The bar above the pages of a report: "3 of 17" with previous and next, and how large they are shown.
#pragma once

#include <QWidget>

class QAction;
class QComboBox;
class QSpinBox;

namespace covaria::ui {

class PageView;

/// A bar whose actions have keys that work while `owner` or a widget in it has the focus.
class PageBar : public QWidget {
    Q_OBJECT
public:
    PageBar(PageView& view, QWidget& owner);

    /// Follows a view that has other pages.
    void take_pages();

private:
    void make_actions(QWidget& owner);
    QWidget* make_zoom_box();
    void show_page(int page);
    void show_zoom();
    void take_zoom_text();

    PageView& view_;
    QAction* previous_;
    QAction* next_;
    QAction* smaller_;
    QAction* larger_;
    QSpinBox* page_;
    QComboBox* zoom_;
};

}  // namespace covaria::ui
