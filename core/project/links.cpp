#include "core/project/links.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/temperature.h"
#include "core/model/composed_model.h"
#include "core/model/linearised_model.h"
#include "core/project/analysis_fields.h"
#include "core/project/edit_fields.h"
#include "core/project/entry_names.h"
#include "core/project/kind_lookup.h"
#include "core/project/references.h"
#include "core/propagation/engine.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr std::size_t deepest_chain = 64;  // analyses one after the other; each is on the stack

/// A link with its place, in the list of links or in the field of the set-up that refers to an analysis.
struct PlacedLink {
    InputLink link;
    std::string path;
};

std::vector<PlacedLink> links_of(const AnalysisEntry& entry, const InputSet& inputs) {
    std::vector<PlacedLink> links;
    for (std::size_t i = 0; i < entry.links.size(); ++i)
        links.push_back({entry.links[i], analysis_fields().place(&AnalysisEntry::links, i)});
    for (const InputQuantity& quantity : inputs.quantities) {
        const bool given = std::any_of(entry.links.begin(), entry.links.end(),
                                       [&](const InputLink& link) { return link.input == quantity.symbol; });
        if (quantity.taken_from && !given)
            links.push_back({{quantity.symbol, *quantity.taken_from, false}, "/setup"});
    }
    return links;
}

std::string words_of(const std::string& group, const std::string& symbol) {
    return group.empty() ? symbol : group + ": " + symbol;
}

/// Whether every quantity that the component is part of takes its value from elsewhere.
bool only_in_linked(const InputSet& inputs, std::size_t component, const std::set<std::string>& linked) {
    bool found = false;
    for (const InputQuantity& quantity : inputs.quantities)
        for (const Share& share : quantity.shares) {
            if (share.component != component) continue;
            if (!linked.contains(quantity.symbol)) return false;
            found = true;
        }
    return found;
}

/// Refuses edits and correlations of quantities that are taken from elsewhere, because they have no effect.
void refuse_idle_edits(const AnalysisEntry& entry, const InputSet& inputs, Problems& problems) {
    std::set<std::string> linked;
    for (const PlacedLink& placed : links_of(entry, inputs)) linked.insert(placed.link.input);
    const auto refuse = [&](const std::string& symbol, const std::string& path) {
        std::set<std::string> names = linked;
        for (std::size_t c = 0; c < inputs.components.size(); ++c)
            if (only_in_linked(inputs, c, linked)) names.insert(inputs.components[c].id);
        if (names.contains(symbol))
            problems.error(path, tell<"%1 is taken from another analysis, with all its uncertainty: remove "
                                      "either this or the link">(in_quotes(symbol)));
    };
    for (std::size_t i = 0; i < entry.inputs.size(); ++i)
        refuse(entry.inputs[i].symbol, analysis_fields().place(&AnalysisEntry::inputs, i) +
                                           input_edit_fields().place(&InputEdit::symbol));
    for (std::size_t i = 0; i < entry.correlations.size(); ++i) {
        const std::string path = analysis_fields().place(&AnalysisEntry::correlations, i);
        refuse(entry.correlations[i].first, path + correlation_fields().place(&CorrelationEdit::first));
        refuse(entry.correlations[i].second, path + correlation_fields().place(&CorrelationEdit::second));
    }
}

}  // namespace

Message chain_too_long() {
    return tell<"more than %1 analyses feed each other in a row: put the equations of some of them into one">(
        deepest_chain);
}

namespace {

/// Puts the parts of a chain in order, upstream first, each analysis once.
class ChainMaker {
public:
    ChainMaker(const Project& project, const MakeOwnModel& make_own, std::vector<std::string> path = {})
        : project_(project), make_own_(make_own), path_(std::move(path)) {}

    /// The chain that ends with this analysis.
    ModelOfAnalysis make(const AnalysisEntry& entry, ModelOfAnalysis own, Problems& problems) {
        if (!add(entry, own, problems)) return {};
        if (parts_.size() == 1) return own;
        auto chain = std::make_shared<ComposedModel>(std::move(parts_));
        for (const Message& name : chain->kept_apart())
            problems.warning(analysis_fields().place(&AnalysisEntry::links),
                             tell<"the component %1 is not stated alike (held, or edited) by all analyses of "
                                  "the chain: they are taken as independent">(in_quotes(name)));
        InputSet inputs = chain->inputs();
        if (const auto resolved = resolved_correlations(inputs); !resolved)
            problems.error(analysis_fields().place(&AnalysisEntry::links), resolved.error().message);
        if (problems.has_errors()) return {};
        return {std::move(chain), std::move(inputs)};
    }

private:
    using Index = std::optional<std::size_t>;

    Index add(const AnalysisEntry& entry, const ModelOfAnalysis& own, Problems& problems) {
        refuse_idle_edits(entry, own.inputs, problems);
        path_.push_back(entry.id);
        ChainPart part{entry.id, entry.name, own.model, own.inputs, {}};
        std::set<std::string> linked;
        for (const PlacedLink& placed : links_of(entry, own.inputs)) {
            if (!linked.insert(placed.link.input).second)
                problems.error(placed.path + link_fields().place(&InputLink::input),
                               tell<"%1 is linked twice">(in_quotes(placed.link.input)));
            else if (const auto link = resolve(placed, own.inputs, problems))
                part.links.push_back(*link);
        }
        path_.pop_back();
        if (problems.has_errors()) return {};
        parts_.push_back(std::move(part));
        return parts_.size() - 1;
    }

    std::optional<ModelLink> resolve(const PlacedLink& placed, const InputSet& inputs, Problems& problems) {
        const InputLink& link = placed.link;
        const std::size_t input = inputs.find(link.input);
        if (input == InputSet::npos) {
            std::vector<std::string> known;
            for (const InputQuantity& quantity : inputs.quantities) known.push_back(quantity.symbol);
            problems.error(placed.path + link_fields().place(&InputLink::input),
                           tell<"the model has no input quantity %1%2">(in_quotes(link.input),
                                                                        did_you_mean(link.input, known)));
            return {};
        }
        const Index part = upstream(placed, problems);
        if (!part) return {};
        const Index output = output_of(placed, parts_[*part].model->outputs(), problems);
        if (!output) return {};
        const OutputQuantity& taken = parts_[*part].model->outputs()[*output];
        const Unit& from = taken.unit;
        const Unit& to = inputs.quantities[input].unit;
        if (from.dimension() != to.dimension()) {
            problems.error(
                placed.path + output_reference_fields().place(&OutputReference::symbol),
                tell<"%1 is %2; %3 of %4 is %5">(
                    in_quotes(link.input), dimension_words(to), in_quotes(link.output.symbol),
                    in_quotes(shown_name(project_, link.output.analysis, true)), dimension_words(from)));
            return {};
        }
        const Message objection = taken_objection(
            {tell<"%1 of %2">(in_quotes(taken.symbol), in_quotes(name_of(link.output.analysis))), from,
             taken.temperature},
            {in_quotes(link.input), to});
        if (!objection.empty()) {
            problems.error(placed.path + output_reference_fields().place(&OutputReference::symbol),
                           objection);
            add_remedy(inputs.quantities[input],
                       !is_reading(from, taken.temperature) ? to.interval()
                       : from.has_offset()                  ? from
                                                            : Unit::of("degC"),
                       problems);
            return {};
        }
        return ModelLink{input, *part, *output};
    }

    /// Gives the problem a remedy where the set-up states the quantity's unit: the quantity becomes what is
    /// taken for it.
    void add_remedy(const InputQuantity& quantity, const Unit& unit, Problems& problems) const {
        const AnalysisEntry* entry = project_.find_analysis(path_.back());
        const SetupSchema* schema = entry ? schema_of(*entry) : nullptr;
        if (!schema || !schema->find(&FieldSpec::states_quantities) || quantity.source.empty()) return;
        problems.items().back().remedies = {
            {unit.has_offset() ? tell<"a temperature: %1 in %2">(quantity.symbol, unit.text())
                               : tell<"a difference: %1 in %2">(quantity.symbol, unit.display()),
             {{"/setup" + quantity.source + "/unit", unit.text()}}}};
    }

    Index upstream(const PlacedLink& placed, Problems& problems) {
        const std::string& id = placed.link.output.analysis;
        const AnalysisEntry* entry = project_.find_analysis(id);
        if (!entry) {
            problems.error(
                placed.path + output_reference_fields().place(&OutputReference::analysis),
                tell<"there is no analysis %1%2">(in_quotes(id), did_you_mean_entry(id, project_.analyses)));
            return {};
        }
        if (const auto first = std::find(path_.begin(), path_.end(), id); first != path_.end()) {
            std::string circle;
            for (auto step = first; step != path_.end(); ++step) circle += name_of(*step) + " ← ";
            problems.error(placed.path + output_reference_fields().place(&OutputReference::analysis),
                           of_chain(tell<"the analysis %1 would be made of itself: %2%3">(
                               in_quotes(name_of(path_.back())), circle, name_of(*entry))));
            return {};
        }
        if (path_.size() >= deepest_chain) {
            problems.error(placed.path + output_reference_fields().place(&OutputReference::analysis),
                           of_chain(chain_too_long()));
            return {};
        }
        const auto key = std::make_pair(id, placed.link.linearised);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        Problems found;
        const Index made = placed.link.linearised ? add_linearised(*entry, found) : add_whole(*entry, found);
        if (!made)
            problems.error(placed.path + output_reference_fields().place(&OutputReference::analysis),
                           objection_to(*entry, found));
        return known_[key] = made;
    }

    /// The objection to an analysis further up in the chain, in the words that say it there.
    Message objection_to(const AnalysisEntry& entry, const Problems& found) {
        for (const Problem& problem : found.items()) {
            if (problem.severity != Severity::error) continue;
            if (std::ranges::find(said_of_chain_, problem.message) != said_of_chain_.end())
                return problem.message;
            return of_chain(tell<"the analysis %1 has errors of its own: %2">(in_quotes(name_of(entry)),
                                                                              problem.message));
        }
        return of_chain(tell<"the analysis %1 has no value at its estimates">(in_quotes(name_of(entry))));
    }

    Message of_chain(Message message) {
        said_of_chain_.push_back(message);
        return message;
    }

    /// The name of an entry as the window's tree has it.
    std::string name_of(const AnalysisEntry& entry) const { return name_among(project_.analyses, entry); }
    std::string name_of(const std::string& id) const { return shown_name(project_, id, true); }

    Index add_whole(const AnalysisEntry& entry, Problems& problems) {
        const ModelOfAnalysis own = make_own_(entry, problems);
        if (!own.model || problems.has_errors()) return {};
        return add(entry, own, problems);
    }

    Index add_linearised(const AnalysisEntry& entry, Problems& problems) {
        ModelOfAnalysis own = make_own_(entry, problems);
        if (!own.model || problems.has_errors()) return {};
        ChainMaker maker(project_, make_own_, path_);
        const ModelOfAnalysis chain = maker.make(entry, std::move(own), problems);
        said_of_chain_.insert(said_of_chain_.end(), maker.said_of_chain_.begin(), maker.said_of_chain_.end());
        if (!chain.model) return {};
        auto model = linearised(chain.model, chain.inputs);
        if (!model) return {};
        parts_.push_back({entry.id, entry.name, std::move(model), chain.inputs, {}});
        return parts_.size() - 1;
    }

    Index output_of(const PlacedLink& placed, const std::vector<OutputQuantity>& outputs,
                    Problems& problems) const {
        const OutputReference& wanted = placed.link.output;
        std::vector<std::string> known;
        for (std::size_t j = 0; j < outputs.size(); ++j) {
            if (outputs[j].symbol == wanted.symbol && outputs[j].group == wanted.group) return j;
            known.push_back(words_of(outputs[j].group, outputs[j].symbol));
        }
        const std::string words = words_of(wanted.group, wanted.symbol);
        problems.error(
            placed.path + output_reference_fields().place(&OutputReference::symbol),
            tell<"the analysis %1 has no output %2%3">(in_quotes(shown_name(project_, wanted.analysis, true)),
                                                       in_quotes(words), did_you_mean(words, known)));
        return {};
    }

    const Project& project_;
    const MakeOwnModel& make_own_;
    std::vector<Message> said_of_chain_;  ///< messages that need no words of which analysis has them
    std::vector<std::string> path_;       ///< ids from the analysis that is made to the one in work
    std::map<std::pair<std::string, bool>, Index> known_;
    std::vector<ChainPart> parts_;
};

std::set<std::string> directly_used_by(const Project& project, const AnalysisEntry& entry) {
    std::set<std::string> ids;
    if (const SetupSchema* schema = schema_of(entry))
        for (const AssetReference& reference : references_of(*schema, entry.setup))
            if (!project.find_asset(reference.id)) ids.insert(reference.id);
    for (const InputLink& link : entry.links) ids.insert(link.output.analysis);
    return ids;
}

std::set<std::string> upstream_of(const Project& project, const AnalysisEntry& analysis) {
    std::set<std::string> ids;
    std::vector<const AnalysisEntry*> waiting{&analysis};
    while (!waiting.empty()) {
        const AnalysisEntry& entry = *waiting.back();
        waiting.pop_back();
        for (const std::string& id : directly_used_by(project, entry)) {
            const AnalysisEntry* upstream = project.find_analysis(id);
            if (upstream && ids.insert(id).second) waiting.push_back(upstream);
        }
    }
    return ids;
}

}  // namespace

bool has_links(const AnalysisEntry& entry, const InputSet& inputs) {
    return !links_of(entry, inputs).empty();
}

ModelOfAnalysis compose_analysis(const Project& project, const AnalysisEntry& entry, ModelOfAnalysis own,
                                 const MakeOwnModel& make_own, Problems& problems) {
    if (!own.model || !has_links(entry, own.inputs)) return own;
    Problems found;
    ModelOfAnalysis made = ChainMaker(project, make_own).make(entry, std::move(own), found);
    problems.take(found, "");
    return made;
}

std::vector<std::string> analyses_used_by(const Project& project, const AnalysisEntry& analysis) {
    const std::set<std::string> ids = upstream_of(project, analysis);
    std::vector<std::string> ordered;
    for (const AnalysisEntry& entry : project.analyses)
        if (ids.contains(entry.id) && entry.id != analysis.id) ordered.push_back(entry.id);
    return ordered;
}

std::vector<std::string> analyses_taking_from(const Project& project, const std::string& analysis_id) {
    std::vector<std::string> takers;
    for (const AnalysisEntry& entry : project.analyses) {
        const auto used = analyses_used_by(project, entry);
        if (std::find(used.begin(), used.end(), analysis_id) != used.end()) takers.push_back(entry.id);
    }
    return takers;
}

void add_used_analyses(const Project& project, const AnalysisEntry& analysis, Project& part) {
    for (const std::string& id : analyses_used_by(project, analysis)) {
        part.analyses.push_back(*project.find_analysis(id));
        part.analyses.back().studies.clear();
        part.analyses.back().designs.clear();
        part.analyses.back().views.clear();
        part.analyses.back().quantity_notes.clear();
        part.analyses.back().requirements.clear();
        part.analyses.back().options = {};  // options concern its own evaluation alone
    }
}

namespace {

/// The points of the layout whose coordinates are links, each once.
std::vector<LinkedPoint> linked_points(const ComposedModel& chain, const OutputCovariance& covariance) {
    if (covariance.rows() != static_cast<Eigen::Index>(chain.parts().back().links.size())) return {};
    std::vector<double> x;
    for (std::size_t i = 0; i < chain.inputs().quantities.size(); ++i)
        x.push_back(estimate_of(chain.inputs(), i));
    std::map<std::array<std::size_t, 3>, LinkedPoint> points;
    for (const LayoutPoint& point : chain.layout(x).points) {
        if (!point.links) continue;
        LinkedPoint& linked = points[*point.links];
        linked.links = *point.links;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                linked.covariance(i, j) =
                    covariance(static_cast<Eigen::Index>(linked.links[static_cast<std::size_t>(i)]),
                               static_cast<Eigen::Index>(linked.links[static_cast<std::size_t>(j)]));
    }
    std::vector<LinkedPoint> all;
    for (const auto& [links, point] : points) all.push_back(point);
    return all;
}

}  // namespace

LinkedQuantities quantities_of_links(const MeasurementModel& of_chain) {
    const auto* chain = dynamic_cast<const ComposedModel*>(&of_chain);
    if (!chain) return {};
    const std::unique_ptr<ComposedModel> model = linked_quantities(chain->parts());
    const auto result = evaluate_first_order(*model, model->inputs(), {});
    if (!result) return {};
    LinkedQuantities linked;
    linked.points = linked_points(*chain, result->covariance);
    for (std::size_t i = 0; i < chain->parts().back().links.size(); ++i) {
        const ModelLink& link = chain->parts().back().links[i];
        const ChainPart& from = chain->parts()[link.part];
        const OutputResult& value = result->outputs[i];
        linked.inputs.push_back({value.quantity.symbol, value.quantity.name, value.quantity.unit, from.id,
                                 from.name, from.model->outputs()[link.output], is_linearised(*from.model),
                                 value.first_order.estimate, value.first_order.standard_uncertainty,
                                 value.first_order.effective_degrees_of_freedom});
    }
    return linked;
}

}  // namespace covaria
