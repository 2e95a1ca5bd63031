// Names as messages print them.
#pragma once

#include <string>

namespace covaria {

/// 'text'
inline std::string in_quotes(const std::string& text) {
    return "'" + text + "'";
}

}  // namespace covaria
