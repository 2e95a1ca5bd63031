// Labels and display units of charts.
#include "core/report/plots_parts.h"

#include <cmath>

#include "core/report/plot_words.h"
#include "core/report/report_parts.h"
#include "core/report/result_statement.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::plot_parts {
namespace {

bool is_one(const Unit& unit) {
    return unit.text() == "1";
}

}  // namespace

PlottedOutput::PlottedOutput(const UncertaintyResult& result, std::size_t output, const DisplayUnits& units,
                             const DocumentLanguage& language)
    : output_(result.outputs.at(output)),
      spread_(stated_spread(output_, result)),
      unit_(units.of(output_.quantity.unit)),
      language_(language) {}

Text PlottedOutput::symbol() const {
    return symbol_text(output_.quantity.symbol);
}

Text PlottedOutput::label() const {
    return report_parts::output_text(output_.quantity, language_);
}

std::string PlottedOutput::id(const std::string& chart) const {
    return chart + "-" + report_parts::id_part(output_.quantity.symbol + " " + output_.quantity.group);
}

Text PlottedOutput::with_unit(const Text& words) const {
    return is_one(unit_) ? words : words + (" (" + unit_.display() + ")");
}

void PlottedOutput::set_density_axis(PlotAxis& axis) const {
    if (is_one(unit_)) {
        axis.title = language_.say(plot_words::density);
        axis.short_title = language_.say(plot_words::short_density);
        return;
    }
    const std::string text = unit_.display();
    const bool compound = text.find('/') != std::string::npos || text.find("·") != std::string::npos;
    const std::string per = compound ? "(" + text + ")" : text;
    axis.title = language_.say(plot_words::density_per, {per});
    axis.short_title = language_.say(plot_words::short_density_per, {per});
}

std::string PlottedOutput::plain_result(double si) const {
    return format_to_match(value(si), interval(spread_));
}

std::string PlottedOutput::plain_uncertainty(double si, int digits) const {
    return format_significant(interval(si), digits);
}

std::string PlottedOutput::result_text(double si) const {
    return grouped_digits(plain_result(si), language_.numbers()) + unit_after_number(unit_);
}

std::string PlottedOutput::uncertainty_text(double si, int digits) const {
    return grouped_digits(plain_uncertainty(si, digits), language_.numbers()) + unit_after_number(unit_);
}

bool PlottedOutput::writes_out_result(double si) const {
    return plain_result(si).find('e') == std::string::npos;
}

bool PlottedOutput::writes_out_uncertainty(double si, int digits) const {
    return plain_uncertainty(si, digits).find('e') == std::string::npos;
}

PlotSpecification nothing_to_show(std::string id, Text title) {
    PlotSpecification plot;
    plot.id = std::move(id);
    plot.title = std::move(title);
    return plot;
}

PlotSeries curve(double low, double high, std::size_t points, const std::function<double(double)>& f) {
    PlotSeries series;
    for (std::size_t i = 0; i < points; ++i) {
        const double x = low + (high - low) * static_cast<double>(i) / static_cast<double>(points - 1);
        series.x.push_back(x);
        series.y.push_back(f(x));
    }
    return series;
}

}  // namespace covaria::plot_parts
