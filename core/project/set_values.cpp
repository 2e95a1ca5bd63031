#include "core/project/set_values.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/utf8.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Json = nlohmann::ordered_json;

std::string unescaped(std::string name) {
    for (const auto& [escaped, plain] : {std::pair("~1", "/"), std::pair("~0", "~")})
        for (std::size_t at = name.find(escaped); at != std::string::npos; at = name.find(escaped, at + 1))
            name.replace(at, 2, plain);
    return name;
}

std::vector<std::string> names_of(const std::string& pointer) {
    std::vector<std::string> names;
    for (std::size_t begin = 1; begin <= pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', begin), pointer.size());
        names.push_back(unescaped(pointer.substr(begin, end - begin)));
        begin = end + 1;
    }
    return names;
}

std::optional<std::size_t> index_in(const Json& list, const std::string& name) {
    std::size_t index = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), index);
    if (read.ec != std::errc() || read.ptr != name.data() + name.size() || index >= list.size()) return {};
    return index;
}

/// The key in the head of a column: "r_u" of "r_u [%]".
std::string key_of(const Json& header) {
    const std::string text = header.is_string() ? header.get<std::string>() : "";
    return text.substr(0, text.find(" ["));
}

/// A walk down a document, name by name.
class Walk {
public:
    explicit Walk(Json& document) : at_(&document) {}

    /// The value that the name leads to; null where it leads nowhere, and `candidates` then says which names
    /// there are.
    Json* enter(const std::string& name, bool last) {
        Json* from = at_;
        at_ = from->is_object() ? member(name, last) : from->is_array() ? element(name) : nullptr;
        row_of_ = rows_of_;
        rows_of_ = from->is_object() && name == "rows" && from->contains("columns") ? from : nullptr;
        return at_;
    }
    const std::vector<std::string>& candidates() const { return candidates_; }

private:
    Json* member(const std::string& name, bool last) {
        if (at_->contains(name) || last) return &(*at_)[name];
        candidates_.clear();
        for (const auto& [key, value] : at_->items()) candidates_.push_back(key);
        return nullptr;
    }

    Json* element(const std::string& name) {
        if (const auto index = index_in(*at_, name)) return &(*at_)[*index];
        candidates_.clear();
        for (std::size_t i = 0; i < at_->size(); ++i) {
            const std::string known = row_of_ ? column(i) : name_of((*at_)[i]);
            if (known == name) return &(*at_)[i];
            candidates_.push_back(known);
        }
        return nullptr;
    }

    std::string column(std::size_t index) const {
        const Json& columns = (*row_of_)["columns"];
        return index < columns.size() ? key_of(columns[index]) : "";
    }

    static std::string name_of(const Json& entry) {
        if (entry.is_object() && entry.contains("id") && entry["id"].is_string()) return entry["id"];
        if (entry.is_array() && !entry.empty() && entry[0].is_string()) return entry[0];
        return key_of(entry);  // the entry is a column, whose head is a text
    }

    Json* at_;
    Json* rows_of_ = nullptr;  // table whose list of rows `at_` is
    Json* row_of_ = nullptr;   // table whose row `at_` is
    std::vector<std::string> candidates_;
};

Json json_of(const std::string& value) {
    Json read = Json::parse(value, nullptr, false);
    return read.is_discarded() || read.is_structured() ? Json(value) : read;
}

Result<void> put(const Json& value, Json& place, const ValueAt& asked) {
    const bool quantity = place.is_object() && place.contains("value") && place.contains("unit");
    if (quantity && value.is_number()) {
        place["value"] = value;
        return {};
    }
    if (place.is_structured() && !quantity)
        return fail(ErrorCode::bad_input, tell<"there is no single value here, but a list or a group">(),
                    asked.pointer);
    place = value;
    return {};
}

/// Sets a text of the certificate: a serial number of figures is a text too, and need not have stood there.
Result<void> set_certificate(Json& document, const std::vector<std::string>& names, const ValueAt& asked) {
    Json* place = &document;
    for (const std::string& name : names) {
        if (!place->is_object() && !place->is_null())
            return fail(ErrorCode::bad_input, tell<"there is nothing called '%1' to set">(name),
                        asked.pointer);
        place = &(*place)[name];
    }
    const Json read = json_of(asked.value);
    return put(read.is_string() ? read : Json(asked.value), *place, asked);
}

Result<void> set(Json& document, const ValueAt& asked) {
    for (const std::string& text : {asked.pointer, asked.value})
        if (valid_utf8(text) != text.size())
            return fail(ErrorCode::bad_input, tell<"the value or its place is no text in UTF-8">(),
                        asked.pointer.substr(0, valid_utf8(asked.pointer)));
    const std::vector<std::string> names = names_of(asked.pointer);
    if (names.size() > 1 && names.front() == "certificate") return set_certificate(document, names, asked);
    Walk walk(document);
    Json* place = &document;
    for (std::size_t i = 0; i < names.size() && place; ++i) {
        place = walk.enter(names[i], i + 1 == names.size());
        if (!place)
            return fail(ErrorCode::bad_input,
                        tell<"there is nothing called '%1' to set%2">(
                            names[i], did_you_mean(names[i], walk.candidates())),
                        asked.pointer);
    }
    return put(json_of(asked.value), *place, asked);
}

}  // namespace

Result<ValueAt> value_at(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (text.empty() || text[0] != '/' || equals == std::string::npos)
        return fail(ErrorCode::usage, tell<"'%1' is not of the form /PLACE/IN/THE/PROJECT=VALUE">(text));
    return ValueAt{text.substr(0, equals), text.substr(equals + 1)};
}

Result<std::vector<ValueAt>> values_at(const std::vector<std::string>& texts) {
    std::vector<ValueAt> values;
    for (const std::string& text : texts) {
        auto value = value_at(text);
        if (!value) return fail(value.error());
        values.push_back(std::move(*value));
    }
    return values;
}

Result<std::string> with_values(const std::string& json, const std::vector<ValueAt>& values) {
    Json document = Json::parse(json, nullptr, false);
    if (document.is_discarded()) return json;  // reading the text says what is wrong, with its line
    for (const ValueAt& value : values)
        if (auto done = set(document, value); !done) return fail(done.error());
    return document.dump();
}

}  // namespace covaria
