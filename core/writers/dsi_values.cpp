#include "core/writers/dsi_values.h"

#include <algorithm>
#include <cmath>

#include "core/project/stated_requirements.h"
#include "core/readers/dsi_unit.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/views/result_statement.h"
#include "core/writers/dcc_xml.h"

namespace covaria {

namespace {

using pugi::xml_node;

std::string name_of(const OutputQuantity& quantity) {
    const std::string name = xml_line(quantity.name.empty() ? quantity.symbol : quantity.name.english());
    return name.empty() ? "result" : name;
}

/// The known form of the distribution; empty where it has no name.
std::string distribution_of(const OutputResult& output, const UncertaintyResult& result) {
    if (output.monte_carlo) return output.monte_carlo->normality.acceptable ? "normal" : "";
    return std::isfinite(stated_degrees_of_freedom(output, result)) ? "t" : "normal";
}

double factor_of(const CoverageRegion& region) {
    return region.ellipsoid_monte_carlo.value_or(region.ellipsoid_first_order);
}

class ValueElements {
public:
    ValueElements(const UncertaintyResult& result, const StatedConformity& conformity)
        : result_(result), conformity_(conformity) {}

    Result<void> add_scalar(xml_node data, std::size_t i) const {
        const OutputResult& output = result_.outputs[i];
        const DsiUnit unit = dsi_unit_for(output.quantity.unit);
        xml_node quantity = quantity_in(data, name_of(output.quantity), degrees_words(i));
        xml_node real = quantity.append_child("si:real");
        add_text(real, "si:label", label_of(output));
        add_text(real, "si:value", format_exact(unit.unit.from_si(output.estimate)));
        add_text(real, "si:unit", unit.text);
        if (auto added = add_uncertainty(real, output, unit.unit); !added) return added;
        add_metadata(quantity, {i});
        return {};
    }

    /// Adds values with labels, U of each and the covariance matrix in the units of the values.
    Result<void> add_list(xml_node data, const std::string& group, const CoverageRegion& region) const {
        std::vector<DsiUnit> units;
        std::string degrees;
        for (const std::size_t i : region.outputs) {
            units.push_back(dsi_unit_for(result_.outputs[i].quantity.unit));
            if (const std::string words = degrees_words(i); !words.empty())
                degrees += label_of(result_.outputs[i]) + ": " + words + "\n";
        }
        xml_node quantity = quantity_in(data, group, degrees);
        xml_node list = quantity.append_child("si:list").append_child("si:realList");
        const bool one_unit = std::all_of(units.begin(), units.end(),
                                          [&](const DsiUnit& u) { return u.text == units.front().text; });
        if (one_unit) add_text(list, "si:listUnit", units.front().text);
        for (std::size_t n = 0; n < units.size(); ++n) {
            const OutputResult& output = result_.outputs[region.outputs[n]];
            xml_node real = list.append_child("si:real");
            add_text(real, "si:label", label_of(output));
            add_text(real, "si:value", format_exact(units[n].unit.from_si(output.estimate)));
            if (!one_unit) add_text(real, "si:unit", units[n].text);
            if (auto added = add_uncertainty(real, output, units[n].unit); !added) return added;
        }
        add_region(list.append_child("si:ellipsoidalRegion"), region, units);
        add_metadata(quantity, region.outputs);
        return {};
    }

private:
    static std::string label_of(const OutputResult& output) { return xml_line(output.quantity.symbol); }

    static xml_node quantity_in(xml_node data, const std::string& name, const std::string& description) {
        xml_node quantity = data.append_child("dcc:quantity");
        quantity.append_attribute("refType") = "basic_measuredValue";
        add_name(quantity, name);
        if (!description.empty()) add_contents(quantity.append_child("dcc:description"), description);
        return quantity;
    }

    static void add_number(xml_node data, const std::string& name, const DsiUnit& unit, double figure) {
        xml_node quantity = data.append_child("dcc:quantity");
        add_name(quantity, name);
        xml_node real = quantity.append_child("si:real");
        add_text(real, "si:value", format_exact(figure));
        add_text(real, "si:unit", unit.text);
    }

    /// Adds the statements on these outputs beside their values: degrees of freedom, conformity.
    void add_metadata(xml_node quantity, const std::vector<std::size_t>& outputs) const {
        xml_node list = quantity.append_child("dcc:measurementMetaData");
        for (const std::size_t i : outputs) {
            const double nu = stated_degrees_of_freedom(result_.outputs[i], result_);
            if (std::isfinite(nu)) {
                xml_node meta = list.append_child("dcc:metaData");
                add_name(meta, "Effective degrees of freedom of " + label_of(result_.outputs[i]));
                add_number(meta.append_child("dcc:data"), "nu_eff", dsi_unit_for(Unit()), nu);
            }
            for (const RequirementResult& verdict : conformity_.verdicts)
                if (verdict.output == i && verdict.not_judged.empty() &&
                    verdict.decision != RequirementResult::Decision::none)
                    add_conformity(list.append_child("dcc:metaData"), verdict);
        }
        if (!list.first_child()) quantity.remove_child(list);
    }

    /// Adds the decision by its rule, with tolerance, guard band and probability of conformance.
    void add_conformity(xml_node meta, const RequirementResult& verdict) const {
        const OutputResult& output = result_.outputs[verdict.output];
        const DsiUnit unit = dsi_unit_for(output.quantity.unit);
        meta.append_attribute("refType") = "basic_conformity";
        add_name(meta, "Conformity of " + label_of(output));
        add_text(meta, "dcc:convention", decision_rule(verdict));
        if (!conformity_.specification.empty()) add_text(meta, "dcc:norm", conformity_.specification);
        add_text(meta, "dcc:norm", "JCGM 106:2012");
        add_text(meta, "dcc:conformity",
                 verdict.decision == RequirementResult::Decision::accept ? "pass" : "fail");
        xml_node data = meta.append_child("dcc:data");
        if (verdict.lower_limit)
            add_number(data, "lower limit", unit, unit.unit.from_si(*verdict.lower_limit));
        if (verdict.upper_limit)
            add_number(data, "upper limit", unit, unit.unit.from_si(*verdict.upper_limit));
        if (std::isfinite(verdict.guard_band))
            add_number(data, "guard band", unit, unit.unit.interval_from_si(verdict.guard_band));
        add_number(data, "probability of conformance", dsi_unit_for(Unit()), verdict.conformance);
    }

    /// The degrees of freedom in words, since the D-SI has no element for them.
    std::string degrees_words(std::size_t i) const {
        const double nu = stated_degrees_of_freedom(result_.outputs[i], result_);
        return std::isfinite(nu) ? "effective degrees of freedom " + format_degrees_of_freedom(nu) : "";
    }

    /// Adds U with k and p; the coverage interval where y +- U does not say it, or k is below 1, which the
    /// D-SI does not allow. An exact value has none.
    Result<void> add_uncertainty(xml_node real, const OutputResult& output, const Unit& unit) const {
        const double u = output.standard_uncertainty, U = output.expanded_uncertainty;
        if (u == 0.0) return {};
        if (!std::isfinite(u) || !std::isfinite(U) || !std::isfinite(output.coverage_factor) ||
            !std::isfinite(output.estimate))
            return fail(ErrorCode::numeric,
                        tell<"the standard uncertainty of %1 is not finite; a Digital Calibration "
                             "Certificate has no place for that">(name_of(output.quantity)));
        const std::string distribution = distribution_of(output, result_);
        if (output.coverage_factor < 1.0 || !skewed_interval(output, result_).empty()) {
            const CoverageInterval interval = coverage_interval_of(output, result_);
            xml_node node = real.append_child("si:coverageInterval");
            add_text(node, "si:standardUnc", format_exact(unit.interval_from_si(u)));
            add_text(node, "si:intervalMin", format_exact(unit.from_si(interval.low)));
            add_text(node, "si:intervalMax", format_exact(unit.from_si(interval.high)));
            add_text(node, "si:coverageProbability", format_shortest(result_.coverage_probability));
            return {};
        }
        xml_node node = real.append_child("si:expandedUnc");
        add_text(node, "si:uncertainty", format_exact(unit.interval_from_si(U)));
        add_text(node, "si:coverageFactor", format_shortest(output.coverage_factor));
        add_text(node, "si:coverageProbability", format_shortest(stated_probability(output, result_)));
        if (!distribution.empty()) add_text(node, "si:distribution", distribution);
        return {};
    }

    void add_region(xml_node node, const CoverageRegion& region, const std::vector<DsiUnit>& units) const {
        xml_node matrix = node.append_child("si:covarianceMatrix");
        for (std::size_t j = 0; j < units.size(); ++j) {
            xml_node column = matrix.append_child("si:column");
            for (std::size_t i = 0; i < units.size(); ++i) {
                const double si = result_.covariance(static_cast<Eigen::Index>(region.outputs[i]),
                                                     static_cast<Eigen::Index>(region.outputs[j]));
                xml_node cell = column.append_child("si:covariance");
                add_text(cell, "si:value",
                         format_exact(units[j].unit.interval_from_si(units[i].unit.interval_from_si(si))));
                add_text(cell, "si:unit", dsi_product(units[i], units[j]));
            }
        }
        add_text(node, "si:coverageFactor", format_shortest(factor_of(region)));
        add_text(node, "si:coverageProbability", format_shortest(result_.coverage_probability));
    }

    const UncertaintyResult& result_;
    const StatedConformity& conformity_;
};

/// The joint region of exactly these outputs that an ellipsoid of the D-SI can state; null where there is
/// none.
const CoverageRegion* region_of(const UncertaintyResult& result, const std::string& group,
                                const std::vector<std::size_t>& outputs) {
    for (const CoverageRegion& region : result.regions) {
        const double k = factor_of(region);
        if (region.group == group && region.outputs == outputs && outputs.size() > 1 && !region.singular &&
            std::isfinite(k) && k >= 1.0)
            return &region;
    }
    return nullptr;
}

}  // namespace

Result<void> add_quantities(pugi::xml_node data, const UncertaintyResult& result, const std::string& group,
                            const std::vector<std::size_t>& outputs, const StatedConformity& conformity) {
    const ValueElements elements(result, conformity);
    const std::string name = xml_line(group).empty() ? "results" : xml_line(group);
    if (const CoverageRegion* region = region_of(result, group, outputs))
        return elements.add_list(data, name, *region);
    for (const std::size_t i : outputs)
        if (auto added = elements.add_scalar(data, i); !added) return added;
    return {};
}

}  // namespace covaria
