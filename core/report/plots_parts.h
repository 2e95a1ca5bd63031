// What the charts of a result share: labels, display units, and the text of a chart that has nothing to show.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/plot_specification.h"
#include "core/result/uncertainty_result.h"

namespace covaria::plot_parts {

/// An output with its numbers in display units.
class PlottedOutput {
public:
    PlottedOutput(const UncertaintyResult& result, std::size_t output);

    const OutputResult& output() const { return output_; }
    const MonteCarloOutput* trials() const { return output_.monte_carlo ? &*output_.monte_carlo : nullptr; }
    double value(double si) const { return output_.quantity.unit.from_si(si); }
    double interval(double si) const { return output_.quantity.unit.interval_from_si(si); }

    std::string symbol() const;                                 ///< "α"
    std::string label() const;                                  ///< "α (pose 7)"
    std::string id(const std::string& chart) const;             ///< "histogram-alpha-pose-7"
    std::string with_unit(std::string words) const;             ///< "x (mm)"; without unit for numbers
    std::string density_title() const;                          ///< "probability density (1/mm)"
    std::string result_text(double si) const;                   ///< "1174.91 mm", rounded to match u
    std::string uncertainty_text(double si, int digits) const;  ///< "0.37 mm"

private:
    const OutputResult& output_;
};

/// A chart without series; the title says why and what to do.
PlotSpecification nothing_to_show(std::string id, std::string title);

/// f at `points` places, evenly spaced over [low, high].
PlotSeries curve(double low, double high, std::size_t points, const std::function<double(double)>& f);

}  // namespace covaria::plot_parts
