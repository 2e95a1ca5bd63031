// The parts that the charts of a result share: labels, display units, and the text of a chart that has
// nothing to show.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria::plot_parts {

/// An output with its numbers in display units.
class PlottedOutput {
public:
    PlottedOutput(const UncertaintyResult& result, std::size_t output, const DisplayUnits& units = {},
                  const DocumentLanguage& language = {});

    const DocumentLanguage& language() const { return language_; }
    const OutputResult& output() const { return output_; }
    const MonteCarloOutput* trials() const { return output_.monte_carlo ? &*output_.monte_carlo : nullptr; }
    double value(double si) const { return unit_.from_si(si); }
    double interval(double si) const { return unit_.interval_from_si(si); }

    Text symbol() const;                             ///< symbol such as "α"
    Text label() const;                              ///< label such as "α (pose 7)"
    std::string id(const std::string& chart) const;  ///< id such as "histogram-alpha-pose-7"
    std::string unit() const;                        ///< unit such as "mm"; empty for numbers
    void set_density_axis(PlotAxis& axis) const;     ///< title "probability density" in "1/mm"
    /// The power of ten of an axis to `largest` (display units) with this result, or an uncertainty, on it;
    /// zero where that is written out.
    int exponent_of_results(double largest) const;
    int exponent_of_uncertainties(double si, int digits, double largest) const;
    /// The result as text: "1174.91 mm", rounded as the result line, with the power of ten of its axis.
    std::string result_text(double si, int exponent) const;
    std::string uncertainty_text(double si, int digits, int exponent) const;  ///< text such as "0.37 mm"

private:
    std::string with_power_and_unit(const std::string& plain, int exponent) const;

    const OutputResult& output_;
    double spread_;
    Unit unit_;
    double largest_stated_;  ///< largest stated number in display units
    DocumentLanguage language_;
};

/// A chart without series; the title says why and what to do.
PlotSpecification nothing_to_show(std::string id, Text title);

/// Whether the trials of the output give a distribution to draw.
bool has_histogram(const PlottedOutput& y);
/// The cells of the trials as probability density in display units, joined to suit the number of trials. The
/// cells of an incomplete last group count as one, too.
PlotSeries histogram_bars(const PlottedOutput& y);

/// The function f at `points` places, evenly spaced over [low, high].
PlotSeries curve(double low, double high, std::size_t points, const std::function<double(double)>& f);
/// The probability density by the law of propagation, of which k is a quantile: Student's t about the
/// estimate with scale u for finite effective degrees of freedom (JCGM 100 G.3), else normal. 0 < u <
/// infinity.
PlotSeries first_order_curve(const PlottedOutput& y, double low, double high, std::size_t points);

}  // namespace covaria::plot_parts
