// Changes of a grid point, its model, its numbers.
#include "core/study/grid_point.h"

#include <algorithm>
#include <optional>

#include "core/base/guarded.h"

namespace covaria::detail {

namespace {

std::vector<StudyOutput> wanted_outputs(const PreparedStudy& prepared) {
    if (!prepared.study.outputs.empty()) return prepared.study.outputs;
    std::vector<StudyOutput> wanted;
    for (const OutputQuantity& output : prepared.analysis->model->outputs())
        if (output.role == OutputRole::measurand) wanted.push_back({output.group, output.symbol});
    return wanted;
}

/// The points of the layout whose three coordinates are among the outputs looked at.
std::vector<StudyTriple> triples_of(const PreparedAnalysis& analysis,
                                    const std::vector<std::size_t>& indices) {
    std::vector<StudyTriple> triples;
    const auto position = [&](std::size_t output) {
        return static_cast<std::size_t>(std::find(indices.begin(), indices.end(), output) - indices.begin());
    };
    for (const LayoutPoint& point : analysis.model->layout(estimates_of(analysis.inputs)).points) {
        if (!point.outputs) continue;
        StudyTriple triple{point.name, {}};
        for (std::size_t c = 0; c < 3; ++c) triple.outputs[c] = position((*point.outputs)[c]);
        const bool known = std::all_of(triple.outputs.begin(), triple.outputs.end(),
                                       [&](std::size_t output) { return output < indices.size(); }) &&
                           std::none_of(triples.begin(), triples.end(), [&](const StudyTriple& other) {
                               return other.outputs == triple.outputs;
                           });
        if (known) triples.push_back(triple);
    }
    return triples;
}

EvaluatedPoint without_values(const Message& reason) {
    return {{}, reason.empty() ? tell<"the model cannot be evaluated">() : reason, false};
}

}  // namespace

void EvaluatedPoint::write(ByteWriter& writer) const {
    writer.put_list(reason.english());
    writer.put(point.failed_trials);
    writer.put(static_cast<std::uint64_t>(point.values.size()));
    for (const StudyValue& v : point.values)
        for (const double number : {v.estimate, v.standard_uncertainty, v.expanded_uncertainty})
            writer.put(number);
    writer.put(static_cast<std::uint64_t>(point.places.size()));
    for (const StudyPlace& place : point.places) {
        writer.put_all(std::span<const double>(place.p_W.data(), 3));
        writer.put_all(std::span<const double>(place.R_WQ.data(), 9));
        writer.put_all(std::span<const double>(place.covariance.data(), 9));
    }
}

void EvaluatedPoint::read(ByteReader& reader) {
    *this = {};
    std::string words;  // said in English where others computed the point
    reader.get_list(words);
    reason = std::move(words);
    point.failed_trials = reader.get<std::uint64_t>();
    for (auto left = reader.get<std::uint64_t>(); left > 0 && !reader.is_short(); --left) {
        StudyValue& v = point.values.emplace_back();
        for (double* number : {&v.estimate, &v.standard_uncertainty, &v.expanded_uncertainty})
            *number = reader.get<double>();
    }
    for (auto left = reader.get<std::uint64_t>(); left > 0 && !reader.is_short(); --left) {
        StudyPlace& place = point.places.emplace_back();
        reader.get_all(std::span<double>(place.p_W.data(), 3));
        reader.get_all(std::span<double>(place.R_WQ.data(), 9));
        reader.get_all(std::span<double>(place.covariance.data(), 9));
    }
}

StudyPlan::StudyPlan(const PreparedStudy& study)
    : prepared(study),
      numbers{study.made, study.analysis, study.study.axes, study.targets},
      outputs(wanted_outputs(study)) {
    options = prepared.analysis->options;
    options.method = prepared.study.method;
    options.trials = prepared.study.trials;
    for (std::size_t axis = 0; axis < prepared.study.axes.size(); ++axis) {
        values.push_back(axis_values(prepared.study.axes[axis], prepared.targets[axis].whole));
        points *= values.back().size();
    }
    for (const StudyOutput& output : outputs)
        indices.push_back(find_output(prepared.analysis->model->outputs(), output, no_output));
    triples = triples_of(*prepared.analysis, indices);
}

GridWalker::GridWalker(const StudyPlan& plan) : plan_(plan), changed_(plan.numbers) {}

EvaluatedPoint GridWalker::evaluate(std::size_t point, const std::function<bool(std::uint64_t)>& advance) {
    std::vector<double> values(plan_.values.size());
    for (std::size_t axis = values.size(); axis-- > 0;) {
        values[axis] = plan_.values[axis][point % plan_.values[axis].size()];
        point /= plan_.values[axis].size();
    }
    auto evaluated = guarded([&]() -> EvaluatedPoint {
        changed_.set(values);
        const auto model = changed_.make();
        return model ? of_model(*model, advance) : without_values(model.error().message);
    });
    if (!evaluated) return without_values(evaluated.error().message);
    return *std::move(evaluated);
}

EvaluatedPoint GridWalker::of_model(const ChangedModel& changed,
                                    const std::function<bool(std::uint64_t)>& advance) {
    const MeasurementModel& model = changed.model();
    const InputSet& inputs = changed.inputs;
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < plan_.outputs.size(); ++k) {
        indices.push_back(find_output(model.outputs(), plan_.outputs[k], plan_.indices[k]));
        if (indices.back() == no_output)
            return without_values(tell<"there is no output quantity '%1' here">(plan_.outputs[k].symbol));
    }
    const auto summary = evaluate_summary(model, inputs, indices, plan_.options, advance);
    if (!summary && summary.error().code == ErrorCode::cancelled) return {{}, {}, true};
    if (!summary) return without_values(summary.error().message);
    EvaluatedPoint evaluated;
    evaluated.point.failed_trials = summary->failed_trials;
    for (Eigen::Index k = 0; k < summary->estimate.size(); ++k)
        evaluated.point.values.push_back(
            {summary->estimate(k), summary->standard_uncertainty(k), summary->expanded_uncertainty(k)});
    if (!plan_.triples.empty())
        add_places(model.layout(estimates_of(inputs)), indices, *summary, evaluated.point);
    return evaluated;
}

void GridWalker::add_places(const Layout& layout, const std::vector<std::size_t>& indices,
                            const EvaluationSummary& summary, StudyPoint& point) const {
    for (const StudyTriple& triple : plan_.triples) {
        StudyPlace place;
        std::array<std::size_t, 3> outputs{};
        for (std::size_t a = 0; a < 3; ++a) {
            outputs[a] = indices[triple.outputs[a]];
            for (std::size_t b = 0; b < 3; ++b)
                place.covariance(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
                    summary.covariance(static_cast<Eigen::Index>(triple.outputs[a]),
                                       static_cast<Eigen::Index>(triple.outputs[b]));
        }
        for (const LayoutPoint& candidate : layout.points) {
            if (!candidate.outputs || *candidate.outputs != outputs) continue;
            place.p_W = candidate.p_W;
            place.R_WQ = candidate.R_WQ;
            break;
        }
        point.places.push_back(place);
    }
}

}  // namespace covaria::detail
