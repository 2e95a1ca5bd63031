// The table of a verification, for programs.
#include "core/base/version.h"
#include "core/result_files/json_values.h"
#include "core/verification/verification.h"

namespace covaria {
namespace {

/// Number in the list of verifications: degrees of freedom may be infinite.
OrderedJson figure_number(const std::optional<double>& value) {
    if (value && std::isinf(*value)) return "infinite";
    return value ? json_number(*value) : OrderedJson(nullptr);
}

OrderedJson figure_json(const CheckedFigure& f) {
    return {{"figure", f.check.what},
            {"analysis", f.check.analysis},
            {"unit", f.check.unit.text()},
            {"published", figure_number(f.check.published)},
            {"reference", figure_number(f.check.reference)},
            {"value", figure_number(f.value)},
            {"condition", f.check.condition > 0.0 ? json_number(f.check.condition) : OrderedJson(nullptr)},
            {"passRule", pass_rule(f)},
            {"allowedDeviation", json_number(f.tolerance)},
            {"passed", f.passed()},
            {"agreesWithReference", f.agrees_with_reference},
            {"reproducesPublished", f.reproduces_published},
            {"because", f.check.because},
            {"naive", f.check.naive ? json_number(f.check.naive->value) : OrderedJson(nullptr)},
            {"naiveHow", f.check.naive ? f.check.naive->how : ""}};
}

}  // namespace

std::string verification_json(const std::vector<CheckedCase>& cases) {
    std::size_t figures = 0, passed = 0;
    OrderedJson list = OrderedJson::array();
    for (const CheckedCase& c : cases) {
        OrderedJson of_case{
            {"title", c.of.title},     {"source", c.of.source},           {"project", c.of.project},
            {"clauses", c.of.clauses}, {"notEvaluated", c.not_evaluated}, {"figures", OrderedJson::array()}};
        for (const CheckedFigure& f : c.figures) {
            of_case["figures"].push_back(figure_json(f));
            ++figures;
            passed += f.passed() ? 1 : 0;
        }
        list.push_back(std::move(of_case));
    }
    const OrderedJson json{{"format", "covaria-verification"},
                           {"schemaVersion", 1},
                           {"covariaVersion", version()},
                           {"figures", figures},
                           {"passed", passed},
                           {"cases", std::move(list)}};
    return json.dump(2) + "\n";
}

}  // namespace covaria
