#include "core/text/wrapped.h"

#include <algorithm>
#include <string>

namespace covaria {

std::vector<Text> wrapped(const Text& text, const std::function<bool(const Text&)>& fits) {
    std::vector<Text> lines;
    const std::string letters = text.letters();
    for (std::size_t begin = 0; begin <= letters.size();) {
        const std::size_t end = std::min(letters.find(' ', begin), letters.size());
        const Text word = text.part(begin, end);
        const Text longer = lines.empty() ? word : lines.back() + " " + word;
        if (!lines.empty() && fits(longer))
            lines.back() = longer;
        else
            lines.push_back(word);
        begin = end + 1;
    }
    return lines;
}

}  // namespace covaria
