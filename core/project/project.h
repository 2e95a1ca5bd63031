// A project: a value of a few kilobytes. Assets are defined once and referred to by id; analyses use them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/project/amendment.h"
#include "core/project/asset_certificate.h"
#include "core/project/certificate.h"
#include "core/project/design.h"
#include "core/project/kept_state.h"
#include "core/project/project_results.h"
#include "core/project/report_contents.h"
#include "core/project/review.h"
#include "core/project/saved_view.h"
#include "core/project/study.h"
#include "core/propagation/options.h"
#include "core/quantity/distribution.h"
#include "core/quantity/input_quantity.h"
#include "core/result/guard_rule.h"
#include "core/setup/setup.h"

namespace covaria {

struct AssetEntry {
    std::string id = {};    ///< id, unique in the project: letters, digits, '-' and '_'
    std::string kind = {};  ///< kind of the asset registry
    std::string name = {};
    std::string notes = {};
    Setup setup = {};
    /// Certificates that the figures come from; none: they are assumed.
    std::vector<AssetCertificate> certificates = {};
    bool operator==(const AssetEntry&) const = default;
};

/// A component as it was typed: the distribution's kind and parameters in `unit`.
struct ComponentEdit {
    std::string name = {};
    std::string distribution;        ///< key of distribution_kinds()
    std::vector<double> parameters;  ///< parameters in the order of distribution_kinds(), in `unit`
    Unit unit = {};
    EvaluationType type = EvaluationType::type_b;
    std::optional<double> degrees_of_freedom = {};
    std::string origin = {};
    bool operator==(const ComponentEdit&) const = default;
};

/// Changes to one input quantity of a model, by symbol. Empty fields leave the model's default.
struct InputEdit {
    std::string symbol = {};
    std::optional<Quantity> estimate = {};
    std::optional<std::vector<ComponentEdit>> components = {};  ///< components that replace all own ones
    std::optional<Combination> combination = {};
    bool held = false;
    bool operator==(const InputEdit&) const = default;
};

/// Notes of people on one input quantity: why this figure, what was agreed. No result depends on them.
struct QuantityNotes {
    std::string symbol = {};
    std::string notes = {};
    bool operator==(const QuantityNotes&) const = default;
};

struct CorrelationEdit {
    std::string first, second;  ///< ids of components, or symbols of quantities as a whole
    double coefficient = 0.0;
    bool operator==(const CorrelationEdit&) const = default;
};

/// Target or tolerance for an output.
struct Requirement {
    std::string group, symbol;
    std::optional<Quantity> target_uncertainty = {};  ///< limit that U must not exceed
    // Limits and rules for conformity with a tolerance (JCGM 106, ISO 14253-1).
    std::optional<Quantity> lower_limit = {}, upper_limit = {};
    /// Multiple of U that guard bands have inside the tolerance; 0: simple acceptance.
    double guard_factor = 1.0;
    /// Knowledge before the measurement, a normal distribution, for the global risks of a decision rule.
    std::optional<Quantity> prior_mean = {}, prior_standard_deviation = {};
    GuardRule guard_rule = GuardRule::factor;
    double target_risk = 0.02;  ///< risk of the rules that are made for one
    bool operator==(const Requirement&) const = default;
};

/// An input quantity whose value is an output of another analysis: the models are composed.
struct InputLink {
    std::string input;  ///< symbol of the input quantity
    OutputReference output;
    bool linearised = false;  ///< whether the other analysis is replaced by its law of propagation, for speed
    bool operator==(const InputLink&) const = default;
};

struct AnalysisEntry {
    std::string id = {};
    std::string model = {};  ///< model of the model registry
    std::string name = {};
    std::string notes = {};
    Setup setup = {};
    std::vector<InputLink> links = {};
    std::vector<InputEdit> inputs = {};
    std::vector<CorrelationEdit> correlations = {};
    EvaluationOptions options = {};
    std::vector<Requirement> requirements = {};
    std::vector<Study> studies = {};
    std::vector<Design> designs = {};
    std::vector<SavedView> views = {};  ///< views of its scene
    std::vector<QuantityNotes> quantity_notes = {};
    /// Date of the measurement, or an interval of two; empty: the one of the project's certificate.
    std::string measured = {};
    /// Certificates that the figures stated in its own set-up come from.
    std::vector<AssetCertificate> certificates = {};
    bool operator==(const AnalysisEntry&) const = default;
};

struct Project {
    std::string title = {};
    std::string notes = {};
    std::string author = {};
    std::string number = {};  ///< number by which the author's house knows the project
    Review review = {};
    Certificate certificate = {};
    /// Statements of the certificate that this one replaces.
    Amendment amendment = {};
    ReportContents report = {};
    ProjectResults results = {};
    std::vector<AssetEntry> assets = {};
    std::vector<AnalysisEntry> analyses = {};
    /// Kept states, at most one for an analysis; no result depends on them.
    std::vector<KeptState> kept = {};
    /// Folder where CSV files are looked for; neither saved nor compared.
    std::filesystem::path directory = {};

    const AssetEntry* find_asset(const std::string& id) const;
    const AnalysisEntry* find_analysis(const std::string& id) const;
    bool operator==(const Project& other) const {
        return title == other.title && notes == other.notes && author == other.author &&
               number == other.number && review == other.review && results == other.results &&
               certificate == other.certificate && amendment == other.amendment && report == other.report &&
               assets == other.assets && analyses == other.analyses && kept == other.kept;
    }
};

/// The options that an analysis is evaluated by: its own, with those that the project states for all.
EvaluationOptions effective_options(const Project& project, const AnalysisEntry& analysis);

}  // namespace covaria
