// A chart described as data; ui/charts realises it. Values are in display units already; axes say which.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/text/text.h"

namespace covaria {

struct PlotAxis {
    Text title;                    ///< "x", without its unit
    double low = 0.0, high = 0.0;  ///< low == high: from the data
    bool logarithmic = false;
    std::vector<Text> categories = {};  ///< not empty: a category axis; the first is at 0
    Text short_title = {};              ///< "density", where the title has no room
    /// Power of ten that is taken out of its labels, as of the texts of its marks; 0: plain numbers. Empty:
    /// what suits the part that is shown.
    std::optional<int> exponent = {};
    std::string unit = {};  ///< unit as it is shown: "mm", "1/mm"; empty: a number
};

enum class SeriesKind {
    line,
    points,
    bars,      ///< histogram or categories: x are cell centres, of equal width; horizontal bars: y are the
               ///< centres
    heat_map,  ///< `z` row-major over categories of both axes
};
/// Decides the colour.
enum class SeriesRole {
    data,
    fit,
    reference,
    first_order,
    monte_carlo,
    emphasis,
    // lines of equal rank, told apart by their colours
    family_1,
    family_2,
    family_3,
    family_4,
    family_5,
    family_6
};

struct PlotSeries {
    Text name;  ///< name in the legend; empty = not in the legend
    SeriesKind kind = SeriesKind::line;
    SeriesRole role = SeriesRole::data;
    std::vector<double> x, y, z;
    double bar_width = 0.0;  ///< width in x units (horizontal bars: y units)
    bool is_named = false;   ///< somebody gave the name, which is the same in every language
    std::string unit = {};   ///< unit of z, as that of an axis
};

/// A vertical (or horizontal) line with a label: mean, ends of an interval, a target.
struct PlotMark {
    Text label;
    double at = 0.0;
    bool horizontal = false;
    SeriesRole role = SeriesRole::reference;
};

/// A shaded range of x (coverage interval).
struct PlotBand {
    Text label;
    double low = 0.0, high = 0.0;
    SeriesRole role = SeriesRole::reference;
};

struct PlotSpecification {
    std::string id;  ///< file-name friendly: "histogram-x-pose-7"
    Text title;
    PlotAxis x, y;
    std::vector<PlotSeries> series;
    std::vector<PlotMark> marks;
    std::vector<PlotBand> bands;
    bool horizontal_bars = false;
    double z_low = 0.0, z_high = 0.0;  ///< range of a heat map (correlation: -1..1, diverging)
    std::string quantity = {};         ///< symbol of the input quantity that it is about; empty: of none
};

}  // namespace covaria
