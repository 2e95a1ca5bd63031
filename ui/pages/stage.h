// The views of an analysis: one of them, or two below or beside each other.
#pragma once

#include <QSplitter>

class QTabWidget;
class QToolButton;

namespace covaria::ui {

class SecondPart;

/// Each view is there once. The first of them (scene, or budget that is typed) stays in view as long as the
/// stage is split; whether it is, and how, is remembered.
class Stage : public QSplitter {
    Q_OBJECT
public:
    explicit Stage(QTabWidget& tabs, QWidget* parent = nullptr);

    void add_first(QWidget& view, const QString& name);
    void name_first(const QString& name);
    /// While the tabs show this view it has the whole stage: pages are read, not glanced at.
    void give_whole_stage(QWidget& view);
    /// Shows the first view, and this one in the second part if the stage is split.
    void show_usual(QWidget& second);
    /// Brings it into view, beside the first one where the stage is split.
    void show_view(QWidget* view);
    /// Whether it shows a view or a part of one.
    bool shows(const QWidget& part) const;
    int tab_of(const QWidget* view) const;
    SecondPart& second() { return *second_; }
    QToolButton& split_button() { return *split_; }

signals:
    /// Other views are seen than before.
    void changed();

private:
    void make_split_button();
    void split(bool wanted);
    void give_room();
    void turn(Qt::Orientation orientation);

    QTabWidget& tabs_;
    SecondPart* second_;
    QToolButton* split_;
    QWidget* first_ = nullptr;
    QWidget* alone_ = nullptr;  ///< has the whole stage
    QWidget* usual_ = nullptr;  ///< the view that the second part usually shows
};

}  // namespace covaria::ui
