// The places of the values of a JSON text: line numbers for problems, and syntax errors in words.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace covaria {

/// A token as it stands in a JSON pointer ("~" and "/" escaped, RFC 6901).
std::string pointer_token(const std::string& token);

/// Index of a JSON text: the line of every value by its JSON pointer. Scanning is also the syntax check,
/// since only here is it known what was expected where.
class JsonLocations {
public:
    /// The index of a text. Errors (with `line`, and the column in the message): syntax, NaN and infinity, an
    /// unfinished text, nesting deeper than 64.
    static Result<JsonLocations> scan(std::string_view text);

    /// Line of the value, or of the nearest value around it that the text has (a cell is named by column in
    /// problems, so its row is found). It is 0 if nothing but the whole text is around it.
    int line(const std::string& pointer) const;
    /// Keys that occur twice in one object, with their lines.
    const Problems& duplicate_keys() const { return duplicate_keys_; }

private:
    friend class JsonScanner;
    std::map<std::string, int> lines_;
    Problems duplicate_keys_;
};

}  // namespace covaria
