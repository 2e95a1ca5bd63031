// A frame around a widget, wherever it is in its window.
#pragma once

#include <QList>
#include <QPointer>
#include <QWidget>

namespace covaria::ui {

/// Takes no clicks and no focus; follows its target, and is hidden while that is not in view.
class HighlightFrame : public QWidget {
    Q_OBJECT
public:
    explicit HighlightFrame(QWidget* parent);

    /// Null: the frame surrounds nothing.
    void surround(QWidget* target);
    QWidget* target() const { return target_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();

    QPointer<QWidget> target_;
    QList<QPointer<QWidget>> watched_;  ///< the target and what it is in
};

/// Opens the docks and tabs that a widget is in and scrolls it into view. False: it is hidden otherwise.
bool reveal(QWidget& widget);

}  // namespace covaria::ui
