// Names as messages print them.
#pragma once

#include <string>

#include "core/base/message.h"

namespace covaria {

/// 'text'
inline std::string in_quotes(const std::string& text) {
    return "'" + text + "'";
}
inline std::string in_quotes(const char* text) {
    return in_quotes(std::string(text));
}
inline Message in_quotes(const Message& text) {
    return "'" + text + "'";
}

}  // namespace covaria
