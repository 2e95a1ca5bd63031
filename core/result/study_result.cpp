// Grid indices and the quantities that a study can show.
#include "core/result/study_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/name.h"
#include "core/text/symbol.h"

namespace covaria {

double StudyPlace::standard_uncertainty() const {
    return std::sqrt(std::max(0.0, covariance.trace()));
}

std::vector<std::size_t> StudyResult::indices_of(std::size_t point) const {
    std::vector<std::size_t> indices(axes.size());
    for (std::size_t axis = axes.size(); axis-- > 0;) {
        indices[axis] = point % axes[axis].values.size();
        point /= axes[axis].values.size();
    }
    return indices;
}

std::size_t StudyResult::failed() const {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(),
                                                  [](const StudyPoint& point) { return point.reason != 0; }));
}

std::vector<StudyQuantity> study_quantities(const StudyResult& study, const DocumentLanguage& language) {
    const auto in = [](const std::string& group) { return group.empty() ? std::string() : ", " + group; };
    const auto said = [&](const Name& group) { return in(language.say(said_name(group))); };
    std::vector<StudyQuantity> quantities;
    // The same point of several poses is told apart by these.
    const auto is_repeated = [&](const Name& name) {
        return std::ranges::count_if(study.triples, [&](const StudyTriple& t) { return t.name == name; }) > 1;
    };
    for (std::size_t t = 0; t < study.triples.size(); ++t) {
        const OutputQuantity& first = study.outputs[study.triples[t].outputs[0]];
        const Name& name = study.triples[t].name;
        const Name group = is_repeated(name) ? first.group : Name();
        quantities.push_back({"u(3D)" + in(name) + in(group), "u(3D)" + said(name) + said(group), "u(3D)",
                              first.unit, true, t});
    }
    for (std::size_t j = 0; j < study.outputs.size(); ++j) {
        const OutputQuantity& output = study.outputs[j];
        const Text symbol = "U(" + symbol_text(output.symbol) + ")";
        quantities.push_back({"U(" + output.symbol + ")" + in(output.group), symbol + said(output.group),
                              symbol, output.unit, false, j});
    }
    return quantities;
}

double value_at(const StudyResult& study, const StudyQuantity& quantity, std::size_t point) {
    const StudyPoint& at = study.points[point];
    if (!at.has_values()) return std::numeric_limits<double>::quiet_NaN();
    return quantity.position ? at.places[quantity.index].standard_uncertainty()
                             : at.values[quantity.index].expanded_uncertainty;
}

StudyExtremes extremes_of(const StudyResult& study, const StudyQuantity& quantity) {
    StudyExtremes found;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        if (!study.points[i].has_values()) continue;
        const double value = value_at(study, quantity, i);
        if (!found.known || value < value_at(study, quantity, found.best)) found.best = i;
        if (!found.known || value > value_at(study, quantity, found.worst)) found.worst = i;
        found.known = true;
    }
    return found;
}

}  // namespace covaria
