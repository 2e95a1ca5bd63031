#include "core/made/analysis_making.h"

#include <cctype>

#include "core/kinds/models.h"
#include "core/project/input_edits.h"
#include "core/project/kind_lookup.h"
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
    problems.warning("/inputs",
                     "no input quantity has an uncertainty, so that U is 0 everywhere: state the "
                     "uncertainties of what the analysis uses");
}

// How many trials an adaptive run needs, in words; a run that would end at its cap is warned of.
std::string forecast_trials(const PropagatedModel& model, const EvaluationOptions& options,
                            Problems& problems) {
    if (options.method != Method::adaptive || !model.propagation()) return {};
    const auto forecast = forecast_adaptive(*model.model(), *model.propagation(), options);
    if (forecast && forecast->trials > static_cast<double>(options.maximum_trials))
        problems.warning(
            "/options/tolerance",
            forecast->words() + "; the run is to end at " + std::to_string(options.maximum_trials) +
                " trials and will not be stable then. Choose a larger tolerance or fewer digits");
    return forecast ? forecast->words() : std::string();
}

}  // namespace

AnalysisMaking::AnalysisMaking(const MadeProject& project, std::size_t index, AnalysisBefore before,
                               MakingCounts& counts)
    : project_(project),
      entry_(project.project().analyses[index]),
      references_(project.graph().references(project.graph().number_of_analysis(index))),
      descriptor_(find_model(entry_.model)),
      before_(std::move(before)),
      counts_(counts),
      made_(std::make_shared<MadeAnalysis>()) {}

std::shared_ptr<const MadeAnalysis> AnalysisMaking::make(making::Uses uses, AssetLibrary assets) {
    made_->uses = std::move(uses);
    made_->assets = std::move(assets);
    if (!descriptor_) {
        made_->problems.error("/model", unknown_model(entry_));
    } else {
        make_model();
        make_inputs();
        prepare();
    }
    check_studies();
    return made_;
}

bool AnalysisMaking::model_stays() const {
    return before_.entry && before_.entry->model == entry_.model && before_.entry->setup == entry_.setup &&
           making::stay(made_->uses, before_.made->uses);
}

bool AnalysisMaking::edits_stay() const {
    return before_.entry && before_.entry->inputs == entry_.inputs &&
           before_.entry->correlations == entry_.correlations;
}

bool AnalysisMaking::choices_stay() const {
    return before_.entry && before_.entry->options == entry_.options &&
           before_.entry->requirements == entry_.requirements;
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
    making::refuse_circles(references_, problems);
    making::check_uses(project_.project(), references_, made_->uses, problems);
    if (problems.has_errors()) return;
    std::shared_ptr<const MeasurementModel> model = making::made_or_problem("", problems, [&] {
        return descriptor_->create(SetupReader(descriptor_->schema, entry_.setup), made_->assets, problems);
    });
    if (!problems.has_errors()) made_->model = std::move(model);
}

void AnalysisMaking::make_inputs() {
    if (!made_->model) return;
    if (model_stays() && edits_stay()) {
        made_->propagated = before_.made->propagated;
        made_->of_edits = before_.made->of_edits;
        return;
    }
    ++counts_.inputs;
    std::shared_ptr<const InputSet> inputs(made_->model, &made_->model->inputs());
    if (!entry_.inputs.empty() || !entry_.correlations.empty())
        inputs = making::made_or_problem("/setup", made_->of_edits, [&] {
            return std::make_shared<const InputSet>(
                apply_edits(made_->model->inputs(), entry_, made_->of_edits));
        });
    if (made_->of_edits.has_errors()) return;
    // Other names of assets at most: what was computed stays.
    const bool same_numbers = before_.uses_keep_numbers && before_.entry->model == entry_.model &&
                              before_.entry->setup == entry_.setup && edits_stay() &&
                              before_.made->propagated;
    made_->propagated = same_numbers
                            ? std::make_shared<const PropagatedModel>(made_->model, std::move(inputs),
                                                                      *before_.made->propagated)
                            : std::make_shared<const PropagatedModel>(made_->model, std::move(inputs));
}

void AnalysisMaking::prepare() {
    if (model_stays() && edits_stay() && choices_stay()) {
        made_->problems = before_.made->problems;
        made_->prepared = before_.made->prepared;
        if (before_.entry->name == entry_.name || !made_->prepared) return;
        auto renamed = std::make_shared<PreparedAnalysis>(*made_->prepared);
        renamed->name = entry_.name;
        made_->prepared = std::move(renamed);
        return;
    }
    Problems& problems = made_->problems;
    check_options(entry_.options, problems);
    problems.take(made_->of_model, "/setup");
    problems.take(made_->of_edits, "");
    if (!made_->propagated) return;
    made_->prepared = making::made_or_problem("/setup", problems, [&] { return prepared(); });
}

std::shared_ptr<const PreparedAnalysis> AnalysisMaking::prepared() const {
    Problems& problems = made_->problems;
    read_requirements(entry_, made_->model->outputs(), problems);
    if (problems.has_errors()) return nullptr;
    const PropagatedModel& propagated = *made_->propagated;
    warn_without_uncertainty(propagated.inputs(), problems);
    return std::make_shared<const PreparedAnalysis>(
        PreparedAnalysis{.id = entry_.id,
                         .name = entry_.name,
                         .descriptor = descriptor_,
                         .assets = made_->assets,
                         .propagated = made_->propagated,
                         .model = made_->model,
                         .inputs = propagated.inputs(),
                         .options = entry_.options,
                         .numbers = std::make_shared<const AnalysisNumbers>(project_.snapshot(), entry_.id),
                         .forecast = forecast_trials(propagated, entry_.options, problems)});
}

void AnalysisMaking::check_studies() {
    if (entry_.studies.empty()) return;
    if (model_stays() && edits_stay() && choices_stay() && before_.assets_stay &&
        before_.entry->studies == entry_.studies) {
        made_->of_studies = before_.made->of_studies;
        return;
    }
    const PreparedAnalysis* prepared = made_->prepared.get();
    covaria::check_studies(project_.project(), entry_, prepared ? &prepared->inputs : nullptr,
                           prepared ? &prepared->model->outputs() : nullptr, made_->of_studies);
}

}  // namespace covaria
