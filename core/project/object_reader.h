// Reading a JSON object key by key, with every wrong kind and every unknown key reported.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

using Json = nlohmann::ordered_json;

/// A value in words: "the text 'abc'", "the number 3", "a list" ...
Message json_words(const Json& value);
/// The unit that a text names; it is Unit{} after a problem was reported.
Unit unit_from(const std::string& text, const std::string& path, Problems& problems);

/// A reader of an object: the keys that are asked for are the known ones, and `refuse_unknown_keys` reports
/// all others.
class ObjectReader {
public:
    /// `what` names the object in messages ("an analysis"). A value that is not an object is reported.
    ObjectReader(const Json& value, std::string path, Message what, Problems& problems);

    const Json* find(const std::string& key);  ///< null if absent
    bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }
    std::string path_of(const std::string& key) const;

    /// The text under a key; empty, and reported, where it is required and absent, or is not a text.
    std::string text(const std::string& key, bool required = false);
    std::optional<double> number(const std::string& key, bool required = false);
    /// The number under a key; null reads as infinity.
    std::optional<double> number_or_infinity(const std::string& key);
    std::optional<bool> flag(const std::string& key);
    /// The quantity under a key: {"value": 0.7, "unit": "K"}.
    std::optional<Quantity> quantity(const std::string& key);
    /// The list under a key, or null; anything else there is reported.
    const Json* list(const std::string& key, bool required = false);

    void refuse_unknown_keys();
    Problems& problems() { return problems_; }

private:
    const Json* require(const std::string& key, bool required);
    void wrong_kind(const std::string& key, const Message& expected, const Json& found);

    const Json& value_;
    std::string path_;
    Message what_;
    Problems& problems_;
    std::vector<std::string> known_;
};

/// The quantity of a value {"value": 0.7, "unit": "K"}, in which null reads as infinity.
std::optional<Quantity> quantity_from(const Json& value, const std::string& path, Problems& problems);

}  // namespace covaria
