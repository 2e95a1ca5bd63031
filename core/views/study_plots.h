// The charts of a study as plot specifications.
#pragma once

#include <vector>

#include "core/result/study_result.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria {

/// The part of a study that is looked at.
struct StudyView {
    std::size_t quantity = 0;    ///< index in study_quantities
    bool lines = false;          ///< for two axes: a family of lines, else a map
    std::size_t fixed_axis = 0;  ///< for three axes: the one that a slice leaves out
    std::size_t slice = 0;       ///< index of the slice
    bool operator==(const StudyView&) const = default;
};

/// The chart of a study. One axis: U of the outputs that have the unit of the quantity (those of its group
/// first, at most six lines) against the axis. Two axes: a map of the quantity, or lines over the first axis.
/// Three: the chart of a slice. Where there is nothing to show, the specification has no series and its title
/// says why. `language` is that of words and numbers.
PlotSpecification study_plot(const StudyResult& study, const StudyView& view,
                             const DocumentLanguage& language = {});

/// The charts of a report: every group of outputs of a sweep; the first quantities of a map, in its middle
/// slice.
std::vector<PlotSpecification> study_plots(const StudyResult& study, const DocumentLanguage& language = {},
                                           std::size_t most = 3);

/// The place of a grid point in words: "x = 1 500 mm, y = 200 mm".
std::string point_words(const StudyResult& study, std::size_t point, const DocumentLanguage& in = {});

}  // namespace covaria
