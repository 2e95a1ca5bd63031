#include "core/setup/field_words.h"

#include <cmath>

#include "core/text/numbers.h"

namespace covaria {

const char* kind_words(FieldKind kind) {
    switch (kind) {
        case FieldKind::number:
            return "real number";
        case FieldKind::integer:
            return "integer";
        case FieldKind::choice:
            return "choice";
        case FieldKind::text:
            return "text";
        case FieldKind::flag:
            return "flag";
        case FieldKind::pose:
            return "pose";
        case FieldKind::table:
            return "table";
        case FieldKind::reference:
            return "reference to an asset";
    }
    return "";
}

std::string value_words(const SetupValue& value) {
    if (const auto* quantity = std::get_if<Quantity>(&value))
        return format_short(quantity->value, 12) +
               (quantity->unit == Unit() ? "" : " " + quantity->unit.text());
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (std::holds_alternative<PoseValue>(value)) return "identity";
    return {};
}

std::string range_words(const Range& range, const Unit& unit) {
    if (std::isinf(range.low) && std::isinf(range.high)) return {};
    std::string text = range.low_open ? "(" : "[";
    text += std::isinf(range.low) ? "-inf" : format_short(unit.from_si(range.low), 12);
    text += ", ";
    text += std::isinf(range.high) ? "inf" : format_short(unit.from_si(range.high), 12);
    return text + (std::isinf(range.high) ? ")" : "]");
}

}  // namespace covaria
