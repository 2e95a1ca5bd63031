// Descriptor of a kind of measurement model: what the program knows without having a model.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/model/asset.h"
#include "core/model/measurement_model.h"
#include "core/setup/setup_schema.h"

namespace covaria {

struct ModelDescriptor {
    std::string id;  ///< its name in files: lower-case words joined by hyphens
    std::string title;
    std::string summary;
    std::vector<Reference> references;
    std::vector<ModelEquation> equations;
    std::vector<std::string> notes;  ///< deviations from the paper, conventions, limits of validity
    std::string help_page;           ///< file in resources/help
    std::string example;             ///< file in projects/
    /// Capabilities of `as_asset`: an analysis may stand where a reference asks for an asset with one.
    std::vector<std::string> capabilities = {};
    /// Whether rows of the evaluation bear verdicts (`TestVerdict`), which then count where a project is
    /// judged.
    bool decides = false;
    std::string was_asset = {};  ///< the kind of asset that it was in project files of version 1
    SetupSchema schema;
    /// Null if `problems` got an error (paths relative to the set-up). `setup` has passed check_setup and its
    /// references exist. Warnings may be added to `problems` beside a model.
    std::function<std::unique_ptr<MeasurementModel>(const SetupReader& setup, const AssetLibrary& assets,
                                                    Problems& problems)>
        create;
    /// Adds to a copy what the set-up implies and does not have yet (rows for the names in an equation);
    /// empty: nothing is ever implied.
    std::function<Setup(const Setup& setup)> completed = {};
};

}  // namespace covaria
