#include "core/made/analysis_making.h"

#include <algorithm>
#include <cctype>

#include "core/kinds/registries.h"
#include "core/project/design_check.h"
#include "core/project/input_edits.h"
#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/project/stated_requirements.h"
#include "core/project/study_target.h"
#include "core/propagation/forecast.h"
#include "core/setup/setup_schema.h"

namespace covaria {

namespace {

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

// A result without any uncertainty is no result of a measurement: nobody has stated one yet.
void warn_without_uncertainty(const InputSet& inputs, Problems& problems) {
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i)
        if (standard_uncertainty_of(inputs, i) > 0.0) return;
    problems.warning("/inputs", tell<"no input quantity has an uncertainty, so that U is 0 everywhere: state "
                                     "the uncertainties of what the analysis uses">());
}

// Words for the trials that an adaptive run needs; a run that would end at its cap is warned of.
Message forecast_trials(const PropagatedModel& model, const EvaluationOptions& options, Problems& problems) {
    if (options.method != Method::adaptive || !model.propagation()) return {};
    const auto forecast = forecast_adaptive(*model.model(), *model.propagation(), options);
    if (forecast && forecast->trials > static_cast<double>(options.maximum_trials))
        problems.warning("/options/tolerance",
                         tell<"%1; the run is to end at %2 trials and will not be stable then. Choose a "
                              "larger tolerance or fewer digits">(forecast->words(), options.maximum_trials));
    return forecast ? forecast->words() : Message{};
}

}  // namespace

AnalysisMaking::AnalysisMaking(const MadeProject& project, std::size_t index, AnalysisBefore before,
                               MakingCounts& counts)
    : project_(project),
      number_(project.graph().number_of_analysis(index)),
      entry_(project.project().analyses[index]),
      references_(project.graph().references(number_)),
      descriptor_(find_model(entry_.model)),
      before_(std::move(before)),
      counts_(counts),
      made_(std::make_shared<MadeAnalysis>()) {}

std::shared_ptr<const MadeAnalysis> AnalysisMaking::make_own(making::Uses uses, AssetLibrary assets) {
    made_->name = entry_.name;
    made_->options = effective_options(project_.project(), entry_);
    made_->style = project_.project().results.style;
    made_->uses = std::move(uses);
    made_->assets = std::move(assets);
    if (!descriptor_) {
        made_->of_own.error("/model", unknown_model(entry_));
        return made_;
    }
    make_model();
    made_->of_own.take(made_->of_model, "/setup");
    make_inputs();
    made_->of_own.take(made_->of_edits, "");
    return made_;
}

void AnalysisMaking::finish() {
    find_upstream();
    compose();
    prepare();
    check_studies();
}

bool AnalysisMaking::model_stays() const {
    return before_.entry && before_.entry->model == entry_.model && before_.entry->setup == entry_.setup &&
           making::stay(made_->uses, before_.made->uses);
}

bool AnalysisMaking::edits_stay() const {
    return before_.entry && before_.entry->inputs == entry_.inputs &&
           before_.entry->correlations == entry_.correlations;
}

bool AnalysisMaking::chain_stays() const {
    const auto& upstream = made_->upstream;
    return model_stays() && edits_stay() && before_.entry->links == entry_.links &&
           upstream == before_.made->upstream &&
           std::all_of(upstream.begin(), upstream.end(), [](const UsedAnalysis& u) { return u.model; });
}

bool AnalysisMaking::choices_stay() const {
    return before_.entry && before_.made->options == made_->options && before_.made->style == made_->style &&
           before_.entry->requirements == entry_.requirements;
}

// Assets, and what stands for analyses where the set-up refers to them.
AssetLibrary AnalysisMaking::with_offers() const {
    AssetLibrary assets = made_->assets;
    for (std::size_t i = 0; i < references_.size(); ++i)
        if (const auto* used = dynamic_cast<const MadeAnalysis*>(made_->uses[i].get()))
            if (auto asset = used->model->as_asset(references_[i].id)) {
                const std::string& name = project_.project().find_analysis(references_[i].id)->name;
                assets.add(references_[i].id, {name, nullptr, std::move(asset)});
            }
    return assets;
}

void AnalysisMaking::make_model() {
    if (model_stays()) {
        ++counts_.taken;
        made_->model = before_.made->model;
        made_->of_model = before_.made->of_model;
        return;
    }
    ++counts_.models;
    Problems& problems = made_->of_model;
    check_setup(descriptor_->schema, entry_.setup, problems);
    making::refuse_circles(project_.project(), references_, problems);
    making::check_uses(project_.project(), references_, made_->uses, problems);
    if (problems.has_errors()) return;
    std::shared_ptr<const MeasurementModel> model = making::made_or_problem("", problems, [&] {
        return descriptor_->create(SetupReader(descriptor_->schema, entry_.setup), with_offers(), problems);
    });
    if (!problems.has_errors()) made_->model = std::move(model);
}

void AnalysisMaking::make_inputs() {
    if (!made_->model) return;
    if (model_stays() && edits_stay()) {
        made_->inputs = before_.made->inputs;
        made_->of_edits = before_.made->of_edits;
        return;
    }
    ++counts_.inputs;
    made_->inputs = std::shared_ptr<const InputSet>(made_->model, &made_->model->inputs());
    if (entry_.inputs.empty() && entry_.correlations.empty()) return;
    made_->inputs = making::made_or_problem("/setup", made_->of_edits, [&] {
        return std::make_shared<const InputSet>(apply_edits(made_->model->inputs(), entry_, made_->of_edits));
    });
}

void AnalysisMaking::find_upstream() {
    for (const std::size_t used : project_.graph().used_by(number_)) {
        if (project_.graph().is_asset(used)) continue;
        const AnalysisEntry& entry = project_.project().analyses[used - project_.project().assets.size()];
        const MadeAnalysis& made = *project_.find_analysis(entry.id);
        made_->upstream.push_back({entry.id, entry.name, entry.links, made.model, made.inputs});
        for (const auto& [id, asset] : made.assets.entries()) made_->assets.add(id, asset);
    }
}

ModelOfAnalysis AnalysisMaking::composed() {
    const MakeOwnModel own = [&](const AnalysisEntry& entry, Problems& problems) -> ModelOfAnalysis {
        const MadeAnalysis& made = *project_.find_analysis(entry.id);
        problems.take(made.of_own, "");
        if (!made.model || !made.inputs) return {};
        return {made.model, *made.inputs};
    };
    return making::made_or_problem("/setup", made_->of_chain, [&] {
        return compose_analysis(project_.project(), entry_, {made_->model, *made_->inputs}, own,
                                made_->of_chain);
    });
}

void AnalysisMaking::compose() {
    if (!made_->model || !made_->inputs) return;
    if (chain_stays()) {
        made_->propagated = before_.made->propagated;
        made_->of_chain = before_.made->of_chain;
        return;
    }
    if (has_links(entry_, *made_->inputs)) {
        ModelOfAnalysis chain = composed();
        if (chain.model && !made_->of_edits.has_errors())
            made_->propagated = std::make_shared<const PropagatedModel>(
                std::move(chain.model), std::make_shared<const InputSet>(std::move(chain.inputs)));
        return;
    }
    if (made_->of_edits.has_errors()) return;
    // Other names of assets at most: what was computed stays.
    const bool same_numbers = before_.uses_keep_numbers && before_.entry->model == entry_.model &&
                              before_.entry->setup == entry_.setup && before_.entry->links == entry_.links &&
                              edits_stay() && before_.made->propagated;
    made_->propagated = same_numbers ? std::make_shared<const PropagatedModel>(made_->model, made_->inputs,
                                                                               *before_.made->propagated)
                                     : std::make_shared<const PropagatedModel>(made_->model, made_->inputs);
}

void AnalysisMaking::prepare() {
    if (descriptor_ && chain_stays() && choices_stay()) {
        made_->problems = before_.made->problems;
        made_->prepared = before_.made->prepared;
        if (before_.entry->name == entry_.name || !made_->prepared) return;
        auto renamed = std::make_shared<PreparedAnalysis>(*made_->prepared);
        renamed->name = entry_.name;
        made_->prepared = std::move(renamed);
        return;
    }
    Problems& problems = made_->problems;
    if (descriptor_) check_options(made_->options, problems);
    problems.take(made_->of_own, "");
    problems.take(made_->of_chain, "");
    if (!made_->propagated) return;
    made_->prepared = making::made_or_problem("/setup", problems, [&] { return prepared(); });
}

std::shared_ptr<const PreparedAnalysis> AnalysisMaking::prepared() const {
    Problems& problems = made_->problems;
    const PropagatedModel& propagated = *made_->propagated;
    read_requirements(entry_, propagated.model()->outputs(), problems);
    if (problems.has_errors()) return nullptr;
    warn_without_uncertainty(propagated.inputs(), problems);
    LinkedQuantities linked = quantities_of_links(*propagated.model());
    return std::make_shared<const PreparedAnalysis>(
        PreparedAnalysis{.id = entry_.id,
                         .name = entry_.name,
                         .descriptor = descriptor_,
                         .assets = made_->assets,
                         .propagated = made_->propagated,
                         .model = propagated.model(),
                         .inputs = propagated.inputs(),
                         .linked = std::move(linked.inputs),
                         .linked_points = std::move(linked.points),
                         .options = made_->options,
                         .style = made_->style,
                         .numbers = std::make_shared<const AnalysisNumbers>(project_.snapshot(), entry_.id),
                         .forecast = forecast_trials(propagated, made_->options, problems)});
}

void AnalysisMaking::check_studies() {
    if (entry_.studies.empty() && entry_.designs.empty()) return;
    if (chain_stays() && choices_stay() && before_.assets_stay && before_.entry->studies == entry_.studies &&
        before_.entry->designs == entry_.designs) {
        made_->of_studies = before_.made->of_studies;
        return;
    }
    const PreparedAnalysis* prepared = made_->prepared.get();
    const InputSet* inputs = prepared ? &prepared->inputs : nullptr;
    const auto* outputs = prepared ? &prepared->model->outputs() : nullptr;
    covaria::check_studies(project_.project(), entry_, inputs, outputs, made_->of_studies);
    check_designs(project_.project(), entry_, inputs, outputs, made_->of_studies);
}

}  // namespace covaria
