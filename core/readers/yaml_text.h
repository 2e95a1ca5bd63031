// YAML of others: parsed into plain nodes with their places; aliases are refused, so nothing is ever
// expanded.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text_places.h"

namespace covaria {

inline constexpr std::size_t largest_yaml = 500'000;  ///< bytes; the scanner may take 250 times as much

struct YamlNode {
    enum class Kind { nothing, scalar, list, map };
    Kind kind = Kind::nothing;
    std::string text = {};                ///< text of a scalar
    std::vector<std::string> keys = {};   ///< key of a map for each child
    std::vector<YamlNode> children = {};  ///< elements of a list or map
    int line = 0, column = 0;             ///< places from 1

    /// The value under a key; null if there is none or nothing is said.
    const YamlNode* find(const std::string& key) const;
    /// The scalar under a key, or an empty text.
    std::string text_of(const std::string& key) const;
    /// The finite number of a scalar; empty where it is none.
    std::optional<double> number() const;
    tl::unexpected<Error> refused(const Message& message) const { return refused_at(line, column, message); }
};

/// The first document of a text. Error with line and column: no YAML, an alias, a key that is not a word or
/// stands twice, too large, too deep.
Result<YamlNode> parse_yaml(const std::string& text);

}  // namespace covaria
