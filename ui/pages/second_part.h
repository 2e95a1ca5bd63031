// The other part of a stage that is split: one of its views, taken out of the tabs, with its name as a list.
#pragma once

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QTabWidget;
class QVBoxLayout;

namespace covaria::ui {

/// Each view is there once: in its place among the tabs stands nothing while it is here, and a view that is
/// chosen in one part while the other shows it changes places with what was there.
class SecondPart : public QWidget {
    Q_OBJECT
public:
    /// Object name of the first line of a view that has choices of its own: here it stands beside the list.
    static constexpr char head_of_view[] = "head_of_view";

    explicit SecondPart(QTabWidget& tabs, QWidget* parent = nullptr);

    /// The view that is here; null: the part is closed.
    QWidget* view() const { return view_; }
    /// Takes a view out of the tabs, and shows it here; the view shown before goes back to its tab.
    void show_view(QWidget* view);
    /// Gives the view back to its tab.
    void close_part();
    /// The tab of a view, wherever that is shown; -1: it is none.
    int tab_of(const QWidget* view) const;
    /// Follows a tab that has another name, or is hidden or shown.
    void take_names();
    QComboBox& list() { return *list_; }

signals:
    /// Other views are seen than before.
    void changed();

private:
    void make_head(QVBoxLayout& column);
    void take(QWidget* view);
    void give_back();
    void follow_tabs();
    void replace_page(int tab, QWidget* page);

    QTabWidget& tabs_;
    QWidget* gap_;  ///< stands in the tabs for the view that is here
    QWidget* view_ = nullptr;
    QWidget* main_ = nullptr;  ///< the view that the tabs showed last
    QComboBox* list_;
    QHBoxLayout* head_;
    QVBoxLayout* room_;
    QWidget* line_ = nullptr;  ///< first line of the view, in the head while the view is here
};

}  // namespace covaria::ui
