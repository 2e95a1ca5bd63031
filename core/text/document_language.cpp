#include "core/text/document_language.h"

namespace covaria {
namespace {

std::vector<const char*>& known_phrases() {
    static std::vector<const char*> known;
    return known;
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

/// In one pass: a "%1" within an argument stays.
std::string DocumentLanguage::say(const Phrase& phrase, std::initializer_list<std::string> arguments) const {
    const std::string text = say_declared(phrase.english());
    std::string said;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t number = text[i] == '%' && i + 1 < text.size() ? std::size_t(text[i + 1] - '1') : 9;
        if (number < arguments.size()) {
            said += arguments.begin()[number];
            ++i;
        } else {
            said += text[i];
        }
    }
    return said;
}

}  // namespace covaria
