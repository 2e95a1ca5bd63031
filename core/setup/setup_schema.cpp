#include "core/setup/setup_schema.h"

#include <algorithm>

namespace covaria {

const FieldSpec* SetupSchema::find(const std::string& key) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const FieldSpec& field) { return field.key == key; });
    return found == fields_.end() ? nullptr : &*found;
}

const FieldSpec* SetupSchema::find(bool FieldSpec::*says) const {
    const auto found = std::ranges::find_if(fields_, says);
    return found == fields_.end() ? nullptr : &*found;
}

std::size_t SetupSchema::column(const FieldSpec& table, const std::string& key) {
    const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const ColumnSpec& column) { return column.key == key; });
    return found == table.columns.end() ? npos : static_cast<std::size_t>(found - table.columns.begin());
}

std::vector<std::string> SetupSchema::keys() const {
    std::vector<std::string> keys;
    for (const FieldSpec& field : fields_) keys.push_back(field.key);
    return keys;
}

const SetupValue& value_of(const FieldSpec& field, const Setup& setup) {
    const auto given = setup.values.find(field.key);
    const bool absent = given == setup.values.end() || std::holds_alternative<std::monostate>(given->second);
    return absent ? field.default_value : given->second;
}

bool holds(const Condition& condition, const SetupSchema& schema, const Setup& setup) {
    const FieldSpec* decides = schema.find(condition.key);
    if (!decides || !is_shown(schema, *decides, setup)) return false;
    const SetupValue& value = value_of(*decides, setup);
    std::string word;
    if (const bool* flag = std::get_if<bool>(&value)) word = *flag ? "true" : "false";
    if (const std::string* text = std::get_if<std::string>(&value)) word = *text;
    const auto& words = condition.values;
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_shown(const SetupSchema& schema, const FieldSpec& field, const Setup& setup) {
    return !field.shown_if || holds(*field.shown_if, schema, setup);
}

}  // namespace covaria
