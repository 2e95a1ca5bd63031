#include "ui/theme/core_text.h"

#include <QCoreApplication>

#include "core/text/numbers.h"
#include "ui/theme/document_language.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

QString core_text(std::string_view english) {
    if (english.empty()) return {};
    return QCoreApplication::translate(core_context, std::string(english).c_str());
}

std::string core_words(std::string_view english) {
    return to_std(core_text(english));
}

QString to_qt(const Message& message) {
    return to_qt(message.in([](const std::string& english) { return core_words(english); },
                            [](const std::string& plain) { return grouped_digits(plain, user_numbers()); }));
}

Text core_title(const Text& english) {
    return english.is_plain() ? Text(core_words(english.letters())) : english;
}

std::vector<PlotSpecification> core_plots(std::vector<PlotSpecification> plots) {
    const DocumentLanguage in = language_of_window();
    for (PlotSpecification& plot : plots) plot = in.say_plot(std::move(plot));
    return plots;
}

}  // namespace covaria::ui
