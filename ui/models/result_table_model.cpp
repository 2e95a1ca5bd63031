// Every number is rounded by its uncertainty, in the chosen unit.
#include "ui/models/result_table_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "core/result/result_line.h"
#include "ui/models/number_words.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void ResultTableModel::set_result(std::shared_ptr<const UncertaintyResult> result, bool current) {
    result_ = std::move(result);
    current_result_ = current;
    rebuild();
}

void ResultTableModel::set_group(const std::string& group) {
    group_ = group;
    rebuild();
}

void ResultTableModel::set_units(const DisplayUnits& units) {
    units_ = units;
    rebuild();
}

void ResultTableModel::set_digits(int digits) {
    digits_ = digits;
    rebuild();
}

void ResultTableModel::set_interval(Interval interval) {
    interval_ = interval;
    rebuild();
}

int ResultTableModel::row_of(std::size_t output_index) const {
    const auto found = std::find(shown_.begin(), shown_.end(), output_index);
    return found == shown_.end() ? -1 : static_cast<int>(found - shown_.begin());
}

void ResultTableModel::rebuild() {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; result_ && i < result_->outputs.size(); ++i)
        if (group_.empty() || result_->outputs[i].quantity.group == group_) shown.push_back(i);
    shown_ = std::move(shown);
    std::vector<Column> columns;
    if (result_) {
        add_quantity_columns(columns);
        add_result_columns(columns);
        add_contributor_columns(columns);
        add_first_order_columns(columns);
    }
    set_contents(std::move(columns), shown_.size(), current_result_);
}

QString ResultTableModel::value_text(std::size_t row, double value, double uncertainty) const {
    return localized(
        format_to_match(unit(row).from_si(value), unit(row).interval_from_si(uncertainty), digits_));
}

QString ResultTableModel::uncertainty_text(std::size_t row, double uncertainty) const {
    if (!std::isfinite(uncertainty)) return QStringLiteral("∞");
    return localized(format_significant(unit(row).interval_from_si(uncertainty), digits_));
}

std::optional<CoverageInterval> ResultTableModel::interval_of(std::size_t row) const {
    const auto& monte_carlo = output(row).monte_carlo;
    if (!monte_carlo) return std::nullopt;
    return interval_ == Interval::symmetric ? monte_carlo->symmetric : monte_carlo->shortest;
}

void ResultTableModel::add_quantity_columns(std::vector<Column>& columns) const {
    const auto quantity = [this](std::size_t row) -> const OutputQuantity& { return output(row).quantity; };
    columns.push_back({tr("Group"), tr("The pose, point or target the quantity belongs to"),
                       [quantity](std::size_t row) { return to_qt(quantity(row).group); }});
    columns.push_back({tr("Symbol"), {}, [quantity](std::size_t row) {
                           return to_qt(symbol_to_unicode(quantity(row).symbol));
                       }});
    columns.push_back(
        {tr("Output quantity"), {}, [quantity](std::size_t row) { return to_qt(quantity(row).name); }});
    columns.push_back({tr("Unit"), {}, [this](std::size_t row) { return to_qt(unit(row).display()); }});
}

void ResultTableModel::add_result_columns(std::vector<Column>& columns) const {
    columns.push_back({tr("Estimate"), tr("Best value of the output quantity"),
                       [this](std::size_t row) {
                           return value_text(row, output(row).estimate, output(row).standard_uncertainty);
                       },
                       [this](std::size_t row) { return output(row).estimate; }});
    columns.push_back(
        {QStringLiteral("u"), tr("Standard uncertainty"),
         [this](std::size_t row) { return uncertainty_text(row, output(row).standard_uncertainty); },
         [this](std::size_t row) { return output(row).standard_uncertainty; }});
    columns.push_back(
        {QStringLiteral("U"), tr("Expanded uncertainty. %1").arg(to_qt(expanded_words(*result_))),
         [this](std::size_t row) { return uncertainty_text(row, output(row).expanded_uncertainty); },
         [this](std::size_t row) { return output(row).expanded_uncertainty; }});
    columns.push_back(
        {QStringLiteral("k"), tr("Coverage factor. %1").arg(to_qt(expanded_words(*result_))),
         [this](std::size_t row) { return localized(format_decimals(output(row).coverage_factor, 2)); },
         [this](std::size_t row) { return output(row).coverage_factor; }});
    columns.push_back(
        {to_qt(symbol_to_unicode("nu_eff")), tr("Effective degrees of freedom (JCGM 100 G.4)"),
         [this](std::size_t row) {
             return degrees_of_freedom_text(output(row).first_order.effective_degrees_of_freedom);
         },
         [this](std::size_t row) { return output(row).first_order.effective_degrees_of_freedom; }});
    const auto limit = [this](double CoverageInterval::*side) {
        return [this, side](std::size_t row) {
            const auto interval = interval_of(row);
            return interval ? (*interval).*side : std::nan("");
        };
    };
    const auto limit_text = [this, limit](double CoverageInterval::*side) {
        return [this, number = limit(side)](std::size_t row) {
            const double value = number(row);
            return std::isnan(value) ? QString() : value_text(row, value, output(row).standard_uncertainty);
        };
    };
    const QString help = interval_ == Interval::symmetric
                             ? tr("Limit of the probabilistically symmetric coverage interval")
                             : tr("Limit of the shortest coverage interval");
    columns.push_back({tr("Low"), help, limit_text(&CoverageInterval::low), limit(&CoverageInterval::low)});
    columns.push_back(
        {tr("High"), help, limit_text(&CoverageInterval::high), limit(&CoverageInterval::high)});
}

void ResultTableModel::add_contributor_columns(std::vector<Column>& columns) const {
    constexpr std::size_t most = 6;  // a network of many instruments would fill the table
    if (result_->contributors.size() > most) return;
    for (std::size_t i = 0; i < result_->contributors.size(); ++i) {
        const std::string& contributor = result_->contributors[i].contributor;
        const QString name = contributor.empty() ? tr("set-up") : to_qt(contributor);
        const auto remaining = [this, i](std::size_t row) {
            return expanded_with(output(row), result_->contributors[i].without, shown_[row]);
        };
        columns.push_back(
            {tr("U, %1 held").arg(name),
             tr("Expanded uncertainty that remains when everything %1 brings in is held (an ideal one), %2")
                 .arg(name, result_->contributor_trials > 0 ? tr("by Monte Carlo")
                                                            : tr("by the law of propagation")),
             [this, remaining](std::size_t row) { return uncertainty_text(row, remaining(row)); },
             remaining});
    }
}

void ResultTableModel::add_first_order_columns(std::vector<Column>& columns) const {
    const auto first = [this](std::size_t row) -> const FirstOrderOutput& { return output(row).first_order; };
    columns.push_back({tr("Estimate (first order)"), tr("By the law of propagation of uncertainty"),
                       [this, first](std::size_t row) {
                           return value_text(row, first(row).estimate, first(row).standard_uncertainty);
                       },
                       [first](std::size_t row) { return first(row).estimate; }});
    columns.push_back(
        {tr("u (first order)"), tr("By the law of propagation of uncertainty"),
         [this, first](std::size_t row) { return uncertainty_text(row, first(row).standard_uncertainty); },
         [first](std::size_t row) { return first(row).standard_uncertainty; }});
    columns.push_back(
        {tr("U (first order)"), tr("By the law of propagation of uncertainty"),
         [this, first](std::size_t row) { return uncertainty_text(row, first(row).expanded_uncertainty); },
         [first](std::size_t row) { return first(row).expanded_uncertainty; }});
    add_second_order_columns(columns);
    columns.push_back({tr("First order validated"),
                       tr("JCGM 101 clause 8: agrees with Monte Carlo within the tolerance"),
                       [first](std::size_t row) {
                           const auto& validation = first(row).validation;
                           if (!validation) return QString();
                           return validation->validated ? tr("yes") : tr("no");
                       }});
}

void ResultTableModel::add_second_order_columns(std::vector<Column>& columns) const {
    using Member = std::optional<double> FirstOrderOutput::*;
    const auto add = [&](const QString& title, const QString& help, Member member) {
        const auto value = [this, member](std::size_t row) {
            return (output(row).first_order.*member).value_or(std::nan(""));
        };
        columns.push_back({title, help,
                           [this, value](std::size_t row) {
                               return std::isnan(value(row)) ? QString() : uncertainty_text(row, value(row));
                           },
                           value});
    };
    const bool any = std::any_of(shown_.begin(), shown_.end(), [this](std::size_t j) {
        return result_->outputs[j].first_order.second_order_standard_uncertainty.has_value();
    });
    if (!any) return;
    add(tr("u (second order)"), tr("With the second-order terms of JCGM 100 5.1.2; for information"),
        &FirstOrderOutput::second_order_standard_uncertainty);
    add(tr("shift (second order)"),
        tr("What the curvature of the equation adds to the estimate; for information, not added"),
        &FirstOrderOutput::second_order_estimate_shift);
}

QVariant ResultTableModel::extra(std::size_t row, std::size_t, int role) const {
    const OutputQuantity& quantity = output(row).quantity;
    if (role == group_role) return to_qt(quantity.group);
    if (role == id_role) return to_qt(quantity.symbol);
    if (role == index_role) return static_cast<qulonglong>(shown_[row]);
    if (role == Qt::ToolTipRole && output(row).monte_carlo)
        return to_qt(output(row).monte_carlo->normality.words);
    return {};
}

}  // namespace covaria::ui
