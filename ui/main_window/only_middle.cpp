#include "ui/main_window/only_middle.h"

#include <QMainWindow>
#include <QSignalBlocker>

namespace covaria::ui {

OnlyMiddle::OnlyMiddle(QMainWindow& window, QList<QDockWidget*> docks)
    : QAction(tr("Only the &Middle"), &window), window_(window), docks_(std::move(docks)) {
    setObjectName(QStringLiteral("only_middle"));
    setCheckable(true);
    setShortcut(QKeySequence(Qt::Key_F11));
    setToolTip(tr("The stage alone; once more, and the panes stand as they did"));
    connect(this, &QAction::toggled, this, [this](bool on) { on ? put_away() : bring_back(); });
    for (QDockWidget* dock : docks_)
        connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
            if (!visible || moving_ || !isChecked()) return;
            const QSignalBlocker blocker(this);
            setChecked(false);
        });
}

void OnlyMiddle::put_away() {
    before_ = window_.saveState();
    for (QDockWidget* dock : docks_) dock->hide();
}

void OnlyMiddle::bring_back() {
    moving_ = true;
    window_.restoreState(before_);
    moving_ = false;
}

}  // namespace covaria::ui
