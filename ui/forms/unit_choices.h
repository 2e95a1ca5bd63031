// A list of units for each usual dimension: of lengths, angles, forces and moments.
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "core/result/result_style.h"

class QComboBox;
class QFormLayout;

namespace covaria::ui {

class UnitChoices : public QObject {
    Q_OBJECT
public:
    /// Adds its rows to a form. `none`: the entry that chooses no unit.
    UnitChoices(QFormLayout& form, const QString& none, const QString& help, QObject* parent);

    /// The chosen units, and those that `set_units` had of other dimensions.
    DisplayUnits units() const;
    void set_units(const DisplayUnits& units);

signals:
    void edited();

private:
    struct Row {
        QComboBox* box;
        Unit unit;  ///< stands for its dimension
    };
    std::vector<Row> rows_;
    DisplayUnits others_;
};

}  // namespace covaria::ui
