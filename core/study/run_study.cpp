// Run of all points of a study on several threads, their results in the order of the grid.
#include <map>

#include "core/propagation/stored_units.h"
#include "core/study/grid_point.h"
#include "core/study/varied_part.h"

namespace covaria {

namespace {

using namespace detail;

StudyResult frame_of(const StudyPlan& plan) {
    const PreparedStudy& prepared = plan.prepared;
    StudyResult result;
    result.id = prepared.study.id;
    result.name = prepared.study.name.empty() ? prepared.study.id : prepared.study.name;
    for (std::size_t axis = 0; axis < plan.values.size(); ++axis) {
        const StudyAxis& given = prepared.study.axes[axis];
        result.axes.push_back({changed_title(prepared.targets[axis], given.change), given.unit,
                               given.spacing == StudySpacing::logarithmic, plan.values[axis],
                               present_value(given, prepared.targets[axis])});
    }
    for (const std::size_t output : plan.indices) {
        result.outputs.push_back(prepared.analysis->model->outputs()[output]);
        take_style(result.outputs.back(), prepared.analysis->style);
    }
    result.triples = plan.triples;
    result.reasons = {""};
    result.trials = prepared.study.method == Method::first_order ? 0 : prepared.study.trials;
    result.seed = plan.options.seed;
    result.coverage_probability = plan.options.coverage_probability;
    result.fingerprint = prepared.fingerprint;
    return result;
}

/// Equal reasons are kept once.
class ReasonBook {
public:
    explicit ReasonBook(std::vector<Message>& reasons) : reasons_(reasons) {}
    std::size_t index_of(const Message& reason) {
        if (reason.empty()) return 0;
        const auto [entry, is_new] = known_.try_emplace(reason.english(), reasons_.size());
        if (is_new) reasons_.push_back(reason);
        return entry->second;
    }

private:
    std::vector<Message>& reasons_;
    std::map<std::string, std::size_t> known_;  ///< numbers of reasons by what they say in English
};

/// A file may say anything: numbers of other outputs would be looked for where there are none.
bool is_of(const StudyPlan& plan, const EvaluatedPoint& evaluated) {
    const StudyPoint& point = evaluated.point;
    if (!evaluated.reason.empty()) return point.values.empty() && point.places.empty();
    return point.values.size() == plan.outputs.size() && point.places.size() == plan.triples.size() &&
           point.failed_trials <= plan.options.trials;
}

}  // namespace

std::uint64_t units_of_study(const PreparedStudy& study) {
    return StudyPlan(study).points;
}

Result<StudyResult> run_study(const PreparedStudy& study, const RunControl& control) {
    const StudyPlan plan(study);
    StudyResult result = frame_of(plan);
    result.points.reserve(plan.points);
    ReasonBook reasons(result.reasons);
    RunMonitor monitor(control, plan.points * std::max<std::uint64_t>(1, result.trials));

    OrderedWork<EvaluatedPoint> work;
    work.units = plan.points;
    work.make_partial = [] { return EvaluatedPoint{}; };
    work.make_worker = [&] {
        return [walker = std::make_shared<GridWalker>(plan), &monitor](std::uint64_t point,
                                                                       EvaluatedPoint& evaluated) {
            const auto advance = [&monitor](std::uint64_t trials) { return monitor.advance(trials); };
            evaluated = walker->evaluate(point, advance);
            return !evaluated.cancelled && !monitor.stopped();
        };
    };
    work.merge = [&](std::uint64_t, EvaluatedPoint& evaluated) {
        evaluated.point.reason = reasons.index_of(evaluated.reason);
        result.points.push_back(std::move(evaluated.point));
        return true;
    };
    const PartialBytes<EvaluatedPoint> bytes{
        [](const EvaluatedPoint& point, ByteWriter& writer) { point.write(writer); },
        [&plan](ByteReader& reader, EvaluatedPoint& point) {
            point.read(reader);
            if (!is_of(plan, point)) reader.refuse();
        }};
    if (run_units(work, bytes, monitor) == WorkEnd::cancelled)
        return fail(ErrorCode::cancelled, tell<"the study was stopped">());
    return result;
}

}  // namespace covaria
