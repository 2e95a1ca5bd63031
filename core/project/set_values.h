// Values of a project file changed from outside before it is read: `--set`, and a row of a table for each
// serial number.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// A place in a project file and the value that is to stand there.
struct ValueAt {
    /// The place as a JSON pointer. A list is also entered by the "id" of an entry, a table's row by its
    /// first cell, its cell and the head of a column by the column's key:
    /// "/analyses/gauge/setup/quantities/rows/l_S/value", ".../columns/value". Within names '~1' stands for
    /// '/', '~0' for '~' (RFC 6901).
    std::string pointer;
    std::string
        value;  ///< JSON (23.5, true, null), or else a text; a number takes the unit that stands there
};

/// The place and value of a text "POINTER=VALUE". Error{usage}.
Result<ValueAt> value_at(const std::string& text);
/// The places and values of all texts. Error{usage}: that of the first text that is wrong.
Result<std::vector<ValueAt>> values_at(const std::vector<std::string>& texts);

/// The JSON text of a project with the values in their places. Error{bad_input} with the pointer as path:
/// there is no such place, or it holds a list or an object. A key that the file leaves out may be set where
/// its object is there; the certificate's are made, and its values are texts whatever they look like.
Result<std::string> with_values(const std::string& json, const std::vector<ValueAt>& values);

}  // namespace covaria
