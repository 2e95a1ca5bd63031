// A project: a value of a few kilobytes. Assets are defined once and referred to by id; analyses use them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/project/asset_certificate.h"
#include "core/project/certificate.h"
#include "core/project/design.h"
#include "core/project/kept_state.h"
#include "core/project/project_results.h"
#include "core/project/report_contents.h"
#include "core/project/saved_view.h"
#include "core/project/study.h"
#include "core/propagation/options.h"
#include "core/quantity/distribution.h"
#include "core/quantity/input_quantity.h"
#include "core/result/guard_rule.h"
#include "core/setup/setup.h"

namespace covaria {

struct AssetEntry {
    std::string id = {};    ///< unique in the project: letters, digits, '-' and '_'
    std::string kind = {};  ///< of the asset registry
    std::string name = {};
    std::string notes = {};
    Setup setup = {};
    std::vector<AssetCertificate> certificates = {};  ///< that its figures come from; none: they are assumed
    bool operator==(const AssetEntry&) const = default;
};

/// A component as typed: the distribution's kind and parameters in `unit`.
struct ComponentEdit {
    std::string name = {};
    std::string distribution;        ///< key of distribution_kinds()
    std::vector<double> parameters;  ///< in the order of distribution_kinds(), in `unit`
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
    std::optional<std::vector<ComponentEdit>> components = {};  ///< replaces all own components
    std::optional<Combination> combination = {};
    bool held = false;
    bool operator==(const InputEdit&) const = default;
};

/// What people wrote about one input quantity: why this figure, what was agreed. No result depends on it.
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
    std::optional<Quantity> target_uncertainty = {};  ///< U must not exceed this
    // Conformity with a tolerance (JCGM 106, ISO 14253-1).
    std::optional<Quantity> lower_limit = {}, upper_limit = {};
    double guard_factor = 1.0;  ///< guard bands of this times U inside the tolerance; 0: simple acceptance
    /// What is known before the measurement: normal; for the global risks of a decision rule.
    std::optional<Quantity> prior_mean = {}, prior_standard_deviation = {};
    GuardRule guard_rule = GuardRule::factor;
    double target_risk = 0.02;  ///< of the rules that are made for one
    bool operator==(const Requirement&) const = default;
};

/// An input quantity whose value is an output of another analysis: the models are composed.
struct InputLink {
    std::string input;  ///< symbol
    OutputReference output;
    bool linearised = false;  ///< the other analysis is replaced by its law of propagation, for speed
    bool operator==(const InputLink&) const = default;
};

struct AnalysisEntry {
    std::string id = {};
    std::string model = {};  ///< of the model registry
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
    std::vector<SavedView> views = {};  ///< of its scene
    std::vector<QuantityNotes> quantity_notes = {};
    /// Date of the measurement, or an interval of two; empty: that of the project's certificate.
    std::string measured = {};
    std::vector<AssetCertificate> certificates = {};  ///< that figures stated in its own set-up come from
    bool operator==(const AnalysisEntry&) const = default;
};

struct Project {
    std::string title = {};
    std::string notes = {};
    std::string author = {};
    std::string number = {};  ///< by which the author's house knows it
    Certificate certificate = {};
    ReportContents report = {};
    ProjectResults results = {};
    std::vector<AssetEntry> assets = {};
    std::vector<AnalysisEntry> analyses = {};
    std::vector<KeptState> kept = {};      ///< one of an analysis at most; no result depends on them
    std::filesystem::path directory = {};  ///< where CSV files are looked for; not saved, not compared

    const AssetEntry* find_asset(const std::string& id) const;
    const AnalysisEntry* find_analysis(const std::string& id) const;
    bool operator==(const Project& other) const {
        return title == other.title && notes == other.notes && author == other.author &&
               number == other.number && results == other.results && certificate == other.certificate &&
               report == other.report && assets == other.assets && analyses == other.analyses &&
               kept == other.kept;
    }
};

/// The options of an analysis with what the project states for all: what it is evaluated by.
EvaluationOptions effective_options(const Project& project, const AnalysisEntry& analysis);

}  // namespace covaria
