#include "core/result_files/seen_json.h"

#include "core/result_files/json_values.h"
#include "core/views/seen_table.h"

namespace covaria {
namespace {

OrderedJson figure_json(const evidence::RedundantReadings& readings, const evidence::SeenFigure& seen,
                        std::size_t number) {
    const evidence::StatedFigure& figure = readings.figures[number];
    const bool told = seen.degrees_of_freedom > 0.0, is_known = told || seen.clamped;
    const auto known = [](double value, bool is) { return is ? json_number(value) : OrderedJson(); };
    OrderedJson json = {{"figure", figure.name.english()},
                        {"readings", figure.count},
                        {"unit", figure.unit.text()},
                        {"statedLeast", json_number(figure.unit.interval_from_si(figure.least))},
                        {"statedMost", json_number(figure.unit.interval_from_si(figure.most))},
                        {"factor", known(seen.factor, is_known)},
                        {"factorLow", known(seen.low, told)},
                        {"factorHigh", known(seen.high, told)},
                        {"varianceComponent", known(seen.square, is_known)},
                        {"uVarianceComponent", known(seen.u_square, told)},
                        {"redundancy", json_number(seen.redundancy)},
                        {"degreesOfFreedom", known(seen.degrees_of_freedom, told)},
                        {"isZero", seen.clamped},
                        {"verdict", verdict_words(seen.verdict).english()}};
    for (const std::size_t other : seen.not_apart)
        json["notToldApartFrom"].push_back(readings.figures[other].name.english());
    return json;
}

}  // namespace

OrderedJson seen_json(const evidence::RedundantReadings& readings, const evidence::Seen& seen) {
    OrderedJson json = {{"degreesOfFreedom", seen.degrees_of_freedom},
                        {"sumOfSquares", json_number(seen.sum_of_squares)},
                        {"s0", json_number(seen.s0)},
                        {"s0Low", json_number(seen.s0_low)},
                        {"s0High", json_number(seen.s0_high)}};
    if (!readings.measurands.empty()) {
        const Unit& unit = readings.unit_of_measurands;
        json["meanStandardUncertainty"] = {
            {"unit", unit.text()},
            {"asStated", json_number(unit.interval_from_si(seen.mean_u_stated))},
            {"asSeen", json_number(unit.interval_from_si(seen.mean_u_seen))}};
    }
    if (seen.degrees_of_freedom > 0 && !seen.found)
        json["notFound"] = seen_notes(readings, seen).front().english();
    json["figures"] = OrderedJson::array();
    for (std::size_t k = 0; k < seen.figures.size(); ++k)
        json["figures"].push_back(figure_json(readings, seen.figures[k], k));
    return json;
}

}  // namespace covaria
