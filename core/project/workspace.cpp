#include "core/project/workspace.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/base/guarded.h"
#include "core/base/in_quotes.h"
#include "core/base/version.h"
#include "core/kinds/assets.h"
#include "core/kinds/models.h"
#include "core/project/input_edits.h"
#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/project/project_file.h"
#include "core/project/references.h"
#include "core/project/stated_requirements.h"
#include "core/project/study_target.h"
#include "core/propagation/engine.h"
#include "core/propagation/forecast.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

// Problems of a part, added under its place; whether there were errors among them.
bool took_errors(const Problems& part, const std::string& place, Problems& problems) {
    problems.take(part, place);
    return part.has_errors();
}

// What `make` returns; an exception is a problem of the set-up that it was made of.
template <class Make>
auto made_or_problem(const std::string& path, Problems& problems, Make&& make) {
    auto made = guarded(make);
    if (!made) problems.error(path, made.error().message);
    return made ? *std::move(made) : std::invoke_result_t<Make>{};
}

// Makes every asset after those that it refers to.
class AssetMaking {
public:
    AssetMaking(const Project& project, Problems& problems)
        : project_(project), problems_(problems), states_(project.assets.size(), State::waiting) {}

    AssetLibrary make_all() {
        for (std::size_t i = 0; i < project_.assets.size(); ++i) make(i);
        return std::move(library_);
    }

private:
    enum class State { waiting, in_work, done };

    void make(std::size_t i) {
        if (states_[i] != State::waiting) return;
        states_[i] = State::in_work;
        const AssetEntry& entry = project_.assets[i];
        const std::string path = "/assets/" + std::to_string(i);
        const AssetDescriptor* kind = find_asset_kind(entry.kind);
        if (!kind) {
            problems_.error(path + "/kind", unknown_kind(entry));
        } else {
            Problems found;
            const std::shared_ptr<const Asset> asset =
                made_or_problem("", found, [&] { return create(entry, *kind, found); });
            if (!took_errors(found, path + "/setup", problems_) && asset)
                library_.add(entry.id, {entry.name, kind, asset});
        }
        states_[i] = State::done;
    }

    std::shared_ptr<const Asset> create(const AssetEntry& entry, const AssetDescriptor& kind,
                                        Problems& problems) {
        check_setup(kind.schema, entry.setup, problems);
        if (problems.has_errors()) return nullptr;
        for (const AssetReference& reference : references_of(kind.schema, entry.setup))
            make_referred(reference, problems);
        if (problems.has_errors()) return nullptr;
        check_references(project_, library_, kind.schema, entry.setup, problems);
        if (problems.has_errors()) return nullptr;
        auto asset = kind.create(SetupReader(kind.schema, entry.setup), library_, problems);
        return problems.has_errors() ? nullptr : std::move(asset);
    }

    void make_referred(const AssetReference& reference, Problems& problems) {
        const AssetEntry* other = project_.find_asset(reference.id);
        if (!other && project_.find_analysis(reference.id))
            problems.error(reference.path, "'" + reference.title + "' refers to the analysis '" +
                                               reference.id +
                                               "': only analyses take something from analyses");
        if (!other) return;  // named by check_references
        const auto index = static_cast<std::size_t>(other - project_.assets.data());
        if (states_[index] == State::in_work)
            problems.error(reference.path, "'" + reference.title + "' refers to the asset '" + reference.id +
                                               "', which refers back to this one");
        else
            make(index);
    }

    const Project& project_;
    Problems& problems_;
    std::vector<State> states_;
    AssetLibrary library_;
};

// "coverage_probability" -> "coverageProbability": fields of EvaluationOptions as they are called in files.
std::string camel_case(const std::string& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == '_' && i + 1 < words.size())
            text += static_cast<char>(std::toupper(static_cast<unsigned char>(words[++i])));
        else
            text += words[i];
    }
    return text;
}

void check_options(const EvaluationOptions& options, Problems& problems) {
    Problems found;
    options.check(found);
    for (Problem problem : found.items()) {
        problem.path = "/options" + camel_case(problem.path);
        problems.add(problem);
    }
}

// The model of an analysis; null after an error. Paths are relative to the set-up.
std::shared_ptr<const MeasurementModel> make_model(const Project& project, const AnalysisEntry& entry,
                                                   const ModelDescriptor& descriptor,
                                                   const AssetLibrary& assets, Problems& problems) {
    check_setup(descriptor.schema, entry.setup, problems);
    check_references(project, assets, descriptor.schema, entry.setup, problems);
    if (problems.has_errors()) return nullptr;
    auto model = made_or_problem("", problems, [&] {
        return descriptor.create(SetupReader(descriptor.schema, entry.setup), assets, problems);
    });
    return problems.has_errors() ? nullptr : std::shared_ptr<const MeasurementModel>(std::move(model));
}

// Models of analyses without what they take from each other.
class OwnModels {
public:
    OwnModels(const Project& project, const AssetLibrary& assets) : project_(project), assets_(assets) {}

    // Paths are relative to the analysis.
    ModelOfAnalysis make(const AnalysisEntry& entry, Problems& problems) {
        const ModelDescriptor* descriptor = find_model(entry.model);
        if (!descriptor) {
            problems.error("/model", unknown_model(entry));
            return {};
        }
        Problems of_setup;
        ModelOfAnalysis made{make_with_offers(entry, *descriptor, of_setup), {}};
        if (took_errors(of_setup, "/setup", problems) || !made.model) return {};
        made.inputs = apply_edits(made.model->inputs(), entry, problems);
        return made;
    }

private:
    std::shared_ptr<const MeasurementModel> make_with_offers(const AnalysisEntry& entry,
                                                             const ModelDescriptor& descriptor,
                                                             Problems& problems) {
        if (std::find(in_work_.begin(), in_work_.end(), entry.id) != in_work_.end()) {
            problems.error("", "its set-up refers to itself through others");
            return nullptr;
        }
        in_work_.push_back(entry.id);
        AssetLibrary assets = assets_;
        add_offering_analyses(
            project_, entry,
            [this](const AnalysisEntry& other, Problems& found) { return make(other, found); }, assets,
            problems);
        in_work_.pop_back();
        if (problems.has_errors()) return nullptr;
        return make_model(project_, entry, descriptor, assets, problems);
    }

    const Project& project_;
    const AssetLibrary& assets_;
    std::vector<std::string> in_work_;
};

// How many trials an adaptive run needs, in words; a run that would end at its cap is warned of.
std::string forecast_trials(const MeasurementModel& model, const InputSet& inputs,
                            const EvaluationOptions& options, Problems& problems) {
    const auto forecast = forecast_adaptive(model, inputs, options);
    if (forecast && forecast->trials > static_cast<double>(options.maximum_trials))
        problems.warning(
            "/options/tolerance",
            forecast->words() + "; the run is to end at " + std::to_string(options.maximum_trials) +
                " trials and will not be stable then. Choose a larger tolerance or fewer digits");
    return forecast ? forecast->words() : std::string();
}

// A result without any uncertainty is no result of a measurement: nobody has stated one yet.
void warn_without_uncertainty(const InputSet& inputs, Problems& problems) {
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i)
        if (standard_uncertainty_of(inputs, i) > 0.0) return;
    problems.warning("/inputs",
                     "no input quantity has an uncertainty, so that U is 0 everywhere: state the "
                     "uncertainties of what the analysis uses");
}

// What influences the numbers of one analysis: itself and the assets that it uses.
std::string analysis_fingerprint(const Project& project, const AnalysisEntry& entry) {
    Project part;
    for (const std::string& id : assets_used_by(project, entry))
        part.assets.push_back(*project.find_asset(id));
    part.analyses.push_back(entry);
    part.analyses.back().studies.clear();  // they have results, and fingerprints, of their own
    add_used_analyses(project, entry, part);
    return fingerprint(std::move(part));
}

// The assets an analysis uses and no others.
AssetLibrary used_assets(const Project& project, const AnalysisEntry& entry, const AssetLibrary& assets) {
    AssetLibrary used;
    for (const std::string& id : assets_used_by(project, entry))
        if (const AssetLibrary::Entry* asset = assets.find(id)) used.add(id, *asset);
    return used;
}

// Paths are relative to the analysis.
std::shared_ptr<const PreparedAnalysis> prepare(const Project& project, const AnalysisEntry& entry,
                                                const AssetLibrary& assets, Problems& problems) {
    const ModelDescriptor* descriptor = find_model(entry.model);
    if (!descriptor) {
        problems.error("/model", unknown_model(entry));
        return nullptr;
    }
    check_options(entry.options, problems);
    auto prepared = std::make_shared<PreparedAnalysis>();
    prepared->assets = used_assets(project, entry, assets);
    ModelOfAnalysis made = make_model_of(project, entry, prepared->assets, problems);
    if (!made.model) return nullptr;
    prepared->model = std::move(made.model);
    prepared->inputs = std::move(made.inputs);
    read_requirements(entry, prepared->model->outputs(), problems);
    if (problems.has_errors()) return nullptr;
    prepared->linked = linked_inputs(*prepared->model);
    warn_without_uncertainty(prepared->inputs, problems);
    prepared->forecast = forecast_trials(*prepared->model, prepared->inputs, entry.options, problems);
    prepared->id = entry.id;
    prepared->name = entry.name;
    prepared->descriptor = descriptor;
    prepared->options = entry.options;
    prepared->fingerprint = analysis_fingerprint(project, entry);
    return prepared;
}

template <class Entry>
void check_ids(const std::vector<Entry>& entries, const std::string& place, Problems& problems) {
    std::set<std::string> known;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string path = place + "/" + std::to_string(i) + "/id";
        const std::string& id = entries[i].id;
        if (!is_project_id(id))
            problems.error(path, "the id " + in_quotes(id) + " must be made of letters, digits, '-' and '_'");
        else if (!known.insert(id).second)
            problems.error(path, "the id " + in_quotes(id) + " is used twice");
    }
}

}  // namespace

bool is_project_id(const std::string& id) {
    return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

std::vector<std::string> warnings_of(const Project& project, const std::string& analysis_id,
                                     const Problems& of_assets, const Problems& of_analysis) {
    std::vector<std::string> warnings;
    const AnalysisEntry* entry = project.find_analysis(analysis_id);
    for (const std::string& id : entry ? assets_used_by(project, *entry) : std::vector<std::string>()) {
        const auto index = project.find_asset(id) - project.assets.data();
        const std::string place = "/assets/" + std::to_string(index) + "/";
        for (const Problem& problem : of_assets.items())
            if (problem.severity == Severity::warning && problem.path.starts_with(place))
                warnings.push_back("asset " + id + ": " + problem.message);
    }
    for (const Problem& problem : of_analysis.items())
        if (problem.severity == Severity::warning) warnings.push_back(problem.message);
    return warnings;
}

ModelOfAnalysis make_model_of(const Project& project, const AnalysisEntry& entry, const AssetLibrary& assets,
                              Problems& problems) {
    OwnModels models(project, assets);
    const MakeOwnModel make_own = [&](const AnalysisEntry& other, Problems& found) {
        return models.make(other, found);
    };
    return compose_analysis(project, entry, make_own(entry, problems), make_own, problems);
}

std::shared_ptr<const Asset> make_asset_of(const AssetEntry& entry, const AssetLibrary& assets,
                                           Problems& problems) {
    const AssetDescriptor* kind = find_asset_kind(entry.kind);
    if (!kind) {
        problems.error("/kind", unknown_kind(entry));
        return nullptr;
    }
    Problems found;
    check_setup(kind->schema, entry.setup, found);
    std::shared_ptr<const Asset> asset;
    if (!found.has_errors())
        asset = made_or_problem(
            "", found, [&] { return kind->create(SetupReader(kind->schema, entry.setup), assets, found); });
    return took_errors(found, "/setup", problems) ? nullptr : asset;
}

AssetLibrary make_assets(const Project& project, Problems& problems) {
    return AssetMaking(project, problems).make_all();
}

std::shared_ptr<const PreparedAnalysis> prepare_analysis(const Project& project,
                                                         const std::string& analysis_id,
                                                         const AssetLibrary& assets, Problems& problems) {
    const AnalysisEntry* entry = project.find_analysis(analysis_id);
    if (!entry) {
        std::vector<std::string> ids;
        for (const AnalysisEntry& analysis : project.analyses) ids.push_back(analysis.id);
        problems.error("", "there is no analysis " + in_quotes(analysis_id) + did_you_mean(analysis_id, ids));
        return nullptr;
    }
    Problems found;
    auto prepared = made_or_problem("/setup", found, [&] { return prepare(project, *entry, assets, found); });
    problems.take(found, "/analyses/" + std::to_string(entry - project.analyses.data()));
    return prepared;
}

void check_project(const Project& project, Problems& problems) {
    check_ids(project.assets, "/assets", problems);
    check_ids(project.analyses, "/analyses", problems);
    const AssetLibrary assets = make_assets(project, problems);
    for (std::size_t i = 0; i < project.analyses.size(); ++i) {
        Problems found;
        const AnalysisEntry& entry = project.analyses[i];
        const auto prepared =
            made_or_problem("/setup", found, [&] { return prepare(project, entry, assets, found); });
        check_studies(project, entry, prepared ? &prepared->inputs : nullptr,
                      prepared ? &prepared->model->outputs() : nullptr, found);
        problems.take(found, "/analyses/" + std::to_string(i));
    }
}

namespace {

Result<UncertaintyResult> run_unguarded(const PreparedAnalysis& analysis, const RunControl& control) {
    auto result = evaluate(*analysis.model, analysis.inputs, analysis.options, control);
    if (!result) return result;
    result->provenance.project_fingerprint = analysis.fingerprint;
    result->provenance.covaria_version = version();
    result->provenance.seed = analysis.options.seed;
    return result;
}

}  // namespace

Result<UncertaintyResult> run_analysis(const PreparedAnalysis& analysis, const RunControl& control) {
    auto result = guarded([&] { return run_unguarded(analysis, control); });
    if (!result) return fail(result.error());
    return *std::move(result);
}

}  // namespace covaria
