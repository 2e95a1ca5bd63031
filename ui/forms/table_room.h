// Tables of a form share the room that its page has to spare.
#pragma once

#include <QList>
#include <QObject>

class QScrollArea;

namespace covaria::ui {

class SpreadsheetView;

/// Follows a page and what is on it. Tables longer than a form gives them by itself get more rows, all as
/// many, as long as the page does not scroll for it.
class TableRoom : public QObject {
    Q_OBJECT
public:
    /// `area`: has its page already, and owns this object.
    explicit TableRoom(QScrollArea& area);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void share();
    /// px of the page that are not of these tables.
    int height_of_others(const QList<SpreadsheetView*>& tables) const;

    QScrollArea& area_;
    bool waits_ = false;
};

}  // namespace covaria::ui
