// check_setup: every problem of a set-up in words, with the place.
#include <cmath>
#include <limits>

#include "core/base/in_quotes.h"
#include "core/setup/message_text.h"
#include "core/setup/setup_schema.h"

namespace covaria {

namespace {

// Figures beyond this are refused: squares and sums of squares of what is below it stay finite numbers.
constexpr double largest_figure = 1e100;

// What one field or one column of a table asks of a value.
struct Demand {
    std::string title;
    FieldKind kind;
    const Unit& unit;
    const Range& range;
    const std::vector<Choice>& choices;
    bool infinity_allowed = false;
};

std::string range_words(const Demand& demand) {
    const bool below = std::isfinite(demand.range.low), above = std::isfinite(demand.range.high);
    const auto words = [&](double si) { return quantity_words(demand.unit.from_si(si), demand.unit); };
    const std::string low = words(demand.range.low), high = words(demand.range.high);
    if (below && above)
        return demand.range.low_open ? "greater than " + low + " and at most " + high
                                     : "between " + low + " and " + high;
    if (below) return (demand.range.low_open ? "greater than " : "at least ") + low;
    return "at most " + high;
}

std::string number_objection(const Demand& demand, const Quantity& given) {
    if (std::isinf(given.value) && demand.infinity_allowed) return {};
    if (std::string objection = unit_objection(demand.title, given, demand.unit); !objection.empty())
        return objection;
    if (demand.kind == FieldKind::integer && given.value != std::round(given.value))
        return in_quotes(demand.title) + " must be a whole number; it is " + readable_number(given.value);
    if (demand.kind == FieldKind::integer && std::abs(given.value) > std::numeric_limits<int>::max())
        return in_quotes(demand.title) + " is too large a number: " + readable_number(given.value);
    const double si = given.si();
    const bool too_low = demand.range.low_open ? si <= demand.range.low : si < demand.range.low;
    if (!too_low && si <= demand.range.high) return {};
    return in_quotes(demand.title) + " must be " + range_words(demand) + "; it is " +
           quantity_words(given.value, given.unit);
}

std::string choice_objection(const Demand& demand, const std::string& given) {
    std::vector<std::string> keys;
    for (const Choice& choice : demand.choices) {
        if (choice.key == given) return {};
        keys.push_back(choice.key);
    }
    return in_quotes(demand.title) + " must be one of " + listed(keys) + "; it is " + in_quotes(given) +
           did_you_mean(given, keys);
}

std::string kind_words(FieldKind kind) {
    switch (kind) {
        case FieldKind::number:
            return "a number";
        case FieldKind::integer:
            return "a whole number";
        case FieldKind::choice:
            return "one of its choices";
        case FieldKind::text:
            return "a text";
        case FieldKind::flag:
            return "true or false";
        case FieldKind::pose:
            return "a pose";
        case FieldKind::table:
            return "a table";
        case FieldKind::reference:
            return "the id of an asset";
    }
    return {};
}

std::string wrong_kind(const Demand& demand) {
    return in_quotes(demand.title) + " must be " + kind_words(demand.kind);
}

bool is_numeric(FieldKind kind) {
    return kind == FieldKind::number || kind == FieldKind::integer;
}

std::string text_objection(const Demand& demand, const std::string& given) {
    if (demand.kind == FieldKind::choice) return choice_objection(demand, given);
    const bool is_text = demand.kind == FieldKind::text || demand.kind == FieldKind::reference;
    return is_text ? std::string{} : wrong_kind(demand);
}

std::string pose_objection(const FieldSpec& field, const PoseValue& pose) {
    for (std::size_t i = 0; i < 3; ++i) {
        static const Unit metre = Unit::of("m"), radian = Unit::of("rad");
        std::string objection = unit_objection(field.title, {pose.position[i], pose.length_unit}, metre);
        if (objection.empty())
            objection = unit_objection(field.title, {pose.angles[i], pose.angle_unit}, radian);
        if (!objection.empty()) return objection;
    }
    return {};
}

class TableCheck {
public:
    TableCheck(const FieldSpec& field, const SetupTable& table, Problems& problems)
        : field_(field), table_(table), problems_(problems) {}

    void run() {
        const std::string place = "/" + field_.key;
        if (table_.rows.size() < field_.min_rows)
            problems_.error(place, in_quotes(field_.title) + " needs at least " +
                                       std::to_string(field_.min_rows) +
                                       (field_.min_rows == 1 ? " row" : " rows") + "; it has " +
                                       std::to_string(table_.rows.size()));
        if (!units_fit(place)) return;
        for (std::size_t row = 0; row < table_.rows.size(); ++row) check_row(row);
    }

private:
    bool units_fit(const std::string& place) {
        if (table_.units.size() != field_.columns.size()) {
            if (table_.rows.empty() && table_.units.empty()) return true;
            problems_.error(place + "/columns", in_quotes(field_.title) + " has " +
                                                    std::to_string(field_.columns.size()) + " columns, but " +
                                                    std::to_string(table_.units.size()) + " units");
            return false;
        }
        bool fit = true;
        for (std::size_t i = 0; i < table_.units.size(); ++i) {
            const ColumnSpec& column = field_.columns[i];
            if (!is_numeric(column.kind)) continue;
            const std::string objection = column_unit_objection(field_, column, table_.units[i]);
            if (objection.empty()) continue;
            problems_.error(place + "/columns", objection);
            fit = false;
        }
        return fit;
    }

    void check_row(std::size_t row) {
        const std::string place = "/" + field_.key + "/rows/" + std::to_string(row);
        const auto& cells = table_.rows[row];
        if (cells.size() > field_.columns.size())
            problems_.error(place, "row " + std::to_string(row + 1) + " of " + in_quotes(field_.title) +
                                       " has " + std::to_string(cells.size()) + " cells; there are " +
                                       std::to_string(field_.columns.size()) + " columns");
        for (std::size_t i = 0; i < field_.columns.size(); ++i) {
            const std::string objection = cell_objection(row, i, i < cells.size() ? cells[i] : SetupCell{});
            if (!objection.empty()) problems_.error(place + "/" + field_.columns[i].key, objection);
        }
    }

    std::string cell_objection(std::size_t row, std::size_t i, const SetupCell& cell) const {
        const ColumnSpec& column = field_.columns[i];
        const std::string name = column.title.empty() ? column.key : column.title;
        const Demand demand{name + " in row " + std::to_string(row + 1) + " of " + field_.title, column.kind,
                            column.unit, column.range, column.choices};
        if (std::holds_alternative<std::monostate>(cell))
            return column.optional || column.kind == FieldKind::flag ? std::string{}
                                                                     : in_quotes(demand.title) + " is empty";
        if (const double* number = std::get_if<double>(&cell))
            return is_numeric(column.kind) ? number_objection(demand, {*number, table_.units[i]})
                                           : wrong_kind(demand);
        if (const std::string* text = std::get_if<std::string>(&cell)) return text_objection(demand, *text);
        return column.kind == FieldKind::flag ? std::string{} : wrong_kind(demand);
    }

    const FieldSpec& field_;
    const SetupTable& table_;
    Problems& problems_;
};

// Asked of a value that is there.
std::string value_objection(const FieldSpec& field, const SetupValue& value) {
    const Quantity* default_number = std::get_if<Quantity>(&field.default_value);
    const bool infinity_allowed = default_number && std::isinf(default_number->value);
    const Demand demand{field.title, field.kind, field.unit, field.range, field.choices, infinity_allowed};
    if (const Quantity* number = std::get_if<Quantity>(&value))
        return is_numeric(field.kind) ? number_objection(demand, *number) : wrong_kind(demand);
    if (const std::string* text = std::get_if<std::string>(&value)) {
        const bool may_be_empty =
            field.optional || field.kind == FieldKind::choice || value == field.default_value;
        if (text->empty() && !may_be_empty) return in_quotes(field.title) + " must not be empty";
        return text_objection(demand, *text);
    }
    if (const PoseValue* pose = std::get_if<PoseValue>(&value))
        return field.kind == FieldKind::pose ? pose_objection(field, *pose) : wrong_kind(demand);
    const bool right_kind =
        std::holds_alternative<bool>(value) ? field.kind == FieldKind::flag : field.kind == FieldKind::table;
    return right_kind ? std::string{} : wrong_kind(demand);
}

void check_field(const FieldSpec& field, const SetupValue& value, Problems& problems) {
    if (std::holds_alternative<std::monostate>(value)) {
        if (!field.optional)
            problems.error("/" + field.key,
                           in_quotes(field.title) + " must be given ('" + field.key + "' is missing)");
        return;
    }
    if (const std::string objection = value_objection(field, value); !objection.empty())
        problems.error("/" + field.key, objection);
    else if (const SetupTable* table = std::get_if<SetupTable>(&value))
        TableCheck(field, *table, problems).run();
}

}  // namespace

std::string unit_objection(const std::string& title, const Quantity& given, const Unit& expected) {
    if (std::isnan(given.value) || std::isinf(given.value))
        return in_quotes(title) + " must be a finite number; it is " + readable_number(given.value);
    if (std::abs(given.value) > largest_figure || std::abs(given.si()) > largest_figure)
        return in_quotes(title) + " is too large to be computed with (at most 1e100): it is " +
               readable_number(given.value);
    if (given.unit.dimension() != expected.dimension()) {
        const std::string words =
            given.unit.dimension().is_one() ? "has no unit" : "is " + dimension_words(given.unit);
        return in_quotes(title) + " is " + dimension_words(expected) + "; " +
               in_quotes(quantity_words(given.value, given.unit)) + " " + words;
    }
    if (given.unit.has_offset() && !expected.has_offset())
        return in_quotes(title) + " is a difference of temperatures: give it in K, not in " +
               given.unit.text();
    return {};
}

std::string column_unit_objection(const FieldSpec& table, const ColumnSpec& column, const Unit& unit) {
    const std::string name = "column '" + column.key + "' of '" + table.title + "' is ";
    if (unit.dimension() != column.unit.dimension()) {
        if (unit == Unit{})
            return name + dimension_words(column.unit) + "; its unit is missing: write \"" + column.key +
                   " [" + column.unit.text() + "]\"";
        return name + dimension_words(column.unit) + "; '" + unit.text() + "' is the unit of " +
               dimension_words(unit);
    }
    if (unit.has_offset() && !column.unit.has_offset())
        return name + "a difference of temperatures: give it in K, not in " + unit.text();
    return {};
}

void check_setup(const SetupSchema& schema, const Setup& setup, Problems& problems) {
    for (const auto& [key, value] : setup.values)
        if (!schema.find(key))
            problems.error("/" + key,
                           "there is no field '" + key + "' here" + did_you_mean(key, schema.keys()));
    for (const FieldSpec& field : schema.fields())
        if (is_shown(schema, field, setup)) check_field(field, value_of(field, setup), problems);
}

}  // namespace covaria
