#include "core/report/study_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace covaria {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json axes_json(const StudyResult& study) {
    Json axes = Json::array();
    for (const StudyAxisValues& axis : study.axes)
        axes.push_back({{"title", axis.title}, {"unit", axis.unit.text()}, {"values", axis.values}});
    return axes;
}

Json outputs_json(const StudyResult& study) {
    Json outputs = Json::array();
    for (std::size_t j = 0; j < study.outputs.size(); ++j) {
        const OutputQuantity& output = study.outputs[j];
        Json estimates = Json::array(), u = Json::array(), expanded = Json::array();
        for (const StudyPoint& point : study.points) {
            const bool known = point.has_values();
            estimates.push_back(known ? number(output.unit.from_si(point.values[j].estimate)) : Json());
            u.push_back(known ? number(output.unit.interval_from_si(point.values[j].standard_uncertainty))
                              : Json());
            expanded.push_back(
                known ? number(output.unit.interval_from_si(point.values[j].expanded_uncertainty)) : Json());
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
Json covariance_json(const StudyPlace& place, const Unit& unit) {
    Json numbers = Json::array();
    for (Eigen::Index a = 0; a < 3; ++a)
        for (Eigen::Index b = a; b < 3; ++b)
            numbers.push_back(number(unit.interval_from_si(unit.interval_from_si(place.covariance(a, b)))));
    return numbers;
}

Json positions_json(const StudyResult& study) {
    Json positions = Json::array();
    for (std::size_t t = 0; t < study.triples.size(); ++t) {
        const StudyTriple& triple = study.triples[t];
        const Unit& unit = study.outputs[triple.outputs[0]].unit;
        Json places = Json::array(), covariances = Json::array();
        for (const StudyPoint& point : study.points) {
            if (!point.has_values()) {
                places.push_back(nullptr);
                covariances.push_back(nullptr);
                continue;
            }
            const Eigen::Vector3d& p = point.places[t].p_W;
            places.push_back(
                {number(unit.from_si(p.x())), number(unit.from_si(p.y())), number(unit.from_si(p.z()))});
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

Json study_json(const StudyResult& study) {
    Json failed_trials = Json::array(), reasons = Json::array();
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        failed_trials.push_back(study.points[i].failed_trials);
        if (!study.points[i].has_values())
            reasons.push_back({{"point", i}, {"reason", study.reasons[study.points[i].reason]}});
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
            {"withoutValues", std::move(reasons)}};
}

}  // namespace covaria
