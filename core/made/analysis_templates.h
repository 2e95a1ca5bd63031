// Templates of a new analysis: an analysis of a shipped example with all it uses, so that it has results at
// once.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/text/document_language.h"

namespace covaria {

struct AnalysisTemplate {
    /// The subject of the question.
    enum class Topic { equation, points, pose, robot } topic = Topic::equation;
    std::string title;     ///< "Pose of a robot's flange from a laser tracker"
    std::string question;  ///< question that it answers
    std::string
        example;  ///< file of the example, without its ending, in the folder of examples: "gum/h1-end-gauge"
    std::string analysis;       ///< id in the example
    bool with_designs = false;  ///< its studies and designs are what it is about
};

/// All templates by what is asked; each model has at least one.
const std::vector<AnalysisTemplate>& analysis_templates();
/// The first template of the model; null: none is shipped.
const AnalysisTemplate* template_of(const std::string& model);
/// Templates with an asset of the same sort among what they use, in whose place this one can stand.
std::vector<const AnalysisTemplate*> templates_with(const AssetEntry& asset);

/// The analysis under the template's title, in the language of its reader, with the assets and analyses that
/// it uses, last of its analyses; tables of files are in it. Error: the example cannot be read, or has no
/// such analysis.
Result<Project> template_project(const AnalysisTemplate& wanted, const DocumentLanguage& in = {});

/// Adds the template's analysis to `project`, at the end. In place of the template's assets stand those of
/// the project of the same kind, one for one; those with which the analysis has a value before others, but
/// also where it has none: what is wrong is then said of them. One that nothing uses and that has no place
/// takes that of the template's, where it has a value only from there. Assets that the project lacks come
/// with the analysis. Designs and studies name assets: with them nothing is put in another's place.
/// Gives the id of the analysis.
Result<std::string> add_template(Project& project, const AnalysisTemplate& wanted,
                                 const DocumentLanguage& in = {});

}  // namespace covaria
