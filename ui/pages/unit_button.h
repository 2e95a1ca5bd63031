// Units in which results are shown: a button with the usual units of every dimension in the result. The
// choice is a preference.
#pragma once

#include <QToolButton>

#include "core/text/display_units.h"
#include "ui/document/document.h"
#include "ui/run/run_backend.h"
#include "ui/theme/preferences.h"

class QMenu;

namespace covaria::ui {

class UnitButton : public QToolButton {
    Q_OBJECT
public:
    UnitButton(Document& document, PreferenceStore& preferences, QWidget* parent = nullptr);

    void set_result(const ResultPointer& result);
    /// Units of what is shown: those that the project states, else those that the user prefers.
    DisplayUnits units() const;
    void choose(const Unit& unit);
    /// Puts every quantity into the unit of its model again: neither stated nor preferred.
    void clear();
    /// Adds the units of the dimension of `unit` to a menu.
    void add_choices(QMenu& menu, const Unit& unit);

private:
    void fill();
    void prefer(DisplayUnits units);
    void state(const QString& words, const DisplayUnits& units);

    Document& document_;
    PreferenceStore& preferences_;
    std::vector<Unit> shown_;  ///< one of each dimension in the result
};

}  // namespace covaria::ui
