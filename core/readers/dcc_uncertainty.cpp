#include "core/readers/dcc_uncertainty.h"

#include <cmath>
#include <sstream>
#include <string_view>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Remarks = std::vector<std::string>;

std::string_view without_list(std::string_view name) {
    if (name.ends_with("XMLList")) name.remove_suffix(7);
    return name;
}

bool states_uncertainty(std::string_view name) {
    name = without_list(name);
    return name == "expandedUnc" || name == "expandedMU" || name == "standardMU" ||
           name == "coverageInterval" || name == "coverageIntervalMU";
}

/// The statement of uncertainty in a value: directly, or in the element that D-SI 2 puts around it, whose
/// name is misspelt in 2.2.0.
pugi::xml_node statement_in(const pugi::xml_node& value) {
    for (const pugi::xml_node& child : value.children()) {
        if (states_uncertainty(local_name(child))) return child;
        const std::string_view name = local_name(child);
        // A name "list..." is that of an element for all values of a list together.
        if (!name.starts_with("measurementUncertaintyUniva") &&
            !name.starts_with("listMeasurementUncertainty") && !name.starts_with("listUnivariateUnc"))
            continue;
        for (const pugi::xml_node& inner : child.children())
            if (states_uncertainty(local_name(inner))) return inner;
    }
    return {};
}

Result<double> figure(const std::string& text, const std::string& what) {
    if (const auto value = number_in_text(text)) return *value;
    return fail(ErrorCode::bad_input, tell<"%1 %2 is no number">(what, in_quotes(plain_name(text))));
}

/// States U with k, or with p.
Result<void> state_expanded(const std::string& expanded, const std::string& factor,
                            const std::string& probability, StatedQuantity& q, Remarks& remarks) {
    const auto value = figure(expanded, "the expanded uncertainty");
    if (!value) return fail(value.error());
    if (factor.empty() && probability.empty()) {
        remarks.push_back("its expanded uncertainty: neither k nor p is stated");
        return {};
    }
    const auto second = factor.empty() ? figure(probability, "the coverage probability")
                                       : figure(factor, "the coverage factor");
    if (!second) return fail(second.error());
    if (!(*second > 0.0) || (factor.empty() && !(*second < 1.0)))
        return fail(ErrorCode::bad_input, factor.empty() ? tell<"p must be between 0 and 1">()
                                                         : tell<"k must be greater than 0">());
    q.statement = factor.empty() ? "certificate-p" : "certificate-k";
    q.a = *value;
    q.b = factor.empty() ? 100.0 * *second : *second;
    if (factor.empty()) return {};
    if (!probability.empty()) q.source = "p = " + plain_name(probability);
    if (*second > 2.05 && number_in_text(probability).value_or(1.0) < 0.96)
        remarks.push_back("k = " + readable_number(*second) +
                          " means few degrees of freedom, which are not stated: enter nu");
    return {};
}

void take_shape(const std::string& distribution, StatedQuantity& q, Remarks& remarks) {
    if (!q.a || distribution.empty() || distribution == "normal" || distribution == "gaussian") return;
    const bool has_u = q.statement == "standard" || q.statement == "certificate-k";
    const double u = q.statement == "certificate-k" ? *q.a / *q.b : *q.a;
    const bool rectangular = distribution == "uniform" || distribution == "rectangular";
    if (!has_u || (!rectangular && distribution != "triangular"))
        return remarks.push_back("its distribution " + in_quotes(plain_name(distribution)) +
                                 "; normal is taken");
    q.statement = rectangular ? "rectangular" : "triangular";
    q.a = std::sqrt(rectangular ? 3.0 : 6.0) * u;
    q.b.reset();
}

}  // namespace

TextList::TextList(const std::string& text) {
    std::istringstream in(text);
    for (std::string item; in >> item;) items.push_back(item);
}

bool DccStatement::fits(std::size_t n) const {
    return expanded.fits(n) && factor.fits(n) && probability.fits(n) && standard.fits(n) &&
           distribution.fits(n);
}

DccStatement dcc_statement_of(const pugi::xml_node& value) {
    DccStatement statement;
    statement.node = statement_in(value);
    statement.interval = local_name(statement.node).starts_with("coverageInterval");
    for (const pugi::xml_node& child : statement.node.children()) {
        const std::string_view name = without_list(local_name(child));
        const TextList texts(trimmed_text(child));
        if (name == "uncertainty" || name == "valueExpandedMU") statement.expanded = texts;
        if (name == "coverageFactor") statement.factor = texts;
        if (name == "coverageProbability") statement.probability = texts;
        if (name == "valueStandardMU" || name == "standardUnc") statement.standard = texts;
        if (name == "distribution") statement.distribution = texts;
    }
    return statement;
}

Result<std::vector<std::string>> state_uncertainty(const DccStatement& statement, std::size_t i,
                                                   StatedQuantity& quantity) {
    Remarks remarks;
    if (!statement.node) return remarks;
    const std::string standard = statement.standard.at(i), expanded = statement.expanded.at(i);
    if (!standard.empty()) {
        if (statement.interval && i == 0)
            remarks.push_back("its coverage interval; the standard uncertainty is taken");
        const auto u = figure(standard, "the standard uncertainty");
        if (!u) return fail(u.error());
        quantity.statement = "standard";
        quantity.a = *u;
    } else if (!expanded.empty()) {
        const auto stated =
            state_expanded(expanded, statement.factor.at(i), statement.probability.at(i), quantity, remarks);
        if (!stated) return fail(stated.error());
    }
    if (quantity.a && *quantity.a < 0.0)
        return fail(ErrorCode::bad_input, tell<"its uncertainty is negative">());
    take_shape(statement.distribution.at(i), quantity, remarks);
    return remarks;
}

}  // namespace covaria
