#include "core/text/document_language.h"

#include <utility>

#include "core/base/placeholders.h"

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

const DocumentLanguage& DocumentLanguage::english() {
    static const DocumentLanguage language;
    return language;
}

std::string DocumentLanguage::say_declared(const std::string& english) const {
    return words_ && !english.empty() ? words_(english) : english;
}

std::string DocumentLanguage::say(const Phrase& phrase, std::initializer_list<std::string> arguments) const {
    return fill_placeholders<std::string>(say_declared(phrase.english()), std::vector(arguments));
}

std::string DocumentLanguage::say(const Message& message) const {
    return message.in([this](const std::string& english) { return say_declared(english); },
                      [this](const std::string& plain) { return grouped_digits(plain, numbers_); });
}

Text DocumentLanguage::say_text(const Phrase& phrase, std::initializer_list<Text> arguments) const {
    return fill_placeholders<Text>(say_declared(phrase.english()), std::vector(arguments));
}

Text DocumentLanguage::say_title(const Text& english) const {
    if (english.is_plain()) return say_declared(english.letters());
    const TextPattern pattern = pattern_of(english);
    if (!pattern.has_words()) return english;
    return fill_placeholders<Text>(say_declared(pattern.words), pattern.symbols);
}

PlotSpecification DocumentLanguage::say_plot(PlotSpecification plot) const {
    const auto say = [this](Text& text) { text = say_title(text); };
    for (Text* text : {&plot.title, &plot.x.title, &plot.x.short_title, &plot.y.title, &plot.y.short_title})
        say(*text);
    for (PlotSeries& series : plot.series)
        if (!series.is_named) say(series.name);
    for (PlotMark& mark : plot.marks) say(mark.label);
    for (PlotBand& band : plot.bands) say(band.label);
    return plot;
}

}  // namespace covaria
