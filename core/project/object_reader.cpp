#include "core/project/object_reader.h"

#include <algorithm>

#include "core/project/json_location.h"
#include "core/setup/message_text.h"

namespace covaria {

Message json_words(const Json& value) {
    if (value.is_string()) return tell<"the text '%1'">(value.get<std::string>());
    if (value.is_number()) return tell<"the number %1">(readable_number(value.get<double>()));
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    if (value.is_array()) return tell<"a list">();
    return value.is_object() ? tell<"an object">() : Message("null");
}

Unit unit_from(const std::string& text, const std::string& path, Problems& problems) {
    const Result<Unit> unit = Unit::parse(text);
    if (unit) return *unit;
    problems.error(path, unit.error().message);
    return {};
}

ObjectReader::ObjectReader(const Json& value, std::string path, Message what, Problems& problems)
    : value_(value), path_(std::move(path)), what_(std::move(what)), problems_(problems) {
    if (!value_.is_object())
        problems_.error(path_, tell<"%1 must be an object in braces, not %2">(what_, json_words(value_)));
}

const Json* ObjectReader::find(const std::string& key) {
    known_.push_back(key);
    return has(key) ? &value_.at(key) : nullptr;
}

std::string ObjectReader::path_of(const std::string& key) const {
    return path_ + "/" + pointer_token(key);
}

const Json* ObjectReader::require(const std::string& key, bool required) {
    const Json* found = find(key);
    if (!found && required && value_.is_object())
        problems_.error(path_of(key), tell<"'%1' is missing in %2">(key, what_));
    return found;
}

void ObjectReader::wrong_kind(const std::string& key, const Message& expected, const Json& found) {
    problems_.error(path_of(key), tell<"'%1' must be %2, not %3">(key, expected, json_words(found)));
}

std::string ObjectReader::text(const std::string& key, bool required) {
    const Json* found = require(key, required);
    if (found && !found->is_string()) wrong_kind(key, tell<"a text in quotes">(), *found);
    return found && found->is_string() ? found->get<std::string>() : std::string{};
}

std::optional<double> ObjectReader::number(const std::string& key, bool required) {
    const Json* found = require(key, required);
    if (found && !found->is_number()) wrong_kind(key, tell<"a number">(), *found);
    return found && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::optional<double> ObjectReader::number_or_infinity(const std::string& key) {
    if (has(key) && value_.at(key).is_null()) {
        known_.push_back(key);
        return std::numeric_limits<double>::infinity();
    }
    return number(key);
}

std::optional<bool> ObjectReader::flag(const std::string& key) {
    const Json* found = find(key);
    if (found && !found->is_boolean()) wrong_kind(key, tell<"true or false">(), *found);
    return found && found->is_boolean() ? std::optional(found->get<bool>()) : std::nullopt;
}

std::optional<Quantity> ObjectReader::quantity(const std::string& key) {
    const Json* found = find(key);
    return found ? quantity_from(*found, path_of(key), problems_) : std::nullopt;
}

const Json* ObjectReader::list(const std::string& key, bool required) {
    const Json* found = require(key, required);
    if (found && !found->is_array()) wrong_kind(key, tell<"a list in brackets">(), *found);
    return found && found->is_array() ? found : nullptr;
}

void ObjectReader::refuse_unknown_keys() {
    if (!value_.is_object()) return;
    for (const auto& [key, value] : value_.items())
        if (std::find(known_.begin(), known_.end(), key) == known_.end())
            problems_.error(path_of(key),
                            tell<"there is no '%1' in %2%3">(key, what_, did_you_mean(key, known_)));
}

std::optional<Quantity> quantity_from(const Json& value, const std::string& path, Problems& problems) {
    const std::size_t before = problems.items().size();
    ObjectReader reader(value, path, tell<"a number with its unit">(), problems);
    const bool infinite = reader.has("value") && value.at("value").is_null();
    const std::optional<double> number =
        infinite ? reader.number_or_infinity("value") : reader.number("value", true);
    const std::string text = reader.text("unit", true);
    reader.refuse_unknown_keys();
    if (problems.items().size() > before) return std::nullopt;
    const Unit unit = unit_from(text, reader.path_of("unit"), problems);
    if (problems.items().size() > before) return std::nullopt;
    return Quantity{*number, unit};
}

}  // namespace covaria
