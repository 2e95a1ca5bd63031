// Labels and display units of charts.
#include "core/views/plots_parts.h"

#include <algorithm>
#include <cmath>

#include "core/math/special_quantiles.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/text/ticks.h"
#include "core/text/written_out.h"
#include "core/views/plot_words.h"
#include "core/views/result_statement.h"
#include "core/views/result_words.h"

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
      largest_stated_(largest_stated_number(output_, result, unit_)),
      language_(language) {}

Text PlottedOutput::symbol() const {
    return symbol_text(output_.quantity.symbol);
}

Text PlottedOutput::label() const {
    return result_words::output_text(output_.quantity, language_);
}

std::string PlottedOutput::id(const std::string& chart) const {
    return chart + "-" + result_words::id_part(output_.quantity.symbol + " " + output_.quantity.group);
}

std::string PlottedOutput::unit() const {
    return is_one(unit_) ? std::string() : unit_.display();
}

void PlottedOutput::set_density_axis(PlotAxis& axis) const {
    axis.title = language_.say(plot_words::density);
    axis.short_title = language_.say(plot_words::short_density);
    if (const auto per_unit = Unit::parse("1/(" + unit_.interval().text() + ")"); per_unit && !is_one(unit_))
        axis.unit = per_unit->display();
}

int PlottedOutput::exponent_of_results(double largest) const {
    const double spread = interval(spread_);
    const int decimals = std::isfinite(spread) && spread > 0.0 ? decimals_for(spread) : 0;
    return is_written_out(largest_stated_, decimals) ? 0 : axis_exponent(largest);
}

int PlottedOutput::exponent_of_uncertainties(double si, int digits, double largest) const {
    const bool is_written_out = format_significant(interval(si), digits).find('e') == std::string::npos;
    return is_written_out ? 0 : axis_exponent(largest);
}

std::string PlottedOutput::result_text(double si, int exponent) const {
    const double power = std::pow(10.0, exponent), shown = value(si) / power,
                 spread = interval(spread_) / power;
    const bool has_spread = std::isfinite(spread) && spread > 0.0;
    return with_power_and_unit(
        has_spread ? format_decimals(shown, decimals_for(spread, 2)) : format_to_match(shown, spread),
        exponent);
}

std::string PlottedOutput::uncertainty_text(double si, int digits, int exponent) const {
    return with_power_and_unit(format_significant(interval(si) / std::pow(10.0, exponent), digits), exponent);
}

std::string PlottedOutput::with_power_and_unit(const std::string& plain, int exponent) const {
    return grouped_digits(plain, language_.numbers()) + (exponent == 0 ? "" : "×" + power_of_ten(exponent)) +
           unit_after_number(unit_);
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

PlotSeries first_order_curve(const PlottedOutput& y, double low, double high, std::size_t points) {
    const FirstOrderOutput& first = y.output().first_order;
    const double nu = first.effective_degrees_of_freedom;
    const double mean = y.value(first.estimate), u = y.interval(first.standard_uncertainty);
    PlotSeries line = curve(low, high, points, [&](double x) { return t_density((x - mean) / u, nu) / u; });
    line.name = y.language().say(std::isfinite(nu) ? plot_words::t_of_first_order
                                                   : plot_words::normal_of_first_order);
    line.role = SeriesRole::first_order;
    return line;
}

}  // namespace covaria::plot_parts
