// Words and frames shared by the charts.
#pragma once

#include <string>

#include "core/report/plot_specification.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// "x of pose 7"
std::string plot_name(const OutputQuantity& quantity);
/// "x (mm)"
std::string axis_title(const OutputQuantity& quantity);
/// " (mm)", or nothing for the unit one.
std::string in_unit_words(const Unit& unit);
/// "1/mm"
std::string inverse_unit(const Unit& unit);
/// "95 %"
std::string percent(double probability);

/// Id and title of a chart of one output.
PlotSpecification plot_frame(const std::string& kind, const OutputResult& output, std::string title);
/// An empty chart whose title says what to do next.
PlotSpecification without_monte_carlo(PlotSpecification plot);
PlotSpecification without_spread(PlotSpecification plot);

/// Letters, digits and '-' only.
std::string file_word(std::string text);

}  // namespace covaria
