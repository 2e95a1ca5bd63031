#include "core/result_files/study_results_json.h"

#include "core/result/representation.h"
#include "core/result_files/json_values.h"

namespace covaria {
namespace {

OrderedJson axes_json(const StudyResult& study) {
    OrderedJson axes = OrderedJson::array();
    for (const StudyAxisValues& axis : study.axes)
        axes.push_back(
            {{"title", axis.title.message().english()}, {"unit", axis.unit.text()}, {"values", axis.values}});
    return axes;
}

OrderedJson outputs_json(const StudyResult& study) {
    OrderedJson outputs = OrderedJson::array();
    for (std::size_t j = 0; j < study.outputs.size(); ++j) {
        const OutputQuantity& output = study.outputs[j];
        OrderedJson estimates = OrderedJson::array(), u = OrderedJson::array(),
                    expanded = OrderedJson::array();
        for (const StudyPoint& point : study.points) {
            const bool known = point.has_values();
            estimates.push_back(known ? json_number(output.unit.from_si(point.values[j].estimate))
                                      : OrderedJson());
            u.push_back(known
                            ? json_number(output.unit.interval_from_si(point.values[j].standard_uncertainty))
                            : OrderedJson());
            expanded.push_back(
                known ? json_number(output.unit.interval_from_si(point.values[j].expanded_uncertainty))
                      : OrderedJson());
        }
        outputs.push_back({{"symbol", output.symbol},
                           {"group", output.group},
                           {"unit", output.unit.text()},
                           {"estimate", std::move(estimates)},
                           {"standardUncertainty", std::move(u)},
                           {"expandedUncertainty", std::move(expanded)}});
    }
    return outputs;
}

/// xx, xy, xz, yy, yz, zz in the squared unit of the outputs.
OrderedJson covariance_json(const StudyPlace& place, const Unit& unit) {
    OrderedJson numbers = OrderedJson::array();
    for (Eigen::Index a = 0; a < 3; ++a)
        for (Eigen::Index b = a; b < 3; ++b)
            numbers.push_back(
                json_number(unit.interval_from_si(unit.interval_from_si(place.covariance(a, b)))));
    return numbers;
}

OrderedJson positions_json(const StudyResult& study) {
    OrderedJson positions = OrderedJson::array();
    for (std::size_t t = 0; t < study.triples.size(); ++t) {
        const StudyTriple& triple = study.triples[t];
        const Unit& unit = study.outputs[triple.outputs[0]].unit;
        OrderedJson places = OrderedJson::array(), covariances = OrderedJson::array();
        for (const StudyPoint& point : study.points) {
            if (!point.has_values()) {
                places.push_back(nullptr);
                covariances.push_back(nullptr);
                continue;
            }
            const Eigen::Vector3d& p = point.places[t].p_W;
            places.push_back({json_number(unit.from_si(p.x())), json_number(unit.from_si(p.y())),
                              json_number(unit.from_si(p.z()))});
            covariances.push_back(covariance_json(point.places[t], unit));
        }
        positions.push_back({{"name", triple.name},
                             {"unit", unit.text()},
                             {"outputs", triple.outputs},
                             {"position", std::move(places)},
                             {"covariance", std::move(covariances)}});
    }
    return positions;
}

}  // namespace

OrderedJson study_json(const StudyResult& study) {
    OrderedJson failed_trials = OrderedJson::array(), reasons = OrderedJson::array();
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        failed_trials.push_back(study.points[i].failed_trials);
        if (!study.points[i].has_values())
            reasons.push_back({{"point", i}, {"reason", study.reasons[study.points[i].reason].english()}});
    }
    return {{"id", study.id},
            {"name", study.name},
            {"trials", study.trials},
            {"seed", std::to_string(study.seed)},
            {"coverageProbability", study.coverage_probability},
            {"fingerprint", study.fingerprint},
            {"axes", axes_json(study)},
            {"outputs", outputs_json(study)},
            {"positions", positions_json(study)},
            {"failedTrials", std::move(failed_trials)},
            {"withoutValues", std::move(reasons)},
            {"notRepresentingMeasurand", not_representing(study)}};
}

}  // namespace covaria
