// Units in which results are shown: a button with the usual units of every dimension in the result.
#pragma once

#include <QToolButton>

#include "core/text/display_units.h"
#include "ui/run/run_backend.h"

class QMenu;

namespace covaria::ui {

class UnitButton : public QToolButton {
    Q_OBJECT
public:
    explicit UnitButton(QWidget* parent = nullptr);

    void set_result(const ResultPointer& result);
    const DisplayUnits& units() const { return units_; }
    void choose(const Unit& unit);
    /// Every quantity in the unit of its model again.
    void clear();
    /// Adds the units of the dimension of `unit` to a menu.
    void add_choices(QMenu& menu, const Unit& unit);

signals:
    void units_changed();

private:
    void fill();
    void remember();

    DisplayUnits units_;
    std::vector<Unit> shown_;  ///< one of each dimension in the result
};

}  // namespace covaria::ui
