// Small buttons for the rows of a table, for the head of the table.
#pragma once

#include <QPointer>
#include <QWidget>

class QAction;
class QHBoxLayout;
class QToolButton;

namespace covaria::ui {

class SpreadsheetView;

/// Rows are added, deleted and filled down. The buttons are seen while the keyboard is in the table or in
/// them; their place keeps its height.
class RowTools : public QWidget {
    Q_OBJECT
public:
    /// `table`: the view, or what it is a part of; it may live longer or shorter than these buttons.
    RowTools(const QWidget& table, SpreadsheetView& view, QWidget* parent = nullptr);
    ~RowTools() override;
    /// Adds a further button.
    void add(const QString& picture, const QString& text, QAction* action);

private:
    void follow_focus(const QWidget* focused);

    QPointer<const QWidget> table_;
    SpreadsheetView& view_;
    QWidget* buttons_;
    QHBoxLayout* places_;
};

}  // namespace covaria::ui
