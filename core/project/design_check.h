// The table that a design chooses from, and problems of designs.
#pragma once

#include <optional>

#include "core/project/study_target.h"

namespace covaria {

/// Candidates of a design: the rows of a table of the project, and behind them those of its CSV file.
struct DesignTable {
    std::size_t asset = StudyTarget::analysis;  ///< index in Project::assets
    std::string key = {};                       ///< of the field
    Text title = {};                            ///< "Sensors"
    SetupTable rows = {};
    std::size_t present = 0;  ///< of the project's table
    std::size_t least = 0;    ///< rows that the field needs
};

/// Problems have paths below the choice ("/table", "/candidates"); empty after an error.
std::optional<DesignTable> find_design_table(const Project& project, const AnalysisEntry& analysis,
                                             const DesignChoice& choice, Problems& problems);

/// The tables of the analysis and of the assets that it uses which a design could choose from, with their
/// titles ("Sensors", "tracker: Targets").
struct DesignTableOffer {
    DesignChoice choice;
    Text title;
};
std::vector<DesignTableOffer> tables_to_choose_from(const Project& project, const AnalysisEntry& analysis);

/// Problems of the designs of one analysis, paths relative to it ("/designs/0/variables/1/target").
/// `outputs` and `inputs` are null when the model could not be made.
void check_designs(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                   const std::vector<OutputQuantity>* outputs, Problems& problems);

}  // namespace covaria
