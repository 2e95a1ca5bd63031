// Words and selections that the sections of a report share.
#include <algorithm>
#include <cctype>
#include <map>

#include "core/base/file_names.h"
#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "core/report/report_parts.h"
#include "core/report/table_text.h"

namespace covaria::report_parts {

TableBuilder::TableBuilder(std::string id, std::string title) {
    block_.table.id = std::move(id);
    block_.table.title = std::move(title);
}

int TableBuilder::add(TableColumn column, ColumnStyle style) {
    block_.table.columns.push_back(std::move(column));
    block_.styles.push_back(style);
    return static_cast<int>(block_.styles.size()) - 1;
}

int TableBuilder::text(const std::string& header, bool symbol_cells) {
    return add({header, {}, false, 0}, {symbol_cells, false, -1, -1, false});
}

int TableBuilder::number(const std::string& header, int digits, int match) {
    return add({header, {}, false, digits}, {false, true, match, -1, false});
}

int TableBuilder::symbol(const std::string& header, int digits, int match) {
    return add({header, {}, true, digits}, {false, true, match, -1, false});
}

int TableBuilder::fixed(const std::string& header, int decimals) {
    return add({header, {}, looks_like_symbol(header), 0}, {false, true, -1, decimals, false});
}

int TableBuilder::estimate(const std::string& header, bool symbol, int match) {
    return add({header, {}, symbol, 0}, {false, true, match, -1, true});
}

std::string count_text(std::uint64_t count) {
    const std::string digits = std::to_string(count);
    std::string out;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0 && digits.size() > 4) out += "\u00a0";
        out += digits[i];
    }
    return out;
}

std::string percent_text(double probability) {
    TableColumn plain;
    return format_cell(100.0 * probability, plain) + "\u00a0%";
}

std::string unit_text(const Unit& unit) {
    return unit.text() == "1" ? "1" : unit.display();
}

std::string file_name_part(const std::string& text) {
    std::string out = covaria::file_name_part(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

std::string short_list(const std::vector<std::string>& items, std::size_t most) {
    std::string out;
    const bool whole = items.size() <= most;
    const std::size_t shown = whole ? items.size() : most - 1;
    for (std::size_t i = 0; i < shown; ++i) out += (i ? ", " : "") + items[i];
    return whole ? out : out + " … " + items.back() + " (" + std::to_string(items.size()) + ")";
}

std::string output_label(const OutputQuantity& quantity) {
    const std::string symbol = symbol_to_unicode(quantity.symbol);
    return quantity.group.empty() ? symbol : symbol + " (" + quantity.group + ")";
}

Quantity value_in(const Unit& unit, double si) {
    return {unit.from_si(si), unit};
}

Quantity interval_in(const Unit& unit, double si) {
    return {unit.interval_from_si(si), unit};
}

std::string contributor_title(const ContributorResult& result) {
    return result.contributor.empty() ? "the set-up" : result.contributor;
}

bool is_measurand(const OutputResult& output) {
    return output.quantity.role == OutputRole::measurand;
}

std::vector<std::string> measurand_groups(const UncertaintyResult& result) {
    std::vector<std::string> groups;
    for (const OutputResult& output : result.outputs)
        if (is_measurand(output) &&
            std::find(groups.begin(), groups.end(), output.quantity.group) == groups.end())
            groups.push_back(output.quantity.group);
    return groups;
}

std::vector<std::size_t> measurands_of(const UncertaintyResult& result, const std::string& group) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i]) && result.outputs[i].quantity.group == group)
            indices.push_back(i);
    return indices;
}

bool groups_alike(const UncertaintyResult& result, const std::vector<std::string>& groups) {
    const auto quantities = [&result](const std::string& group) {
        std::vector<std::pair<std::string, std::string>> list;
        for (const std::size_t i : measurands_of(result, group))
            list.emplace_back(result.outputs[i].quantity.symbol, result.outputs[i].quantity.unit.text());
        return list;
    };
    return std::all_of(groups.begin(), groups.end(), [&](const std::string& group) {
        return quantities(group) == quantities(groups.front());
    });
}

std::vector<std::string> groups_in_full(const UncertaintyResult& result) {
    const std::vector<std::string> groups = measurand_groups(result);
    if (groups.size() <= 2) return groups;
    std::map<std::string, double> sum_of_symbol;
    for (const OutputResult& output : result.outputs)
        if (is_measurand(output)) sum_of_symbol[output.quantity.symbol] += output.expanded_uncertainty;
    const auto weight = [&](const std::string& group) {
        double sum = 0.0;
        for (const std::size_t i : measurands_of(result, group)) {
            const double whole = sum_of_symbol[result.outputs[i].quantity.symbol];
            if (whole > 0.0) sum += result.outputs[i].expanded_uncertainty / whole;
        }
        return sum;
    };
    return {*std::max_element(groups.begin(), groups.end(),
                              [&](const auto& a, const auto& b) { return weight(a) < weight(b); })};
}

}  // namespace covaria::report_parts
