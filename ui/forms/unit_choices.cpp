#include "ui/forms/unit_choices.h"

#include <QComboBox>
#include <QFormLayout>
#include <algorithm>
#include <tuple>

#include "ui/theme/strings.h"

namespace covaria::ui {

UnitChoices::UnitChoices(QFormLayout& form, const QString& none, const QString& help, QObject* parent)
    : QObject(parent) {
    const std::tuple<const char*, const char*, QString> dimensions[] = {{"lengths", "m", tr("Lengths")},
                                                                        {"angles", "rad", tr("Angles")},
                                                                        {"forces", "N", tr("Forces")},
                                                                        {"moments", "N*m", tr("Moments")}};
    for (const auto& [name, text, title] : dimensions) {
        auto* box = new QComboBox;
        box->setObjectName(QString::fromLatin1(name));
        box->setAccessibleName(title);
        box->setToolTip(help);
        box->addItem(none, QString());
        const Unit unit = Unit::of(text);
        for (const Unit& choice : DisplayUnits::choices(unit))
            box->addItem(to_qt(choice.display()), to_qt(choice.text()));
        form.addRow(title, box);
        rows_.push_back({box, unit});
        connect(box, &QComboBox::activated, this, &UnitChoices::edited);
    }
}

DisplayUnits UnitChoices::units() const {
    DisplayUnits chosen = others_;
    for (const Row& row : rows_)
        if (const QString text = row.box->currentData().toString(); !text.isEmpty())
            chosen.choose(Unit::of(text.toUtf8().constData()));
    return chosen;
}

void UnitChoices::set_units(const DisplayUnits& units) {
    others_.clear();
    for (const Unit& unit : units.chosen()) {
        const auto of_row = [&](const Row& row) { return row.unit.dimension() == unit.dimension(); };
        if (std::none_of(rows_.begin(), rows_.end(), of_row)) others_.choose(unit);
    }
    for (const Row& row : rows_) {
        const QString shown =
            has_unit(units, row.unit.dimension()) ? to_qt(units.of(row.unit).text()) : QString();
        if (row.box->findData(shown) < 0)  // "km", which is not among the usual ones
            row.box->addItem(to_qt(units.of(row.unit).display()), shown);
        row.box->setCurrentIndex(row.box->findData(shown));
    }
}

}  // namespace covaria::ui
