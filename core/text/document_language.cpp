#include "core/text/document_language.h"

#include <utility>

namespace covaria {
namespace {

std::vector<const char*>& known_phrases() {
    static std::vector<const char*> known;
    return known;
}

/// In one pass: a "%1" within an argument stays.
template <class Words>
Words filled(const std::string& text, std::initializer_list<Words> arguments) {
    Words said;
    std::string letters;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t number = text[i] == '%' && i + 1 < text.size() ? std::size_t(text[i + 1] - '1') : 9;
        if (number < arguments.size()) {
            said += std::exchange(letters, {});
            said += arguments.begin()[number];
            ++i;
        } else {
            letters += text[i];
        }
    }
    return said += letters;
}

}  // namespace

Phrase::Phrase(const char* english) : english_(english) {
    known_phrases().push_back(english);
}

const std::vector<const char*>& Phrase::all() {
    return known_phrases();
}

std::string DocumentLanguage::say_declared(const std::string& english) const {
    return words_ && !english.empty() ? words_(english) : english;
}

std::string DocumentLanguage::say(const Phrase& phrase, std::initializer_list<std::string> arguments) const {
    return filled(say_declared(phrase.english()), arguments);
}

Text DocumentLanguage::say_text(const Phrase& phrase, std::initializer_list<Text> arguments) const {
    return filled(say_declared(phrase.english()), arguments);
}

}  // namespace covaria
