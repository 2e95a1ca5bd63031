#include "ui/theme/core_text.h"

#include <QCoreApplication>

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
    return to_qt(message.in([](const std::string& english) { return core_words(english); }));
}

Text core_title(const Text& english) {
    const bool plain = english.spans().size() == 1 && !english.has_scripts() && !english.spans()[0].italic;
    return plain ? Text(core_words(english.spans()[0].letters)) : english;
}

std::vector<PlotSpecification> core_plots(std::vector<PlotSpecification> plots) {
    const auto translate = [](Text& text) { text = core_title(text); };
    for (PlotSpecification& plot : plots) {
        for (Text* text : {&plot.title, &plot.x.title, &plot.y.title}) translate(*text);
        for (PlotSeries& series : plot.series) translate(series.name);
        for (PlotMark& mark : plot.marks) translate(mark.label);
        for (PlotBand& band : plot.bands) translate(band.label);
    }
    return plots;
}

}  // namespace covaria::ui
