// resources/verification.json.
#include <nlohmann/json.hpp>

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
    return check;
}

}  // namespace

Result<std::vector<VerificationCase>> read_verification(const std::string& text) try {
    std::vector<VerificationCase> cases;
    const Json document = Json::parse(text);
    for (const Json& json : document.at("cases")) {
        VerificationCase made{json.at("project"), json.at("title"), json.at("source"), {}};
        for (const Json& check : json.at("checks")) made.checks.push_back(check_from(check));
        cases.push_back(std::move(made));
    }
    return cases;
} catch (const std::exception& e) {
    return fail(ErrorCode::bad_input, std::string("the list of verifications cannot be read: ") + e.what());
}

}  // namespace covaria
