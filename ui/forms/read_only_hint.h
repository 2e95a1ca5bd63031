// Why a table takes no typing, said beside the cell where somebody types.
#pragma once

#include <QObject>
#include <functional>

class QAbstractItemView;

namespace covaria::ui {

/// Lives as long as its view. A letter typed into a cell that cannot be edited searches for nothing then.
class ReadOnlyHint : public QObject {
    Q_OBJECT
public:
    /// `reason`: what is said; empty: nothing.
    ReadOnlyHint(QAbstractItemView& view, std::function<QString()> reason);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAbstractItemView& view_;
    std::function<QString()> reason_;
};

}  // namespace covaria::ui
