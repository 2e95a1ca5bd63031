// "%1" to "%9" in a text, and what stands for them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace covaria {

/// Puts the arguments in, in one pass: a "%1" within an argument stays. `Words`: std::string or Text;
/// `arguments` has size() and operator[].
template <class Words, class Arguments>
Words fill_placeholders(const std::string& text, const Arguments& arguments) {
    Words said;
    std::string letters;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t number = text[i] == '%' && i + 1 < text.size() ? std::size_t(text[i + 1] - '1') : 9;
        if (number < arguments.size()) {
            said += std::exchange(letters, {});
            said += arguments[number];
            ++i;
        } else {
            letters += text[i];
        }
    }
    return said += letters;
}

}  // namespace covaria
