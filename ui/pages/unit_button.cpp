// The choice is among the preferences.
#include "ui/pages/unit_button.h"

#include <QMenu>
#include <algorithm>

#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
UnitButton::UnitButton(PreferenceStore& preferences, QWidget* parent)
    : QToolButton(parent), preferences_(preferences) {
    setText(tr("Units"));
    setIcon(ui::icon(QStringLiteral("units")));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setToolTip(tr("Units of the tables and charts"));
    setAccessibleName(tr("Units of the tables and charts"));
    setPopupMode(QToolButton::InstantPopup);
    setAutoRaise(true);
    setMenu(new QMenu(this));
    connect(menu(), &QMenu::aboutToShow, this, &UnitButton::fill);
}

void UnitButton::set_result(const ResultPointer& result) {
    shown_.clear();
    for (std::size_t i = 0; result && i < result->outputs.size(); ++i) {
        const Unit& unit = result->outputs[i].quantity.unit;
        const auto known = std::find_if(shown_.begin(), shown_.end(), [&](const Unit& other) {
            return other.dimension() == unit.dimension();
        });
        if (known == shown_.end() && !unit.dimension().is_one()) shown_.push_back(unit);
        if (known != shown_.end() && unit.has_offset()) *known = unit;  // has the more choices
    }
    setEnabled(!shown_.empty());
}

void UnitButton::fill() {
    menu()->clear();
    for (const Unit& unit : shown_) {
        add_choices(*menu(), unit);
        menu()->addSeparator();
    }
    menu()->addAction(tr("As the Model Gives Them"), this, &UnitButton::clear);
}

void UnitButton::add_choices(QMenu& menu, const Unit& unit) {
    for (const Unit& choice : DisplayUnits::choices(unit)) {
        QAction* action =
            menu.addAction(to_qt(choice.display()), this, [this, choice] { this->choose(choice); });
        action->setCheckable(true);
        action->setChecked(units().of(unit) == choice);
    }
}

void UnitButton::choose(const Unit& unit) {
    DisplayUnits wanted = units();
    wanted.choose(unit);
    take(std::move(wanted));
}

void UnitButton::clear() {
    take({});
}

void UnitButton::take(DisplayUnits units) {
    Preferences wanted = preferences_.now();
    wanted.units = std::move(units);
    preferences_.set(wanted);
}

}  // namespace covaria::ui
