// What a new analysis begins as: an analysis of a shipped example with all it uses, so that it has results at
// once.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/text/document_language.h"

namespace covaria {

struct AnalysisTemplate {
    /// What one wants to know.
    enum class Topic { equation, points, pose, robot } topic = Topic::equation;
    std::string title;     ///< "Pose of a robot's flange from a laser tracker"
    std::string question;  ///< what it answers
    std::string
        example;  ///< file of the example, without its ending, in the folder of examples: "gum/h1-end-gauge"
    std::string analysis;       ///< id in the example
    bool with_designs = false;  ///< its studies and designs are what it is about
};

/// By what is asked; all models have at least one.
const std::vector<AnalysisTemplate>& analysis_templates();
/// The first of the model; null: none is shipped.
const AnalysisTemplate* template_of(const std::string& model);

/// The analysis under the template's title, in the language of its reader, with the assets and analyses that
/// it uses, last of its analyses; tables of files are in it. Error: the example cannot be read, or has no
/// such analysis.
Result<Project> template_project(const AnalysisTemplate& wanted, const DocumentLanguage& in = {});

/// `project` with the template's analysis at the end. In place of the template's assets stand those of the
/// project of the same kind, one for one; those with which the analysis has a value before others, but also
/// where it has none: what is wrong with them is then said of it. One that nothing uses and that was given no
/// place takes that of the template's, where it has a value only from there. What the project has none of
/// comes with the analysis. Designs and studies name assets: with them nothing is put in another's place.
/// Gives the id of the analysis.
Result<std::string> add_template(Project& project, const AnalysisTemplate& wanted,
                                 const DocumentLanguage& in = {});

}  // namespace covaria
