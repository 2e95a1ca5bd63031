// Labels and display units of charts.
#include "core/report/plots_parts.h"

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "core/report/report_parts.h"

namespace covaria::plot_parts {
namespace {

bool is_one(const Unit& unit) {
    return unit.text() == "1";
}

std::string with_true_minus(std::string text) {
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

/// A space between number and unit, except before the degree sign of plane angle (SI Brochure 5.4.3).
std::string unit_after_number(const Unit& unit) {
    if (is_one(unit)) return {};
    return (unit.text() == "deg" ? "" : "\u00a0") + unit.display();
}

}  // namespace

PlottedOutput::PlottedOutput(const UncertaintyResult& result, std::size_t output)
    : output_(result.outputs.at(output)) {}

std::string PlottedOutput::symbol() const {
    return symbol_to_unicode(output_.quantity.symbol);
}

std::string PlottedOutput::label() const {
    return report_parts::output_label(output_.quantity);
}

std::string PlottedOutput::id(const std::string& chart) const {
    return chart + "-" + report_parts::file_name_part(output_.quantity.symbol + " " + output_.quantity.group);
}

std::string PlottedOutput::with_unit(std::string words) const {
    const Unit& unit = output_.quantity.unit;
    return is_one(unit) ? words : std::move(words) + " (" + unit.display() + ")";
}

std::string PlottedOutput::density_title() const {
    const Unit& unit = output_.quantity.unit;
    if (is_one(unit)) return "probability density";
    const std::string text = unit.display();
    const bool compound = text.find('/') != std::string::npos || text.find("·") != std::string::npos;
    return "probability density (1/" + (compound ? "(" + text + ")" : text) + ")";
}

std::string PlottedOutput::result_text(double si) const {
    const std::string number = format_to_match(value(si), interval(output_.standard_uncertainty));
    return with_true_minus(number) + unit_after_number(output_.quantity.unit);
}

std::string PlottedOutput::uncertainty_text(double si, int digits) const {
    return format_significant(interval(si), digits) + unit_after_number(output_.quantity.unit);
}

PlotSpecification nothing_to_show(std::string id, std::string title) {
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
