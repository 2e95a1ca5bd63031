// The table that a design chooses from, and problems of designs.
#pragma once

#include <optional>

#include "core/project/study_target.h"

namespace covaria {

/// Candidates of a design: the rows of a table of the project, and behind them those of its CSV file.
struct DesignTable {
    std::size_t asset = StudyTarget::analysis;  ///< index of the asset in Project::assets
    std::string key = {};                       ///< key of the table's field
    Text title = {};                            ///< title of the table: "Sensors"
    SetupTable rows = {};
    std::size_t present = 0;  ///< number of rows of the project's own table
    std::size_t least = 0;    ///< number of rows that the field needs
};

/// The table that a choice is made from; empty after an error. Problems have paths below the choice
/// ("/table", "/candidates").
std::optional<DesignTable> find_design_table(const Project& project, const AnalysisEntry& analysis,
                                             const DesignChoice& choice, Problems& problems);

/// A table, of the analysis or of an asset that it uses, which a design could choose from, with its title
/// ("Sensors", "tracker: Targets").
struct DesignTableOffer {
    DesignChoice choice;
    Text title;
};
std::vector<DesignTableOffer> tables_to_choose_from(const Project& project, const AnalysisEntry& analysis);

/// Reports problems of the designs of one analysis, with paths relative to it
/// ("/designs/0/variables/1/target"). `outputs` and `inputs` are null when the model could not be made.
void check_designs(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                   const std::vector<OutputQuantity>* outputs, Problems& problems);

}  // namespace covaria
