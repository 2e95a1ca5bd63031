#include "core/readers/dcc_quantities.h"

#include <Eigen/Core>

#include "core/base/in_quotes.h"
#include "core/readers/covariance.h"
#include "core/readers/dcc_uncertainty.h"
#include "core/readers/dsi_unit.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

using pugi::xml_node;

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
        if (is_value(name)) leave_out(node, tell<"a value as <%1>">(std::string(name)));
        if (name == "relativeUncertainty") leave_out(node, tell<"its relative uncertainty">());
        return {};
    }

    void leave_out(const xml_node& node, const Message& what) {
        proposals_.leave_out(xml_.line(node), in_quotes(quantity_.name) + ": " + what);
    }

    static std::string unit_text(const xml_node& value) {
        for (const char* name : {"unit", "unitXMLList", "listUnit"})
            if (const xml_node unit = child_called(value, name)) return trimmed_text(unit);
        return {};
    }

    /// The value to take of the same one in several units: the first with an uncertainty and a known unit,
    /// else the first with a known unit.
    xml_node best_of(const xml_node& hybrid) {
        xml_node best, any;
        std::size_t values = 0;
        for (const xml_node& value : hybrid.children()) {
            if (value.type() != pugi::node_element) continue;
            ++values;
            const bool known = unit_of_dsi(TextList(unit_text(value)).at(0)).has_value();
            if (known && !any) any = value;
            if (known && !best && dcc_statement_of(value).node) best = value;
        }
        if (!best) best = any ? any : hybrid.first_child();
        if (values > 1)
            leave_out(hybrid, tell<"the same in other units (%1 is taken)">(unit_text(best).substr(0, 40)));
        return best;
    }

    tl::unexpected<Error> refused(const xml_node& node, const Message& message) const {
        return xml_.refused(node, in_quotes(quantity_.name) + ": " + message);
    }

    Result<double> number(const xml_node& node, const std::string& text, const std::string& what) const {
        if (const auto value = number_in_text(text)) return *value;
        return refused(node, tell<"%1 %2 is no number">(what, in_quotes(plain_name(text))));
    }

    /// Adds a value; where its unit is not known, says so and returns false.
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
        return state(node, dcc_statement_of(node), 0);
    }

    Result<void> read_list(const xml_node& node) {
        const TextList values(text_of_child(node, "valueXMLList")), units(unit_text(node));
        const DccStatement statement = dcc_statement_of(node);
        const std::size_t n = values.items.size();
        if (!units.fits(n) || !statement.fits(n))
            return refused(node, tell<"its lists have different lengths than the %1 values">(n));
        for (std::size_t i = 0; i < n; ++i) {
            const auto added = add(node, values.items[i], units.at(i), n > 1 ? std::to_string(i + 1) : "");
            if (!added || !*added) return added ? Result<void>() : fail(added.error());
            if (auto stated = state(node, statement, i); !stated) return stated;
        }
        return {};
    }

    /// Reads a vector: values with labels, a unit for all, and a covariance matrix or uncertainties of each.
    Result<void> read_vector(const xml_node& list) {
        const xml_node inner = child_called(list, "realList");
        const xml_node vector = inner ? inner : list;
        const std::string common = unit_text(vector);
        const DccStatement of_all = dcc_statement_of(vector);
        std::size_t number = 0;
        for (const xml_node& child : vector.children()) {
            if (local_name(child) != "real") continue;
            ++number;
            const std::string own = unit_text(child), label = text_of_child(child, "label");
            const auto added = add(child, text_of_child(child, "value"), own.empty() ? common : own,
                                   label.empty() ? std::to_string(number) : label);
            if (!added || !*added) return added ? Result<void>() : fail(added.error());
            const DccStatement statement = dcc_statement_of(child);
            if (auto stated = state(child, statement.node ? statement : of_all, 0); !stated) return stated;
        }
        for (StatedQuantity& q : quantity_.values) q.group = quantity_.name;
        for (xml_node at = vector; at; at = next_element(at, vector, false))
            if (local_name(at).starts_with("covarianceMatrix")) return read_covariance(at);
        return {};
    }

    Result<void> state(const xml_node& node, const DccStatement& statement, std::size_t i) {
        const auto left_out = state_uncertainty(statement, i, quantity_.values.back());
        if (!left_out) return refused(node, left_out.error().message);
        for (const std::string& what : *left_out) leave_out(node, what);
        return {};
    }

    Result<void> read_covariance(const xml_node& matrix) {
        const auto n = static_cast<Eigen::Index>(quantity_.values.size());
        // The caller says so, who counts them.
        if (n > static_cast<Eigen::Index>(most_stated_quantities)) return {};
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
        Eigen::Index column = 0, count = 0;
        for (const xml_node& c : matrix.children()) {
            if (local_name(c) != "column") continue;
            Eigen::Index row = 0;
            for (const xml_node& cell : c.children()) {
                if (local_name(cell) != "covariance") continue;
                const auto unit = unit_of_dsi(text_of_child(cell, "unit"));
                if (!unit) {
                    leave_out(cell, tell<"its covariance matrix: %1">(unit.error().message));
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
            return refused(matrix, tell<"its covariance matrix has not %1 x %2 elements">(n, n));
        const auto taken = take_covariance(covariance);
        if (!taken) return refused(matrix, taken.error().message);
        for (Eigen::Index i = 0; i < n; ++i) {
            StatedQuantity& q = quantity_.values[static_cast<std::size_t>(i)];
            q.statement = "standard";
            q.a = q.unit.interval_from_si(taken->u[i]);
            q.b.reset();
        }
        quantity_.correlations = taken->correlations;
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
