// check_setup: every problem of a set-up in words, with the place.
#include <cmath>
#include <limits>

#include "core/base/in_quotes.h"
#include "core/base/temperature.h"
#include "core/setup/column_words.h"
#include "core/setup/difference_remedy.h"
#include "core/setup/message_text.h"
#include "core/setup/setup_schema.h"

namespace covaria {

namespace {

// Figures beyond this are refused: squares and sums of squares of what is below it stay finite numbers.
constexpr double largest_figure = 1e100;

// Demands of one field or one column of a table on a value.
struct Demand {
    const std::string& name;
    FieldKind kind;
    const Unit& unit;
    const Range& range;
    const std::vector<Choice>& choices;
    bool infinity_allowed = false;
    const FieldSpec* table = nullptr;  // table of a cell
    std::size_t row = 0;

    // Only of what is wrong: tables have a hundred thousand cells.
    Message title() const {
        const Message words = Message::declared(name);
        return table ? tell<"%1 in row %2 of %3">(words, row + 1, Message::declared(table->title)) : words;
    }
};

template <class Title>
Message unit_problem(const Title& title, const Quantity& given, const Unit& expected) {
    if (std::isnan(given.value) || std::isinf(given.value))
        return tell<"%1 must be a finite number; it is %2">(in_quotes(title()), readable_number(given.value));
    if (std::abs(given.value) > largest_figure || std::abs(given.si()) > largest_figure)
        return tell<"%1 is too large to be computed with (at most 1e100): it is %2">(
            in_quotes(title()), readable_number(given.value));
    if (given.unit.dimension() != expected.dimension()) {
        const std::string value = in_quotes(quantity_words(given.value, given.unit));
        return given.unit.dimension().is_one()
                   ? tell<"%1 is %2; %3 has no unit">(in_quotes(title()), dimension_words(expected), value)
                   : tell<"%1 is %2; %3 is %4">(in_quotes(title()), dimension_words(expected), value,
                                                dimension_words(given.unit));
    }
    if (is_reading_for_difference(given.unit, expected))
        return tell<"%1 is a difference of temperatures: give it in %2, not in %3">(
            in_quotes(title()), given.unit.interval().display(), given.unit.display());
    return {};
}

Message range_words(const Demand& demand) {
    const bool below = std::isfinite(demand.range.low), above = std::isfinite(demand.range.high);
    const auto words = [&](double si) { return quantity_words(demand.unit.from_si(si), demand.unit); };
    const std::string low = words(demand.range.low), high = words(demand.range.high);
    if (below && above)
        return demand.range.low_open ? tell<"greater than %1 and at most %2">(low, high)
                                     : tell<"between %1 and %2">(low, high);
    if (below) return demand.range.low_open ? tell<"greater than %1">(low) : tell<"at least %1">(low);
    return tell<"at most %1">(high);
}

Message number_objection(const Demand& demand, const Quantity& given) {
    if (std::isinf(given.value) && demand.infinity_allowed) return {};
    if (Message objection = unit_problem([&] { return demand.title(); }, given, demand.unit);
        !objection.empty())
        return objection;
    if (demand.kind == FieldKind::integer && given.value != std::round(given.value))
        return tell<"%1 must be a whole number; it is %2">(in_quotes(demand.title()),
                                                           readable_number(given.value));
    if (demand.kind == FieldKind::integer && std::abs(given.value) > std::numeric_limits<int>::max())
        return tell<"%1 is too large a number: %2">(in_quotes(demand.title()), readable_number(given.value));
    const double si = given.si();
    const bool too_low = demand.range.low_open ? si <= demand.range.low : si < demand.range.low;
    if (!too_low && si <= demand.range.high) return {};
    return tell<"%1 must be %2; it is %3">(in_quotes(demand.title()), range_words(demand),
                                           quantity_words(given.value, given.unit));
}

Message choice_objection(const Demand& demand, const std::string& given) {
    std::vector<std::string> keys;
    for (const Choice& choice : demand.choices) {
        if (choice.key == given) return {};
        keys.push_back(choice.key);
    }
    return tell<"%1 must be one of %2; it is %3%4">(in_quotes(demand.title()), listed(keys), in_quotes(given),
                                                    did_you_mean(given, keys));
}

Message kind_words(FieldKind kind) {
    switch (kind) {
        case FieldKind::number:
            return tell<"a number">();
        case FieldKind::integer:
            return tell<"a whole number">();
        case FieldKind::choice:
            return tell<"one of its choices">();
        case FieldKind::text:
            return tell<"a text">();
        case FieldKind::flag:
            return tell<"true or false">();
        case FieldKind::pose:
            return tell<"a pose">();
        case FieldKind::table:
            return tell<"a table">();
        case FieldKind::reference:
            return tell<"the id of an asset">();
    }
    return {};
}

Message wrong_kind(const Demand& demand) {
    return tell<"%1 must be %2">(in_quotes(demand.title()), kind_words(demand.kind));
}

bool is_numeric(FieldKind kind) {
    return kind == FieldKind::number || kind == FieldKind::integer;
}

Message text_objection(const Demand& demand, const std::string& given) {
    if (demand.kind == FieldKind::choice) return choice_objection(demand, given);
    const bool is_text = demand.kind == FieldKind::text || demand.kind == FieldKind::reference;
    return is_text ? Message{} : wrong_kind(demand);
}

Message pose_objection(const FieldSpec& field, const PoseValue& pose) {
    for (std::size_t i = 0; i < 3; ++i) {
        static const Unit metre = Unit::of("m"), radian = Unit::of("rad");
        Message objection =
            unit_objection(Message::declared(field.title), {pose.position[i], pose.length_unit}, metre);
        if (objection.empty())
            objection =
                unit_objection(Message::declared(field.title), {pose.angles[i], pose.angle_unit}, radian);
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
            problems_.error(place, field_.min_rows == 1 ? tell<"%1 needs at least 1 row; it has %2">(
                                                              title(), table_.rows.size())
                                                        : tell<"%1 needs at least %2 rows; it has %3">(
                                                              title(), field_.min_rows, table_.rows.size()));
        if (!units_fit(place)) return;
        for (std::size_t row = 0; row < table_.rows.size(); ++row) check_row(row);
    }

private:
    Message title() const { return in_quotes(Message::declared(field_.title)); }

    bool units_fit(const std::string& place) {
        if (table_.units.size() != field_.columns.size()) {
            if (table_.rows.empty() && table_.units.empty()) return true;
            problems_.error(place + "/columns", tell<"%1 has %2 columns, but %3 units">(
                                                    title(), field_.columns.size(), table_.units.size()));
            return false;
        }
        bool fit = true;
        for (std::size_t i = 0; i < table_.units.size(); ++i) {
            const ColumnSpec& column = field_.columns[i];
            if (!is_numeric(column.kind)) continue;
            const Message objection = column_unit_objection(field_, column, table_.units[i]);
            if (objection.empty()) continue;
            problems_.error(place + "/columns", objection);
            if (table_.csv_file.empty())  // its head is in the project
                problems_.items().back().remedies = remedies_as_difference(column, table_.units[i], place);
            fit = false;
        }
        return fit;
    }

    void check_row(std::size_t row) {
        const std::string place = "/" + field_.key + "/rows/" + std::to_string(row);
        const auto& cells = table_.rows[row];
        if (cells.size() > field_.columns.size())
            problems_.error(place, tell<"row %1 of %2 has %3 cells; there are %4 columns">(
                                       row + 1, title(), cells.size(), field_.columns.size()));
        for (std::size_t i = 0; i < field_.columns.size(); ++i) {
            const Message objection = cell_objection(row, i, i < cells.size() ? cells[i] : SetupCell{});
            if (!objection.empty()) problems_.error(place + "/" + field_.columns[i].key, objection);
        }
    }

    Message cell_objection(std::size_t row, std::size_t i, const SetupCell& cell) const {
        const ColumnSpec& column = field_.columns[i];
        const Demand demand{.name = column.title.empty() ? column.key : column.title,
                            .kind = column.kind,
                            .unit = column.unit,
                            .range = column.range,
                            .choices = column.choices,
                            .table = &field_,
                            .row = row};
        if (std::holds_alternative<std::monostate>(cell))
            return column.optional || column.kind == FieldKind::flag
                       ? Message{}
                       : tell<"%1 is empty">(in_quotes(demand.title()));
        if (const double* number = std::get_if<double>(&cell))
            return is_numeric(column.kind) ? number_objection(demand, {*number, table_.units[i]})
                                           : wrong_kind(demand);
        if (const std::string* text = std::get_if<std::string>(&cell)) return text_objection(demand, *text);
        return column.kind == FieldKind::flag ? Message{} : wrong_kind(demand);
    }

    const FieldSpec& field_;
    const SetupTable& table_;
    Problems& problems_;
};

// Asked of a value that is there.
Message value_objection(const FieldSpec& field, const SetupValue& value) {
    const Quantity* default_number = std::get_if<Quantity>(&field.default_value);
    const bool infinity_allowed = default_number && std::isinf(default_number->value);
    const Demand demand{field.title, field.kind, field.unit, field.range, field.choices, infinity_allowed};
    if (const Quantity* number = std::get_if<Quantity>(&value))
        return is_numeric(field.kind) ? number_objection(demand, *number) : wrong_kind(demand);
    if (const std::string* text = std::get_if<std::string>(&value)) {
        const bool may_be_empty =
            field.optional || field.kind == FieldKind::choice || value == field.default_value;
        if (text->empty() && !may_be_empty) return tell<"%1 must not be empty">(in_quotes(field.title));
        return text_objection(demand, *text);
    }
    if (const PoseValue* pose = std::get_if<PoseValue>(&value))
        return field.kind == FieldKind::pose ? pose_objection(field, *pose) : wrong_kind(demand);
    const bool right_kind =
        std::holds_alternative<bool>(value) ? field.kind == FieldKind::flag : field.kind == FieldKind::table;
    return right_kind ? Message{} : wrong_kind(demand);
}

void check_field(const FieldSpec& field, const SetupValue& value, Problems& problems) {
    if (std::holds_alternative<std::monostate>(value)) {
        if (!field.optional)
            problems.error("/" + field.key, tell<"%1 must be given ('%2' is missing)">(
                                                in_quotes(Message::declared(field.title)), field.key));
        return;
    }
    if (const Message objection = value_objection(field, value); !objection.empty()) {
        const std::string place = "/" + field.key;
        problems.error(place, objection);
        if (const Quantity* number = std::get_if<Quantity>(&value); number && is_numeric(field.kind))
            problems.items().back().remedies = remedies_as_difference(*number, field.unit, place);
    } else if (const SetupTable* table = std::get_if<SetupTable>(&value))
        TableCheck(field, *table, problems).run();
}

}  // namespace

Message unit_objection(const Message& title, const Quantity& given, const Unit& expected) {
    return unit_problem([&] { return title; }, given, expected);
}

Message column_unit_objection(const FieldSpec& table, const ColumnSpec& column, const Unit& unit) {
    const Message of = Message::declared(table.title);
    const Message title = column_title(column);
    if (unit.dimension() != column.unit.dimension()) {
        const Message expected = dimension_words(column.unit);
        return unit == Unit{} ? tell<"column '%1' of '%2' is %3; its unit is missing: write \"%4 [%5]\"">(
                                    title, of, expected, column.key, column.unit.text())
                              : tell<"column '%1' of '%2' is %3; '%4' is the unit of %5">(
                                    title, of, expected, unit.text(), dimension_words(unit));
    }
    if (is_reading_for_difference(unit, column.unit))
        return tell<"column '%1' of '%2' is a difference of temperatures: give it in %3, not in %4">(
            title, of, unit.interval().display(), unit.display());
    return {};
}

void check_setup(const SetupSchema& schema, const Setup& setup, Problems& problems) {
    for (const auto& [key, value] : setup.values)
        if (!schema.find(key))
            problems.error("/" + key,
                           tell<"there is no field '%1' here%2">(key, did_you_mean(key, schema.keys())));
    for (const FieldSpec& field : schema.fields())
        if (is_shown(schema, field, setup)) check_field(field, value_of(field, setup), problems);
}

}  // namespace covaria
