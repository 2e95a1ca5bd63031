#include "core/project/what_to_write.h"

#include "core/project/csv_reader.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

struct Typed {
    double value = 0.0;
    std::optional<Unit> unit = {};
};

/// The number that a text states, maybe with a unit: "1,5", "1.5 mm"; nothing where the text is no number.
std::optional<Typed> typed_in(const Json& given) {
    if (!given.is_string()) return std::nullopt;
    const std::string text = given.get<std::string>();
    const std::size_t blank = text.find(' ');
    const auto number = csv_number(text.substr(0, blank), true);
    if (!number) return std::nullopt;
    if (blank == std::string::npos) return Typed{*number, {}};
    const Result<Unit> unit = Unit::parse(text.substr(blank + 1));
    return unit ? std::optional(Typed{*number, *unit}) : std::nullopt;
}

std::string in_json(double value, const Unit& unit) {
    return "{\"value\": " + shortest_number(value) + ", \"unit\": \"" + unit.text() + "\"}";
}

}  // namespace

Message cell_to_write(const Json& given, FieldKind kind, const Unit& unit) {
    if (kind == FieldKind::flag) return tell<"write true or false, without quotes">();
    if (kind != FieldKind::number && kind != FieldKind::integer)
        return given.is_structured() ? tell<"write a text in quotes">()
                                     : tell<"write it in quotes: \"%1\"">(given.dump());
    const auto typed = typed_in(given);
    if (!typed) return tell<"write a number without quotes, such as 0.25, or null where there is none">();
    if (!typed->unit || *typed->unit == unit)
        return tell<"write %1, without quotes">(shortest_number(typed->value));
    if (typed->unit->dimension() != unit.dimension() || typed->unit->has_offset() != unit.has_offset())
        return tell<"write a number in %1, the unit of the column, without quotes">(unit.text());
    const double converted = unit.from_si(typed->unit->to_si(typed->value));
    return tell<"write %1, without quotes: the unit of the column is %2">(readable_number(converted),
                                                                          unit.text());
}

Message number_to_write(const Json& given, const Unit& unit) {
    const auto typed = typed_in(given);
    const double example = 0.25;
    if (unit.dimension().is_one() && (!typed || !typed->unit))
        return tell<"write %1, without quotes">(shortest_number(typed ? typed->value : example));
    return tell<"write %1">(
        in_json(typed ? typed->value : example, typed && typed->unit ? *typed->unit : unit));
}

}  // namespace covaria
