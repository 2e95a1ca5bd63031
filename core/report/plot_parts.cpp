#include "core/report/plot_parts.h"

#include <cctype>

#include "core/base/symbol.h"
#include "core/report/number_format.h"

namespace covaria {

std::string file_word(std::string text) {
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    return text;
}

std::string plot_name(const OutputQuantity& quantity) {
    const std::string symbol = symbol_to_unicode(quantity.symbol);
    return quantity.group.empty() ? symbol : symbol + " of " + quantity.group;
}

std::string in_unit_words(const Unit& unit) {
    return unit == Unit() ? "" : " (" + unit.display() + ")";
}

std::string axis_title(const OutputQuantity& quantity) {
    return symbol_to_unicode(quantity.symbol) + in_unit_words(quantity.unit);
}

std::string inverse_unit(const Unit& unit) {
    return unit == Unit() ? "1" : "1/" + unit.display();
}

std::string percent(double probability) {
    return format_significant(100.0 * probability, 4) + " %";
}

PlotSpecification plot_frame(const std::string& kind, const OutputResult& output, std::string title) {
    PlotSpecification plot;
    plot.id = kind + "-" + file_word(output.quantity.symbol);
    if (!output.quantity.group.empty()) plot.id += "-" + file_word(output.quantity.group);
    plot.title = std::move(title);
    return plot;
}

PlotSpecification without_monte_carlo(PlotSpecification plot) {
    plot.title += ": run Monte Carlo to see it";
    return plot;
}

PlotSpecification without_spread(PlotSpecification plot) {
    plot.title += ": the value has no uncertainty";
    return plot;
}

}  // namespace covaria
