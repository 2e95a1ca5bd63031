// The language that a document is written in: its words and its numbers.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/text/numbers.h"
#include "core/text/plot_specification.h"
#include "core/text/text.h"

namespace covaria {

/// A text of a document in English, "%1" to "%9" for what stands in it. Each is declared once, at namespace
/// scope, and is then in the list that catalogues are filled from.
class Phrase {
public:
    explicit Phrase(const char* english);
    const char* english() const { return english_; }

    static const std::vector<const char*>& all();

private:
    const char* english_;
};

/// English, with the decimal point, unless it is made for another one.
class DocumentLanguage {
public:
    /// Called from any thread.
    using Words = Message::Words;

    DocumentLanguage() = default;
    DocumentLanguage(std::string code, NumberLocale numbers, Words words)
        : code_(std::move(code)), numbers_(std::move(numbers)), words_(std::move(words)) {}

    static const DocumentLanguage& english();

    const std::string& code() const { return code_; }  ///< "en", "pt", "zh_CN"
    const NumberLocale& numbers() const { return numbers_; }

    std::string say(const Phrase& phrase, std::initializer_list<std::string> arguments = {}) const;
    std::string say(const Message& message) const;
    /// A phrase with symbols in it.
    Text say_text(const Phrase& phrase, std::initializer_list<Text> arguments) const;
    /// Words that a registry declares: the title of a field, the name of an output. Names people gave stay.
    std::string say_declared(const std::string& english) const;
    /// Declared words with symbols in them, which stay.
    Text say_title(const Text& english) const;
    /// A chart of a model or an asset: titles, axes, legends, marks.
    PlotSpecification say_plot(PlotSpecification english) const;

private:
    std::string code_ = "en";
    NumberLocale numbers_;
    Words words_;
};

}  // namespace covaria
