#include "core/setup/shared_decimals.h"

#include <map>
#include <string>
#include <utility>

#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/text/written_out.h"

namespace covaria {
namespace {

std::string text_at(const std::vector<SetupCell>& row, std::size_t column) {
    const auto* text = column < row.size() ? std::get_if<std::string>(&row[column]) : nullptr;
    return text ? *text : std::string();
}

}  // namespace

std::vector<int> shared_decimals(const FieldSpec& field, const SetupTable& table, std::size_t column) {
    if (column >= field.columns.size()) return {};
    const bool observed = field.columns[column].observed,
               of_one_kind = field.measured && field.columns[column].kind == FieldKind::number &&
                             SetupSchema::column(field, "unit") >= field.columns.size();
    if (!observed && !of_one_kind) return {};
    const std::size_t quantity = SetupSchema::column(field, "quantity"),
                      series = SetupSchema::column(field, "series");
    struct Series {
        std::vector<double> values;
        std::vector<std::size_t> rows;
    };
    std::map<std::pair<std::string, std::string>, Series> all;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& row = table.rows[i];
        const auto* value = column < row.size() ? std::get_if<double>(&row[column]) : nullptr;
        if (!value) continue;
        Series& of = observed ? all[{plain_symbol(text_at(row, quantity)), text_at(row, series)}] : all[{}];
        of.values.push_back(*value);
        of.rows.push_back(i);
    }
    std::vector<int> decimals(table.rows.size(), -1);
    for (const auto& [name, of] : all) {
        int common = common_decimals(of.values);
        if (!observed && common > most_shared_decimals) common = -1;
        for (const std::size_t row : of.rows) decimals[row] = common;
    }
    return decimals;
}

}  // namespace covaria
