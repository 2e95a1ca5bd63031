// Suncal (Sandia): project files in YAML; the calculations of mode "uncertainty".
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "core/base/in_quotes.h"
#include "core/base/utf8.h"
#include "core/math/normal_quantile.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/pint_unit.h"
#include "core/readers/stated_budget.h"
#include "core/readers/xml_text.h"
#include "core/readers/yaml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// Python's powers and the symbols that names became; all else stays.
std::string equation_of(const std::string& expression, const std::map<std::string, std::string>& symbols) {
    std::string equation;
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (std::size_t at = 0; at < expression.size();) {
        const char c = expression[at];
        if (std::isalpha(static_cast<unsigned char>(c)) || c == '_') {
            std::size_t end = at;
            while (end < expression.size() && is_word(expression[end])) ++end;
            const std::string word = expression.substr(at, end - at);
            const auto symbol = symbols.find(word);
            equation += symbol == symbols.end() ? word : symbol->second;
            at = end;
        } else if (std::isdigit(static_cast<unsigned char>(c))) {  // 1e-5: its e is no name
            std::size_t end = at;
            while (end < expression.size() && (is_word(expression[end]) || expression[end] == '.')) ++end;
            equation += expression.substr(at, end - at);
            at = end;
        } else {
            const bool power = expression.compare(at, 2, "**") == 0;
            equation += power ? '^' : (c == '\n' || c == '\r' ? ' ' : c);
            at += power ? 2 : 1;
        }
    }
    return equation;
}

class SuncalReader {
public:
    explicit SuncalReader(const ReadChoice& choice) { proposals_.title = without_ending(choice.file_name); }

    Result<Proposals> read(const YamlNode& root) {
        if (root.kind == YamlNode::Kind::list)
            for (const YamlNode& part : root.children)
                if (auto done = read_part(part); !done) return fail(done.error());
        if (root.kind == YamlNode::Kind::map)
            if (auto done = read_part(root); !done) return fail(done.error());
        if (proposals_.analyses.empty())
            return root.refused("the file has no calculation of mode 'uncertainty'" +
                                (skipped_.empty() ? "" : "; it has " + skipped_));
        return std::move(proposals_);
    }

private:
    Result<void> read_part(const YamlNode& part) {
        std::string mode = plain_name(part.text_of("mode"));
        if (mode.empty() && part.find("functions") && part.find("inputs")) mode = "uncertainty";
        if (mode != "uncertainty") {
            const std::string words = mode.empty() ? "an entry without mode" : "mode " + in_quotes(mode);
            skipped_ += (skipped_.empty() ? "" : ", ") + words;
            proposals_.leave_out(part.line, words);
            return {};
        }
        budget_ = {};
        symbols_.clear();
        names_ = {};
        budget_.name = plain_name(part.text_of("name"));
        if (budget_.name.empty() || budget_.name == "uncertainty") budget_.name = proposals_.title;
        if (budget_.name.empty()) budget_.name = "Budget";
        budget_.id = id_of(budget_.name, "budget");
        budget_.notes = part.text_of("description");
        budget_.notes.resize(valid_notes(budget_.notes));
        leave_out_others(part, "", {"mode", "name", "description", "functions", "inputs", "correlations"});
        for (const auto read :
             {&SuncalReader::read_inputs, &SuncalReader::read_functions, &SuncalReader::read_correlations})
            if (auto done = (this->*read)(part); !done) return done;
        proposals_.found.push_back(budget_.name + ": " + std::to_string(budget_.quantities.size()) +
                                   " quantities, " + std::to_string(budget_.results.size()) + " results");
        for (AnalysisEntry& before : proposals_.analyses)
            if (before.id == budget_.id) budget_.id += "-" + std::to_string(proposals_.analyses.size() + 1);
        proposals_.analyses.push_back(analysis_of(budget_));
        return {};
    }

    static std::size_t valid_notes(const std::string& notes) {
        return std::min<std::size_t>(valid_utf8(notes), 4000);
    }

    void leave_out_others(const YamlNode& map, const std::string& where,
                          std::initializer_list<const char*> known) {
        for (std::size_t i = 0; i < map.keys.size(); ++i) {
            const YamlNode& value = map.children[i];
            const bool empty = value.kind == YamlNode::Kind::nothing ||
                               (value.kind == YamlNode::Kind::list && value.children.empty());
            if (!empty &&
                std::none_of(known.begin(), known.end(), [&](const char* key) { return map.keys[i] == key; }))
                proposals_.leave_out(value.line, where + in_quotes(plain_name(map.keys[i])));
        }
    }

    static const YamlNode* list_of(const YamlNode& part, const char* key) {
        const YamlNode* list = part.find(key);
        return list && list->kind == YamlNode::Kind::list ? list : nullptr;
    }

    std::string symbol_of(const std::string& name) {
        const std::string symbol = names_.take(name);
        symbols_[name] = symbol;
        if (symbol != name)
            proposals_.found.push_back(in_quotes(plain_name(name)) + " is called " + symbol + " here");
        return symbol;
    }

    Result<void> read_inputs(const YamlNode& part) {
        const YamlNode* inputs = list_of(part, "inputs");
        if (!inputs || inputs->children.empty()) return part.refused("the calculation has no inputs");
        if (inputs->children.size() > most_stated_quantities)
            return inputs->refused("more than " + std::to_string(most_stated_quantities) +
                                   " inputs are not read");
        for (const YamlNode& input : inputs->children)
            if (auto done = read_input(input); !done) return done;
        return {};
    }

    Result<void> read_input(const YamlNode& input) {
        const std::string name = input.text_of("name");
        if (name.empty()) return input.refused("an input without a name");
        const std::string where = in_quotes(plain_name(name)) + ": ";
        const auto unit = unit_of(input, Unit());
        if (!unit) return fail(unit.error());
        const YamlNode* mean = input.find("mean");
        const auto value = mean ? mean->number() : std::nullopt;
        if (!value) return (mean ? *mean : input).refused(where + "its mean must be a number");
        if (symbols_.contains(name)) return input.refused(where + "there are two inputs of that name");
        NotedQuantity quantity{symbol_of(name), plain_name(input.text_of("desc")), *value, *unit, {}};
        leave_out_others(input, where, {"name", "desc", "mean", "units", "uncerts"});
        if (const YamlNode* uncerts = list_of(input, "uncerts"))
            for (const YamlNode& uncert : uncerts->children) {
                auto component = read_uncertainty(uncert, quantity, where);
                if (!component) return fail(component.error());
                quantity.components.push_back(std::move(*component));
            }
        budget_.quantities.push_back(std::move(quantity));
        return {};
    }

    static Result<Unit> unit_of(const YamlNode& node, const Unit& otherwise) {
        const YamlNode* text = node.find("units");
        if (!text || text->text.empty()) return otherwise;
        const auto unit = unit_of_pint(text->text);
        if (!unit) return text->refused(unit.error().message);
        return *unit;
    }

    /// A figure of a component, or part of the mean ("5%").
    static Result<std::optional<double>> figure(const YamlNode& node, const char* key, double mean,
                                                const std::string& where) {
        const YamlNode* value = node.find(key);
        if (!value) return std::optional<double>();
        if (const auto number = value->number()) return std::optional<double>(*number);
        if (!value->text.empty() && value->text.back() == '%')
            if (const auto percent = number_in_text(value->text.substr(0, value->text.size() - 1)))
                return std::optional<double>(*percent / 100.0 * std::abs(mean));
        return value->refused(where + key + " " + in_quotes(plain_name(value->text)) + " is no number");
    }

    Result<NotedComponent> read_uncertainty(const YamlNode& node, const NotedQuantity& quantity,
                                            const std::string& where) {
        const auto unit =
            unit_of(node, quantity.unit.has_offset() ? quantity.unit.interval() : quantity.unit);
        if (!unit) return fail(unit.error());
        NotedComponent c{.name = plain_name(node.text_of("desc")), .unit = *unit};
        if (c.name.empty()) c.name = plain_name(node.text_of("name"));
        if (const YamlNode* nu = node.find("degf"); nu && !is_infinite(nu->text)) {
            c.degrees_of_freedom = nu->number();
            if (!c.degrees_of_freedom || !(*c.degrees_of_freedom > 0.0))
                return nu->refused(where + "degf must be a number greater than 0, or .inf");
        }
        const double mean = quantity.unit.interval_to_si(quantity.value) / unit->interval_to_si(1.0);
        std::map<std::string, double> figures;
        for (const char* key : {"a", "d", "unc", "std", "k", "conf"}) {
            const auto value = figure(node, key, mean, where);
            if (!value) return fail(value.error());
            if (*value) figures[key] = **value;
        }
        const std::string complaint = state(node.text_of("dist"), figures, c);
        if (!complaint.empty()) return node.refused(where + complaint);
        leave_out_others(
            node, where,
            {"name", "desc", "dist", "degf", "df", "units", "a", "d", "unc", "std", "k", "conf"});
        return c;
    }

    static bool is_infinite(const std::string& text) {
        return text == ".inf" || text == ".Inf" || text == "inf" || text == ".INF";
    }

    /// What Suncal's distributions mean, as statements; empty, or what cannot be taken over.
    static std::string state(const std::string& dist, const std::map<std::string, double>& figures,
                             NotedComponent& c) {
        static const std::map<std::string, const char*> limited{{"uniform", "rectangular"},
                                                                {"triangular", "triangular"},
                                                                {"arcsine", "arcsine"},
                                                                {"resolution", "resolution"},
                                                                {"curvtrap", "curvilinear-trapezoid"}};
        const auto has = [&](const char* key) { return figures.contains(key); };
        if (const auto kind = limited.find(dist); kind != limited.end()) {
            if (!has("a")) return "a is missing";
            c.statement = kind->second;
            c.a = figures.at("a");
            if (dist == "curvtrap") {
                if (!has("d")) return "d is missing";
                c.b = figures.at("d");
            }
            return {};
        }
        if (dist != "normal" && dist != "t" && !dist.empty())
            return "the distribution " + in_quotes(plain_name(dist)) + " is not taken over";
        c.statement = "standard";
        if (!has("unc") && !has("std")) return "neither unc nor std is stated";
        c.a = figures.at(has("unc") ? "unc" : "std");
        if (!has("unc")) return {};
        if (has("conf")) {
            const double p = figures.at("conf");
            if (!(p > 0.0 && p < 1.0)) return "conf must lie between 0 and 1";
            if (dist == "t" || !c.degrees_of_freedom) {
                c.statement = "certificate-p";
                c.b = 100.0 * p;
            } else {  // Suncal's normal distribution takes the factor of infinite degrees of freedom
                c.statement = "certificate-k";
                c.b = normal_quantile(0.5 * (1.0 + p));
            }
        } else if (has("k")) {
            c.statement = "certificate-k";
            c.b = figures.at("k");
        }
        return {};
    }

    Result<void> read_functions(const YamlNode& part) {
        const YamlNode* functions = list_of(part, "functions");
        if (!functions || functions->children.empty())
            return part.refused("the calculation has no functions");
        if (functions->children.size() > most_stated_quantities)
            return functions->refused("more than " + std::to_string(most_stated_quantities) +
                                      " functions are not read");
        for (const YamlNode& function : functions->children) {
            const std::string name = function.text_of("name");
            if (symbols_.contains(name)) return function.refused("a function has the name of an input");
            const auto unit = unit_of(function, Unit());
            if (!unit) return fail(unit.error());
            NotedResult result{symbol_of(name), plain_name(function.text_of("desc")), {}};
            if (!function.text_of("units").empty()) result.unit = *unit;
            leave_out_others(function, in_quotes(plain_name(name)) + ": ", {"name", "desc", "expr", "units"});
            budget_.results.push_back(std::move(result));
        }
        for (std::size_t i = 0; i < functions->children.size(); ++i) {
            const YamlNode& function = functions->children[i];
            const YamlNode* text = function.find("expr");
            const std::string equation =
                budget_.results[i].symbol + " = " + equation_of(text ? text->text : "", symbols_);
            if (const std::string complaint = equation_complaint(equation); !complaint.empty())
                return (text ? *text : function).refused(in_quotes(plain_name(equation)) + ": " + complaint);
            budget_.equations += (i > 0 ? "\n" : "") + equation;
        }
        return {};
    }

    Result<void> read_correlations(const YamlNode& part) {
        const YamlNode* list = list_of(part, "correlations");
        if (!list) return {};
        for (const YamlNode& entry : list->children) {
            const auto first = index_of(entry.text_of("var1")), second = index_of(entry.text_of("var2"));
            const YamlNode* r = entry.find("cor");
            const auto value = r ? r->number() : std::nullopt;
            if (!first || !second || first == second || !value || std::abs(*value) > 1.0)
                return entry.refused(
                    "a correlation needs var1 and var2, two inputs, and cor, a number between -1 and 1");
            budget_.correlations.push_back({*first, *second, *value});
        }
        return {};
    }

    std::optional<std::size_t> index_of(const std::string& name) const {
        const auto symbol = symbols_.find(name);
        for (std::size_t i = 0; symbol != symbols_.end() && i < budget_.quantities.size(); ++i)
            if (budget_.quantities[i].symbol == symbol->second) return i;
        return std::nullopt;
    }

    Proposals proposals_;
    StatedBudget budget_;
    SymbolNames names_;
    std::map<std::string, std::string> symbols_;
    std::string skipped_;
};

Recognition recognise_suncal(std::string_view beginning, const std::string&) {
    const auto has = [&](const char* word) { return beginning.find(word) != std::string_view::npos; };
    const bool functions = has("functions:") && has("expr:"), system = has("mode: system") && has("symbol:");
    return functions || system ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_suncal(const std::string& text, const ReadChoice& choice) {
    const auto yaml = parse_yaml(text);
    if (!yaml) return fail(yaml.error());
    return SuncalReader(choice).read(*yaml);
}

}  // namespace

Reader suncal_reader() {
    return {.name = "suncal",
            .title = "Suncal project",
            .pattern = "*.yaml *.yml",
            .takes = "calculations of mode uncertainty: functions and inputs -> measurement equation",
            .recognise = recognise_suncal,
            .read = read_suncal};
}

}  // namespace covaria
