// The choice is kept where the fact is: in the project or among the preferences.
#include "ui/pages/unit_button.h"

#include <QMenu>
#include <algorithm>

#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
UnitButton::UnitButton(Document& document, PreferenceStore& preferences, QWidget* parent)
    : QToolButton(parent), document_(document), preferences_(preferences) {
    setText(tr("Units"));
    setIcon(ui::icon(QStringLiteral("units")));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setToolTip(tr("Units of the tables and charts; reports and files have those that the project states"));
    setAccessibleName(tr("Units of the tables and charts"));
    setPopupMode(QToolButton::InstantPopup);
    setAutoRaise(true);
    setMenu(new QMenu(this));
    menu()->setToolTipsVisible(true);
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
    // A choice made here is the window's, unless the project states a unit already.
    const DisplayUnits& stated = document_.project().results.style.units;
    DisplayUnits shown = stated;
    for (const Unit& unit : shown_) shown.choose(units().of(unit));
    QAction* documents = menu()->addAction(tr("In Reports and Files Too"), this,
                                           [this, shown] { state(tr("Change unit of results"), shown); });
    documents->setToolTip(
        tr("States the units that are shown in the project: they are those of its documents"));
    documents->setEnabled(std::any_of(shown_.begin(), shown_.end(), [&](const Unit& unit) {
        return !(shown.of(unit) == stated.of(unit));
    }));
}

void UnitButton::add_choices(QMenu& menu, const Unit& unit) {
    for (const Unit& choice : DisplayUnits::choices(unit)) {
        QAction* action =
            menu.addAction(to_qt(choice.display()), this, [this, choice] { this->choose(choice); });
        action->setCheckable(true);
        action->setChecked(units().of(unit) == choice);
    }
}

DisplayUnits UnitButton::units() const {
    return with_preferred(document_.project().results.style.units, preferences_.now().units);
}

void UnitButton::choose(const Unit& unit) {
    DisplayUnits stated = document_.project().results.style.units, preferred = preferences_.now().units;
    if (has_unit(stated, unit.dimension())) {
        stated.choose(unit);
        return state(tr("Change unit of results"), stated);
    }
    preferred.choose(unit);
    prefer(std::move(preferred));
}

void UnitButton::clear() {
    if (!document_.project().results.style.units.chosen().empty()) state(tr("Clear units of results"), {});
    prefer({});
}

void UnitButton::state(const QString& words, const DisplayUnits& units) {
    document_.apply(words, [&](Project& project) { project.results.style.units = units; });
}

void UnitButton::prefer(DisplayUnits units) {
    Preferences wanted = preferences_.now();
    wanted.units = std::move(units);
    preferences_.set(wanted);
}

}  // namespace covaria::ui
