#include "ui/document/observation_edits.h"

#include <QString>
#include <algorithm>

#include "core/text/symbol.h"
#include "ui/document/setup_cells.h"

namespace covaria::ui {
namespace {

struct Columns {
    std::size_t quantity, number, series, value, weight;
    explicit Columns(const FieldSpec& table)
        : quantity(SetupSchema::column(table, "quantity")),
          number(SetupSchema::column(table, "number")),
          series(SetupSchema::column(table, "series")),
          value(SetupSchema::column(table, "value")),
          weight(SetupSchema::column(table, "weight")) {}
};

std::string text_in(const SetupCell& cell) {
    const auto* text = std::get_if<std::string>(&cell);
    return text ? *text : std::string();
}

/// Rows of the series without a name, or of the only one there is.
std::vector<std::size_t> rows_of(const SetupTable& table, const Columns& at, const std::string& symbol) {
    std::vector<std::size_t> unnamed, named;
    std::string name;
    bool one = true;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& row = table.rows[i];
        if (plain_symbol(text_in(row[at.quantity])) != symbol) continue;
        const std::string series = text_in(row[at.series]);
        if (series.empty()) {
            unnamed.push_back(i);
            continue;
        }
        one = one && (name.empty() || name == series);
        name = series;
        named.push_back(i);
    }
    return unnamed.empty() && one ? named : unnamed;
}

}  // namespace

const FieldSpec* observing_table(const Project& project, const SetupAddress& address) {
    const SetupSchema* schema = find_schema(project, address);
    return schema ? schema->find(&FieldSpec::observes_quantities) : nullptr;
}

namespace {

std::vector<double> numbers_in(const Project& project, const SetupAddress& address, const std::string& symbol,
                               std::size_t Columns::*column) {
    const FieldSpec* field = observing_table(project, address);
    const Setup* setup = find_setup(project, address);
    std::vector<double> numbers;
    if (!field || !setup) return numbers;
    const SetupTable table = table_of(*field, *setup);
    const Columns at(*field);
    for (const std::size_t row : rows_of(table, at, symbol))
        if (const auto* number = std::get_if<double>(&table.rows[row][at.*column]))
            numbers.push_back(*number);
    return numbers;
}

}  // namespace

std::vector<double> observations_of(const Project& project, const SetupAddress& address,
                                    const std::string& symbol) {
    return numbers_in(project, address, symbol, &Columns::value);
}

std::vector<double> weights_of(const Project& project, const SetupAddress& address,
                               const std::string& symbol) {
    return numbers_in(project, address, symbol, &Columns::weight);
}

bool is_listed(const std::string& statement) {
    return statement == "observations" || statement == "sample" || statement == "histogram";
}

std::optional<double> listed_mean(const Project& project, const SetupAddress& address,
                                  const std::string& symbol) {
    const std::vector<double> values = observations_of(project, address, symbol);
    const std::vector<double> weights = weights_of(project, address, symbol);
    const bool cells = !weights.empty() && weights.size() + 1 == values.size();
    double sum = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < values.size() && (!cells || i < weights.size()); ++i) {
        const double weight = i < weights.size() ? weights[i] : 1.0;
        sum += weight * (cells ? 0.5 * (values[i] + values[i + 1]) : values[i]);
        whole += weight;
    }
    if (!(whole > 0.0)) return std::nullopt;
    return QString::number(sum / whole, 'g', 12).toDouble();
}

void set_observations(Project& project, const SetupAddress& address, const std::string& symbol,
                      const std::vector<double>& values, const std::vector<double>& weights) {
    const FieldSpec* field = observing_table(project, address);
    Setup* setup = find_setup(project, address);
    if (!field || !setup) return;
    SetupTable table = table_of(*field, *setup);
    const Columns at(*field);
    const std::vector<std::size_t> old = rows_of(table, at, symbol);
    std::vector<SetupCell> like;
    for (const ColumnSpec& column : field->columns) like.push_back(empty_cell(column));
    like[at.quantity] = symbol;
    if (!old.empty()) like[at.series] = table.rows[old.front()][at.series];
    std::vector<std::vector<SetupCell>> rows(values.size(), like);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (old.size() == values.size()) rows[i] = table.rows[old[i]];
        rows[i][at.value] = values[i];
        rows[i][at.weight] =
            i < weights.size() ? SetupCell(weights[i]) : empty_cell(field->columns[at.weight]);
    }
    const std::size_t place = old.empty() ? table.rows.size() : old.front();
    for (auto row = old.rbegin(); row != old.rend(); ++row)
        table.rows.erase(table.rows.begin() + static_cast<std::ptrdiff_t>(*row));
    table.rows.insert(table.rows.begin() + static_cast<std::ptrdiff_t>(place), rows.begin(), rows.end());
    setup->values[field->key] = std::move(table);
}

std::string file_of_observations(const Project& project, const SetupAddress& address) {
    const FieldSpec* field = observing_table(project, address);
    const Setup* setup = find_setup(project, address);
    return field && setup ? table_of(*field, *setup).csv_file : std::string();
}

}  // namespace covaria::ui
