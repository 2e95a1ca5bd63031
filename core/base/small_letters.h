// Comparison of names without regard to capital letters.
#pragma once

#include <string>

namespace covaria {

/// The text with a to z for A to Z, in any locale; letters of other scripts stay.
inline std::string in_small_letters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace covaria
