#include "ui/models/budget_foot_model.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <cmath>

#include "core/text/cell.h"
#include "core/text/symbol.h"
#include "core/views/result_columns.h"
#include "core/views/result_statement.h"
#include "ui/models/budget_sheet_model.h"
#include "ui/models/roles.h"
#include "ui/models/sheet_figures.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

using Sheet = BudgetSheetModel;

constexpr const char* combined = "combined u";

bool is_number(int section) {
    return section == Sheet::estimate || section == Sheet::nu || section == Sheet::u ||
           section == Sheet::contribution || section == Sheet::share;
}

}  // namespace

void BudgetFootModel::set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output,
                                 bool current, const DisplayUnits& units, int digits) {
    beginResetModel();
    if (result && output >= result->budget.rows.size()) result.reset();
    result_ = std::move(result);
    output_ = output;
    current_ = current;
    units_ = units;
    digits_ = digits;
    table_ = {};
    if (result_) {
        const OutputResult& of = result_->outputs[output_];
        const Unit& unit = of.quantity.unit;
        const double u = of.first_order.standard_uncertainty;
        units_of_contributions_ = units_of_contributions(of, units);
        table_ = results_table(*result_, {output_});
        table_
            .add(combined, Cells([u, unit](std::size_t) -> Cell {
                     return Measured{u, Measured::Scale::interval, unit};
                 }))
            .uncertainty()
            .of_row({"estimate", combined});
    }
    endResetModel();
}

int BudgetFootModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !result_ ? 0 : 1;
}

int BudgetFootModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Sheet::sections;
}

/// "U = 61 nm, k = 1.97"; the interval where the result is stated by it.
Text BudgetFootModel::stated() const {
    const OutputResult& of = result_->outputs[output_];
    const DocumentLanguage in = language_of_window();
    if (is_stated_by_interval(of, *result_)) return skewed_interval(of, *result_, in, units_, digits_);
    if (!(of.expanded_uncertainty > 0.0) || !std::isfinite(of.coverage_factor)) return {};
    const TableView view{units_of_contributions_, digits_, in};
    const Unit unit = units_of_contributions_.of(of.quantity.unit).interval();
    return symbol_text("U") + " = " + written(table_, table_["U"], 0, view) + unit_after_number(unit) + ", " +
           symbol_text("k") + " = " + written(table_, table_["k"], 0, view);
}

Text BudgetFootModel::text_of(int section) const {
    const OutputResult& of = result_->outputs[output_];
    const TableView view{units_, digits_, language_of_window()};
    switch (section) {
        case Sheet::symbol:
            return symbol_text(of.quantity.symbol);
        case Sheet::name:
            return written(table_, table_["name"], 0, view);
        case Sheet::estimate:
            return written(table_, table_["estimate"], 0, view);
        case Sheet::unit:
            return written(table_, table_["unit"], 0, view);
        case Sheet::stated:
            return stated();
        case Sheet::nu:
            return written(table_, table_["nu_eff"], 0, view);
        case Sheet::u:
            return written(table_, table_[combined], 0, view);
        case Sheet::contribution:
            return written(table_, table_[combined], 0,
                           {units_of_contributions_, digits_, language_of_window()});
        case Sheet::share:
            return of.first_order.standard_uncertainty > 0.0 ? Text("100") : Text();
        case Sheet::source:  // of U: the other columns are about the law of propagation
            return of.monte_carlo ? symbol_text("U") + (": " + to_std(core_text("Monte Carlo"))) : Text();
        default:
            return {};
    }
}

QVariant BudgetFootModel::headerData(int, Qt::Orientation, int) const {
    return {};
}

QVariant BudgetFootModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int section = index.column();
    switch (role) {
        case Qt::DisplayRole:
            return to_qt(to_unicode(text_of(section)));
        case typeset_role:
            return QVariant::fromValue(text_of(section));
        case Qt::FontRole: {
            QFont bold;
            bold.setWeight(QFont::DemiBold);
            return section == Sheet::stated || section == Sheet::unit || section == Sheet::source
                       ? QVariant()
                       : QVariant(bold);
        }
        case Qt::TextAlignmentRole:
            return QVariant((is_number(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return current_ ? QVariant()
                            : QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
        case Qt::ToolTipRole:
            if (!current_) return tr("Out of date: being computed.");
            if (section == Sheet::u || section == Sheet::contribution)
                return tr("Combined standard uncertainty by the law of propagation");
            return section == Sheet::stated ? to_qt(to_unicode(text_of(Sheet::source))) : QVariant();
        default:
            return {};
    }
}

}  // namespace covaria::ui
