// Lists of cases: resources/verification.json and those in resources/verification.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/verification/verification.h"

namespace covaria {
namespace {

using Json = nlohmann::json;

/// "infinite" stands for infinity, which JSON has no number for.
std::optional<double> number(const Json& of, const char* key) {
    const auto found = of.find(key);
    if (found == of.end() || found->is_null()) return std::nullopt;
    return found->is_string() && found->get<std::string>() == "infinite" ? infinity : found->get<double>();
}

std::vector<std::string> texts(const Json& of, const char* key) {
    return of.contains(key) ? of.at(key).get<std::vector<std::string>>() : std::vector<std::string>{};
}

OutputRequirement requirement_from(const Json& json) {
    OutputRequirement made;
    made.lower_limit = number(json, "lowerLimit");
    made.upper_limit = number(json, "upperLimit");
    made.prior_mean = number(json, "priorMean");
    made.prior_standard_deviation = number(json, "priorStandardDeviation");
    made.guard_factor = json.value("guardFactor", 1.0);
    return made;
}

VerificationCheck check_from(const Json& json) {
    VerificationCheck check;
    check.what = json.at("what");
    check.analysis = json.at("analysis");
    check.group = json.value("group", "");
    if (json.contains("table")) {
        check.cell = VerificationCell{json.at("table"), json.at("row"), json.value("column", "value")};
    } else {
        check.output = json.at("output");
        check.figure = json.at("figure");
    }
    check.with = json.value("with", "");
    check.unit = Unit::parse(json.value("unit", "1")).value();
    check.entry = json.value("entry", "");
    check.published = number(json, "published");
    check.half_digit = json.value("halfDigit", 0.0);
    check.reference = number(json, "reference");
    check.relative = json.value("relative", 0.0);
    check.absolute = json.value("absolute", 0.0);
    check.standard_error = json.value("standardError", 0.0);
    check.scatter = json.value("scatter", 0.0);
    check.because = json.value("because", "");
    check.condition = json.value("condition", 0.0);
    check.scale = json.value("scale", 0.0);
    check.clauses = texts(json, "clauses");
    if (json.contains("naive")) check.naive = NaiveFigure{json.at("naive"), json.at("naiveHow")};
    if (json.contains("requirement")) check.requirement = requirement_from(json.at("requirement"));
    return check;
}

/// The figures of a result line by the law of propagation, of which one entry states those that the others
/// follow from: condition numbers of the estimate, of u and of k.
void add_line(const Json& json, std::vector<VerificationCheck>& checks) {
    static const std::map<std::string, std::string> words{
        {"estimate", "estimate"}, {"u", "u"}, {"degrees-of-freedom", "effective degrees of freedom"},
        {"k", "coverage factor"}, {"U", "U"}, {"low", "lower end"},
        {"high", "upper end"}};
    VerificationCheck one;
    one.analysis = json.at("analysis");
    one.output = json.at("output");
    one.group = json.value("group", "");
    const Unit unit = Unit::parse(json.value("unit", "1")).value();
    const Json& line = json.at("line");
    const double of_u = json.at("condition"), of_estimate = json.value("estimateCondition", of_u),
                 of_k = json.value("quantileCondition", 1.0), scale = json.at("scale"),
                 expanded = std::abs(number(line, "U").value());
    const std::map<std::string, std::pair<double, double>> conditions{
        {"estimate", {of_estimate, scale}},
        {"u", {of_u, 0.0}},
        {"degrees-of-freedom", {4.0 * of_u, 0.0}},
        {"k", {of_k, 0.0}},
        {"U", {of_u + of_k, 0.0}},
        {"low", {1.0, of_estimate * scale + (of_u + of_k) * expanded}},
        {"high", {1.0, of_estimate * scale + (of_u + of_k) * expanded}}};
    for (const std::string& figure : first_order_line()) {
        one.what = words.at(figure) + ", " + json.value("what", one.output);
        one.figure = figure;
        one.unit = figure == "k" || figure == "degrees-of-freedom" ? Unit{} : unit;
        one.reference = number(line, figure.c_str());
        std::tie(one.condition, one.scale) = conditions.at(figure);
        checks.push_back(one);
    }
}

}  // namespace

Result<std::vector<VerificationCase>> read_verification(const std::string& text) try {
    std::vector<VerificationCase> cases;
    const Json document = Json::parse(text);
    for (const Json& json : document.at("cases")) {
        VerificationCase made{
            json.at("project"), json.at("title"), json.at("source"), {}, texts(json, "clauses")};
        for (const Json& check : json.at("checks")) {
            if (check.contains("line"))
                add_line(check, made.checks);
            else
                made.checks.push_back(check_from(check));
        }
        cases.push_back(std::move(made));
    }
    return cases;
} catch (const std::exception& e) {
    return fail(ErrorCode::bad_input, std::string("the list of verifications cannot be read: ") + e.what());
}

Result<std::vector<VerificationCase>> shipped_verification() {
    namespace fs = std::filesystem;
    const fs::path folder = data_directory() / "resources";
    std::vector<fs::path> lists;
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(folder / "verification", gone))
        if (entry.path().extension() == ".json") lists.push_back(entry.path());
    std::sort(lists.begin(), lists.end());
    lists.insert(lists.begin(), folder / "verification.json");
    std::vector<VerificationCase> all;
    for (const fs::path& list : lists) {
        const auto text = read_file(list);
        if (!text) return fail(text.error());
        auto cases = read_verification(*text);
        if (!cases) return fail(cases.error());
        std::move(cases->begin(), cases->end(), std::back_inserter(all));
    }
    return all;
}

}  // namespace covaria
