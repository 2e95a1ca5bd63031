#include "core/readers/dcc_quantities.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/in_quotes.h"
#include "core/readers/dsi_unit.h"
#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using pugi::xml_node;

/// Elements of a list as texts: "1.5 2.5", where one may stand for all.
struct TextList {
    std::vector<std::string> items;
    explicit TextList(const std::string& text) {
        std::istringstream in(text);
        for (std::string item; in >> item;) items.push_back(item);
    }
    bool fits(std::size_t n) const { return items.empty() || items.size() == 1 || items.size() == n; }
    std::string at(std::size_t i) const {
        return items.empty() ? "" : items.size() == 1 ? items[0] : items.at(i);
    }
};

/// What is stated about the uncertainty of one value, as texts.
struct StatedTexts {
    std::string expanded, factor, probability, standard, distribution;
};

/// The element that states an uncertainty of each value, in any version; names of lists end in XMLList.
struct Statement {
    xml_node node;
    TextList expanded{""}, factor{""}, probability{""}, standard{""}, distribution{""};
    bool interval = false;

    StatedTexts at(std::size_t i) const {
        return {expanded.at(i), factor.at(i), probability.at(i), standard.at(i), distribution.at(i)};
    }
    bool fits(std::size_t n) const {
        return expanded.fits(n) && factor.fits(n) && probability.fits(n) && standard.fits(n) &&
               distribution.fits(n);
    }
};

std::string_view without_list(std::string_view name) {
    if (name.ends_with("XMLList")) name.remove_suffix(7);
    return name;
}

bool states_uncertainty(std::string_view name) {
    name = without_list(name);
    return name == "expandedUnc" || name == "expandedMU" || name == "standardMU" ||
           name == "coverageInterval" || name == "coverageIntervalMU";
}

/// Directly in a value, or in the element that D-SI 2 puts around it, whose name is misspelt in 2.2.0.
xml_node statement_in(const xml_node& value) {
    for (const xml_node& child : value.children()) {
        if (states_uncertainty(local_name(child))) return child;
        if (local_name(child).starts_with("measurementUncertaintyUniva"))
            for (const xml_node& inner : child.children())
                if (states_uncertainty(local_name(inner))) return inner;
    }
    return {};
}

Statement statement_of(const xml_node& value) {
    Statement statement;
    statement.node = statement_in(value);
    statement.interval = local_name(statement.node).starts_with("coverageInterval");
    for (const xml_node& child : statement.node.children()) {
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

class QuantityReader {
public:
    QuantityReader(const XmlText& xml, DccQuantity& quantity, Proposals& proposals)
        : xml_(xml), quantity_(quantity), proposals_(proposals) {}

    Result<void> read(const xml_node& node) {
        for (const xml_node& child : node.children()) {
            auto done = read_value(local_name(child) == "hybrid" ? best_of(child) : child);
            if (!done) return done;
        }
        return {};
    }

private:
    static bool is_value(std::string_view name) {
        return name == "noQuantity" || name == "charsXMLList" || name == "complex" ||
               name == "complexListXMLList" || name == "complexList";
    }

    Result<void> read_value(const xml_node& node) {
        const std::string_view name = local_name(node);
        if (name == "real" || name == "constant") return read_real(node);
        if (name == "realListXMLList") return read_list(node);
        if (name == "list") return read_vector(node);
        if (is_value(name)) leave_out(node, "a value as <" + std::string(name) + ">");
        if (name == "relativeUncertainty") leave_out(node, "its relative uncertainty");
        return {};
    }

    void leave_out(const xml_node& node, const std::string& what) {
        proposals_.leave_out(xml_.line(node), in_quotes(quantity_.name) + ": " + what);
    }

    static std::string unit_text(const xml_node& value) {
        for (const char* name : {"unit", "unitXMLList", "listUnit"})
            if (const xml_node unit = child_called(value, name)) return trimmed_text(unit);
        return {};
    }

    /// Of the same value in several units the first with an uncertainty and a known unit, else with a known
    /// unit.
    xml_node best_of(const xml_node& hybrid) {
        xml_node best, any;
        std::size_t values = 0;
        for (const xml_node& value : hybrid.children()) {
            if (value.type() != pugi::node_element) continue;
            ++values;
            const bool known = unit_of_dsi(TextList(unit_text(value)).at(0)).has_value();
            if (known && !any) any = value;
            if (known && !best && statement_in(value)) best = value;
        }
        if (!best) best = any ? any : hybrid.first_child();
        if (values > 1)
            leave_out(hybrid, "the same in other units (" + unit_text(best).substr(0, 40) + " is taken)");
        return best;
    }

    tl::unexpected<Error> refused(const xml_node& node, const std::string& message) const {
        return xml_.refused(node, in_quotes(quantity_.name) + ": " + message);
    }

    Result<double> number(const xml_node& node, const std::string& text, const std::string& what) const {
        if (const auto value = number_in_text(text)) return *value;
        return refused(node, what + " " + in_quotes(plain_name(text)) + " is no number");
    }

    /// False where the unit is not known, which is said.
    Result<bool> add(const xml_node& node, const std::string& value, const std::string& unit,
                     const std::string& label) {
        const auto parsed = unit_of_dsi(unit);
        if (!parsed) {
            leave_out(node, parsed.error().message);
            return false;
        }
        const auto estimate = number(node, value, "the value");
        if (!estimate) return fail(estimate.error());
        StatedQuantity q{.symbol = "", .name = quantity_.name, .value = *estimate, .unit = *parsed};
        if (!label.empty()) q.name += " [" + plain_name(label) + "]";
        quantity_.values.push_back(std::move(q));
        return true;
    }

    Result<void> read_real(const xml_node& node) {
        quantity_.scalar = true;
        const auto added = add(node, text_of_child(node, "value"), unit_text(node), "");
        if (!added || !*added) return added ? Result<void>() : fail(added.error());
        return state(node, statement_of(node), 0);
    }

    Result<void> read_list(const xml_node& node) {
        const TextList values(text_of_child(node, "valueXMLList")), units(unit_text(node));
        const Statement statement = statement_of(node);
        const std::size_t n = values.items.size();
        if (!units.fits(n) || !statement.fits(n))
            return refused(node,
                           "its lists have different lengths than the " + std::to_string(n) + " values");
        for (std::size_t i = 0; i < n; ++i) {
            const auto added = add(node, values.items[i], units.at(i), n > 1 ? std::to_string(i + 1) : "");
            if (!added || !*added) return added ? Result<void>() : fail(added.error());
            if (auto stated = state(node, statement, i); !stated) return stated;
        }
        return {};
    }

    /// A vector: values with labels, a unit for all, and a covariance matrix or uncertainties of each.
    Result<void> read_vector(const xml_node& list) {
        const xml_node inner = child_called(list, "realList");
        const xml_node vector = inner ? inner : list;
        const std::string common = unit_text(vector);
        for (const xml_node& child : vector.children()) {
            if (local_name(child) != "real") continue;
            const std::string own = unit_text(child);
            const auto added = add(child, text_of_child(child, "value"), own.empty() ? common : own,
                                   text_of_child(child, "label"));
            if (!added || !*added) return added ? Result<void>() : fail(added.error());
            if (auto stated = state(child, statement_of(child), 0); !stated) return stated;
        }
        for (StatedQuantity& q : quantity_.values) q.group = quantity_.name;
        for (xml_node at = vector; at; at = next_element(at, vector, false))
            if (local_name(at).starts_with("covarianceMatrix")) return read_covariance(at);
        return {};
    }

    /// Shape and figures of one uncertainty.
    Result<void> state(const xml_node& node, const Statement& statement, std::size_t i) {
        if (!statement.node) return {};
        StatedQuantity& q = quantity_.values.back();
        const StatedTexts texts = statement.at(i);
        if (!texts.standard.empty()) {
            if (statement.interval && i == 0)
                leave_out(node, "its coverage interval; the standard uncertainty is taken");
            const auto u = number(node, texts.standard, "the standard uncertainty");
            if (!u) return fail(u.error());
            q.statement = "standard";
            q.a = *u;
        } else if (!texts.expanded.empty()) {
            if (auto read = state_expanded(node, texts, q); !read) return read;
        }
        if (q.a && *q.a < 0.0) return refused(node, "its uncertainty is negative");
        take_shape(node, texts.distribution, q);
        return {};
    }

    Result<void> state_expanded(const xml_node& node, const StatedTexts& texts, StatedQuantity& q) {
        const auto expanded = number(node, texts.expanded, "the expanded uncertainty");
        if (!expanded) return fail(expanded.error());
        const bool has_factor = !texts.factor.empty();
        if (!has_factor && texts.probability.empty()) {
            leave_out(node, "its expanded uncertainty: neither k nor p is stated");
            return {};
        }
        const auto second = number(node, has_factor ? texts.factor : texts.probability,
                                   has_factor ? "the coverage factor" : "the coverage probability");
        if (!second) return fail(second.error());
        if (!(*second > 0.0) || (!has_factor && !(*second < 1.0)))
            return refused(node, has_factor ? "k must be greater than 0" : "p must be between 0 and 1");
        q.statement = has_factor ? "certificate-k" : "certificate-p";
        q.a = *expanded;
        q.b = has_factor ? *second : 100.0 * *second;
        if (has_factor && !texts.probability.empty()) q.source = "p = " + plain_name(texts.probability);
        if (has_factor && *second > 2.05 && number_in_text(texts.probability).value_or(1.0) < 0.96)
            leave_out(node, "k = " + readable_number(*second) +
                                " means few degrees of freedom, which are not stated: enter nu");
        return {};
    }

    void take_shape(const xml_node& node, const std::string& distribution, StatedQuantity& q) {
        if (!q.a || distribution.empty() || distribution == "normal" || distribution == "gaussian") return;
        const bool has_u = q.statement == "standard" || q.statement == "certificate-k";
        const double u = q.statement == "certificate-k" ? *q.a / *q.b : *q.a;
        if (has_u && (distribution == "uniform" || distribution == "rectangular")) {
            q.statement = "rectangular";
            q.a = std::sqrt(3.0) * u;
            q.b.reset();
        } else if (has_u && distribution == "triangular") {
            q.statement = "triangular";
            q.a = std::sqrt(6.0) * u;
            q.b.reset();
        } else
            leave_out(node, "its distribution " + in_quotes(plain_name(distribution)) + "; normal is taken");
    }

    Result<void> read_covariance(const xml_node& matrix) {
        const auto n = static_cast<Eigen::Index>(quantity_.values.size());
        if (n > static_cast<Eigen::Index>(most_stated_quantities)) return {};  // said by who counts them
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
        Eigen::Index column = 0, count = 0;
        for (const xml_node& c : matrix.children()) {
            if (local_name(c) != "column") continue;
            Eigen::Index row = 0;
            for (const xml_node& cell : c.children()) {
                if (local_name(cell) != "covariance") continue;
                const auto unit = unit_of_dsi(text_of_child(cell, "unit"));
                if (!unit) {
                    leave_out(cell, "its covariance matrix: " + unit.error().message);
                    return {};
                }
                const auto value = number(cell, text_of_child(cell, "value"), "the covariance");
                if (!value) return fail(value.error());
                if (row < n && column < n) covariance(row, column) = unit->interval_to_si(*value);
                ++row, ++count;
            }
            ++column;
        }
        if (count != n * n || column != n)
            return refused(matrix, "its covariance matrix has not " + std::to_string(n) + " x " +
                                       std::to_string(n) + " elements");
        return take_covariance(matrix, covariance);
    }

    Result<void> take_covariance(const xml_node& matrix, const Eigen::MatrixXd& covariance) {
        const Eigen::VectorXd u = covariance.diagonal().cwiseSqrt();
        if (!u.allFinite()) return refused(matrix, "its covariance matrix has a negative variance");
        const Eigen::VectorXd inverse = u.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
        const Eigen::MatrixXd r = inverse.asDiagonal() * covariance * inverse.asDiagonal();
        const Eigen::MatrixXd asymmetry = r - r.transpose();
        if (!r.allFinite() || asymmetry.cwiseAbs().maxCoeff() > 1e-6 ||
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(r).eigenvalues().minCoeff() < -1e-6)
            return refused(matrix,
                           "its matrix is no covariance matrix: not symmetric, or a variance of some "
                           "combination is negative");
        for (Eigen::Index i = 0; i < u.size(); ++i) {
            StatedQuantity& q = quantity_.values[static_cast<std::size_t>(i)];
            q.statement = "standard";
            q.a = q.unit.interval_from_si(u[i]);
            q.b.reset();
            for (Eigen::Index j = 0; j < i; ++j)
                quantity_.correlations.push_back({static_cast<std::size_t>(j), static_cast<std::size_t>(i),
                                                  std::clamp(r(i, j), -1.0, 1.0)});
        }
        return {};
    }

    const XmlText& xml_;
    DccQuantity& quantity_;
    Proposals& proposals_;
};

}  // namespace

std::string dcc_name(const pugi::xml_node& node) {
    const xml_node name = child_called(node, "name");
    xml_node first;
    for (const xml_node& content : name.children()) {
        if (local_name(content) != "content") continue;
        if (!first) first = content;
        if (std::string_view(content.attribute("lang").value()) == "en")
            return plain_name(trimmed_text(content));
    }
    return plain_name(trimmed_text(first));
}

Result<DccQuantity> read_dcc_quantity(const XmlText& xml, const pugi::xml_node& quantity,
                                      Proposals& proposals) {
    DccQuantity read;
    read.line = xml.line(quantity);
    read.name = dcc_name(quantity);
    read.ref_type = quantity.attribute("refType").value();
    if (read.name.empty()) read.name = "quantity of line " + std::to_string(read.line);
    if (auto done = QuantityReader(xml, read, proposals).read(quantity); !done) return fail(done.error());
    return read;
}

}  // namespace covaria
