// Suncal (Sandia): project files in YAML; the calculations of modes "uncertainty" and "system".
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/utf8.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/pint_unit.h"
#include "core/readers/stated_budget.h"
#include "core/readers/suncal_figures.h"
#include "core/readers/unstated_units.h"
#include "core/readers/xml_text.h"
#include "core/readers/yaml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// The equation of an expression, with the powers of Python replaced and names by their symbols; names are
/// collected in `used`, and all else stays.
std::string equation_of(const std::string& expression, const std::map<std::string, std::string>& symbols,
                        std::set<std::string>& used) {
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
            used.insert(word);
            at = end;
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            // A number such as 1e-5 is copied whole: its e is no name.
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

/// Keys of the parts of a calculation in a mode.
struct SuncalKeys {
    const char *name, *value, *components, *equation;
};
constexpr SuncalKeys uncertainty_keys{"name", "mean", "uncerts", "expr"};
constexpr SuncalKeys system_keys{"symbol", "testpoint", "typeb", "equation"};

constexpr std::size_t most_suncal_observations = 10'000;

std::vector<const YamlNode*> pointers(const YamlNode& list) {
    std::vector<const YamlNode*> nodes;
    for (const YamlNode& node : list.children) nodes.push_back(&node);
    return nodes;
}

std::size_t valid_notes(const std::string& notes) {
    return std::min<std::size_t>(valid_utf8(notes), 4000);
}

const YamlNode* list_of(const YamlNode& part, const char* key) {
    const YamlNode* list = part.find(key);
    return list && list->kind == YamlNode::Kind::list ? list : nullptr;
}

std::string description_of(const YamlNode& node) {
    const std::string text = plain_name(node.text_of("desc"));
    return text.empty() ? plain_name(node.text_of("description")) : text;
}

/// The component of the mean of another number of observations, by the standard deviation of these.
NotedComponent mean_of_new(const std::vector<double>& values, double count, const Unit& unit) {
    const double n = static_cast<double>(values.size());
    double mean = 0.0, squares = 0.0;
    for (const double value : values) mean += (value - values[0]) / n;
    mean += values[0];
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {.name = "Type A",
            .statement = "standard",
            .a = std::sqrt(squares / (n - 1.0) / count),
            .degrees_of_freedom = n - 1.0,
            .unit = unit.interval(),
            .source =
                "s of " + std::to_string(values.size()) + " observations, mean of " + shortest_number(count)};
}

Result<PintUnit> unit_of(const YamlNode& node, const PintUnit& otherwise) {
    const YamlNode* text = node.find("units");
    if (!text || text->text.empty() || text->text == "null" || text->text == "None") return otherwise;
    const auto unit = unit_of_pint(text->text);
    if (!unit) return text->refused(unit.error().message);
    return *unit;
}

bool is_infinite(const std::string& text) {
    return text == ".inf" || text == ".Inf" || text == "inf" || text == ".INF";
}

void leave_out_others(Proposals& proposals, const YamlNode& map, const std::string& where,
                      std::initializer_list<const char*> known) {
    for (std::size_t i = 0; i < map.keys.size(); ++i) {
        const YamlNode& value = map.children[i];
        const bool empty = value.kind == YamlNode::Kind::nothing ||
                           (value.kind == YamlNode::Kind::list && value.children.empty());
        if (!empty &&
            std::none_of(known.begin(), known.end(), [&](const char* key) { return map.keys[i] == key; }))
            proposals.leave_out(value.line, where + in_quotes(plain_name(map.keys[i])));
    }
}

/// The symbols that stand for the names of a calculation.
struct SuncalNames {
    SymbolNames taken;
    std::map<std::string, std::string> symbols;
    std::set<std::string> used;  ///< names that the equations use

    std::string symbol_of(const std::string& name, Proposals& proposals) {
        const std::string symbol = taken.take(name);
        symbols[name] = symbol;
        if (symbol != name)
            proposals.found.push_back(tell<"%1 is called %2 here">(in_quotes(plain_name(name)), symbol));
        return symbol;
    }
};

/// One input with its observations and components.
class SuncalInput {
public:
    /// `observations` counts those of the file so far; `together` says that lists of observations were made
    /// together.
    SuncalInput(const ReadChoice& choice, const SuncalKeys& keys, SuncalNames& names, Proposals& proposals,
                std::size_t& observations, bool together)
        : choice_(choice),
          keys_(keys),
          names_(names),
          proposals_(proposals),
          observations_(observations),
          together_(together) {}

    Result<NotedQuantity> read(const YamlNode& input) {
        const std::string name = input.text_of(keys_.name);
        if (name.empty()) return input.refused(tell<"an input without a name">());
        const std::string where = in_quotes(plain_name(name)) + ": ";
        auto unit = unit_of(input, {});
        if (!unit) return fail(unit.error());
        const YamlNode* mean = input.find(keys_.value);
        const auto value = mean ? mean->number() : std::nullopt;
        if (!value)
            return (mean ? *mean : input).refused(where + tell<"its %1 must be a number">(keys_.value));
        if (names_.symbols.contains(name))
            return input.refused(where + tell<"there are two inputs of that name">());
        if (!input.find("units"))
            unit->unit = unstated_unit(choice_, plain_name(name), description_of(input), Unit(), proposals_);
        // The equations of Suncal take every temperature in kelvin, as pint does.
        if (const Unit stated = unit->unit; stated.has_offset())
            *unit = {stated.interval(), unit->scale, unit->zero - stated.to_si(0.0) / unit->scale};
        NotedQuantity quantity{
            names_.symbol_of(name, proposals_), description_of(input), unit->value(*value), unit->unit, {}};
        if (unit->is_converted())
            proposals_.found.push_back(
                where + tell<"%1 %2 is %3 %4">(shortest_number(*value), plain_name(input.text_of("units")),
                                               readable_number(quantity.value), unit->unit.display()));
        leave_out_others(proposals_, input, where,
                         {keys_.name, "name", "desc", "description", "type", keys_.value, "units",
                          keys_.components, "typea", "typea_uncert", "numnewmeas", "autocorrelate"});
        if (auto done = read_observations(input, *unit, quantity, where); !done) return fail(done.error());
        if (const YamlNode* uncerts = list_of(input, keys_.components))
            for (const YamlNode& uncert : uncerts->children) {
                auto component = read_uncertainty(uncert, quantity, *unit, *value, where);
                if (!component) return fail(component.error());
                quantity.components.push_back(std::move(*component));
            }
        return quantity;
    }

private:
    /// Reads repeated observations, or the standard uncertainty of their mean.
    Result<void> read_observations(const YamlNode& input, const PintUnit& unit, NotedQuantity& quantity,
                                   const std::string& where) {
        if (const YamlNode* stated = input.find("typea_uncert")) {
            const auto u = stated->number();
            if (!u || !(*u >= 0.0))
                return stated->refused(where + tell<"typea_uncert must be a number from 0">());
            quantity.components.push_back({.name = "Type A",
                                           .statement = "standard",
                                           .a = unit.interval(*u),
                                           .unit = quantity.unit.interval()});
        }
        const YamlNode* list = input.find("typea");
        if (!list) return {};
        if (list->kind != YamlNode::Kind::list || list->children.size() < 2)
            return list->refused(where + tell<"typea must be a list of at least two observations">());
        std::vector<double> values;
        for (const YamlNode& node : list->children) {
            const auto value = node.number();
            if (!value)
                return node.refused(where +
                                    tell<"an observation must be a number; those in groups are not read">());
            if (++observations_ > most_suncal_observations)
                return node.refused(tell<"more than %1 observations are not read">(most_suncal_observations));
            values.push_back(unit.value(*value));
        }
        const YamlNode* means = input.find("numnewmeas");
        const auto count = means ? means->number() : std::optional(static_cast<double>(values.size()));
        if (!count || !(*count >= 1.0))
            return means->refused(where + tell<"numnewmeas must be a number from 1">());
        if (values.size() > 50)
            proposals_.found.push_back(where +
                                       tell<"its observations are taken as independent: Suncal enlarges the "
                                            "uncertainty of more than 50 that are autocorrelated">());
        if (*count == static_cast<double>(values.size())) {
            quantity.observations = std::move(values);
            quantity.observed_together = together_;
            return {};
        }
        quantity.components.push_back(mean_of_new(values, *count, quantity.unit));
        return {};
    }

    /// A figure of a component: a number, or shares of the mean and of ranges ("5% + 0.01%range(10)").
    Result<std::optional<double>> figure(const YamlNode& node, const char* key, double mean,
                                         const std::string& where) {
        const YamlNode* value = node.find(key);
        if (!value) return std::optional<double>();
        if (const auto number = value->number()) return std::optional<double>(*number);
        const auto read = value->kind == YamlNode::Kind::scalar ? suncal_figure(value->text, mean)
                                                                : std::optional<double>();
        if (!read)
            return value->refused(where +
                                  tell<"%1 %2 is no number">(key, in_quotes(plain_name(value->text))));
        proposals_.found.push_back(
            where + tell<"%1 %2 is %3">(key, in_quotes(plain_name(value->text)), readable_number(*read)));
        return std::optional<double>(*read);
    }

    Result<NotedComponent> read_uncertainty(const YamlNode& node, const NotedQuantity& quantity,
                                            const PintUnit& of_quantity, double stated_mean,
                                            const std::string& where) {
        const auto unit = unit_of(node, {of_quantity.unit.interval(), of_quantity.scale, 0.0});
        if (!unit) return fail(unit.error());
        const Unit own = unit->unit.interval();
        NotedComponent c{.name = description_of(node), .unit = own};
        if (c.name.empty()) c.name = plain_name(node.text_of("name"));
        if (const YamlNode* nu = node.find("degf"); nu && !is_infinite(nu->text)) {
            c.degrees_of_freedom = nu->number();
            if (!c.degrees_of_freedom || !(*c.degrees_of_freedom > 0.0))
                return nu->refused(where + tell<"degf must be a number greater than 0, or .inf">());
        }
        // Shares are taken of the mean as it stands, in the unit of the component.
        const double mean = of_quantity.zero != 0.0 ? stated_mean
                                                    : quantity.unit.interval_to_si(quantity.value) /
                                                          own.interval_to_si(unit->scale);
        std::map<std::string, double> figures;
        for (const char* key : {"a", "d", "unc", "std", "k", "conf", "v"}) {
            const auto value = figure(node, key, mean, where);
            if (!value) return fail(value.error());
            const bool number = *key == 'k' || *key == 'c';
            if (*value) figures[key] = number ? **value : unit->interval(**value);
        }
        std::string how;
        const Message complaint = state_suncal(node.text_of("dist"), figures, c, how);
        if (!complaint.empty()) return node.refused(where + complaint);
        if (!how.empty()) proposals_.found.push_back(where + how);
        leave_out_others(proposals_, node, where,
                         {"name", "desc", "description", "dist", "degf", "df", "units", "a", "d", "unc",
                          "std", "k", "conf", "v"});
        return c;
    }

    const ReadChoice& choice_;
    const SuncalKeys& keys_;
    SuncalNames& names_;
    Proposals& proposals_;
    std::size_t& observations_;
    bool together_;
};

class SuncalReader {
public:
    explicit SuncalReader(const ReadChoice& choice) : choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
    }

    Result<Proposals> read(const YamlNode& root) {
        std::vector<const YamlNode*> parts;
        if (root.kind == YamlNode::Kind::list)
            for (const YamlNode& part : root.children) parts.push_back(&part);
        if (root.kind == YamlNode::Kind::map) parts.push_back(&root);
        for (const YamlNode* part : parts)
            if (auto done = read_part(*part); !done) return fail(done.error());
        if (proposals_.analyses.empty())
            return root.refused(tell<"the file has no calculation of mode 'uncertainty' or 'system'%1">(
                skipped_.empty() ? Message() : tell<"; it has %1">(skipped_)));
        return std::move(proposals_);
    }

private:
    Result<void> read_part(const YamlNode& part) {
        std::string mode = plain_name(part.text_of("mode"));
        if (mode.empty() && part.find("functions") && part.find("inputs")) mode = "uncertainty";
        if (mode == "uncertainty") return read_uncertainty_part(part);
        if (mode == "system") return read_system_part(part);
        const std::string words = mode.empty() ? "an entry without mode" : "mode " + in_quotes(mode);
        skipped_ += (skipped_.empty() ? "" : ", ") + words;
        proposals_.leave_out(part.line, words);
        return {};
    }

    void begin(const YamlNode& part) {
        budget_ = {};
        names_ = {};
        observations_ = 0;
        budget_.name = plain_name(part.text_of("name"));
        if (budget_.name.empty() || budget_.name == "uncertainty" || budget_.name == "system")
            budget_.name = proposals_.title;
        if (budget_.name.empty()) budget_.name = "Budget";
        budget_.id = id_of(budget_.name, "budget");
        budget_.notes = part.text_of("description");
        if (budget_.notes.empty()) budget_.notes = part.text_of("desc");
        budget_.notes.resize(valid_notes(budget_.notes));
    }

    void finish() {
        proposals_.found.push_back(tell<"%1: %2 quantities, %3 results">(
            budget_.name, budget_.quantities.size(), budget_.results.size()));
        for (AnalysisEntry& before : proposals_.analyses)
            if (before.id == budget_.id) budget_.id += "-" + std::to_string(proposals_.analyses.size() + 1);
        proposals_.analyses.push_back(analysis_of(budget_));
    }

    Result<void> read_uncertainty_part(const YamlNode& part) {
        begin(part);
        leave_out_others(proposals_, part, "",
                         {"mode", "name", "description", "desc", "functions", "inputs", "correlations"});
        keys_ = uncertainty_keys;
        const YamlNode *inputs = list_of(part, "inputs"), *functions = list_of(part, "functions");
        if (!inputs || inputs->children.empty()) return part.refused(tell<"the calculation has no inputs">());
        if (!functions || functions->children.empty())
            return part.refused(tell<"the calculation has no functions">());
        if (auto done = read_inputs(*inputs, pointers(*inputs)); !done) return done;
        if (auto done = read_functions(*functions, pointers(*functions)); !done) return done;
        if (auto done = read_correlations(part); !done) return done;
        finish();
        return {};
    }

    /// Reads a system: quantities that are measured directly, and those that follow from them, in one model.
    Result<void> read_system_part(const YamlNode& part) {
        begin(part);
        leave_out_others(proposals_, part, "",
                         {"mode", "name", "description", "desc", "quantities", "correlate"});
        keys_ = system_keys;
        const YamlNode* quantities = list_of(part, "quantities");
        if (!quantities) return part.refused(tell<"the system has no quantities">());
        std::vector<const YamlNode*> direct, indirect;
        for (const YamlNode& quantity : quantities->children) {
            const std::string type = plain_name(quantity.text_of("type"));
            if (type != "direct" && type != "indirect")
                return quantity.refused(
                    tell<"quantities of type %1 are not read; those that are: direct, indirect">(
                        in_quotes(type)));
            (type == "direct" ? direct : indirect).push_back(&quantity);
        }
        if (direct.empty()) return quantities->refused(tell<"the system has no direct quantity">());
        together_ = part.text_of("correlate") != "false";
        if (auto done = read_inputs(*quantities, direct); !done) return done;
        if (auto done = read_functions(*quantities, indirect); !done) return done;
        // A quantity that no equation uses is a result as it stands.
        for (const YamlNode* node : direct) {
            const std::string name = node->text_of(keys_.name);
            if (names_.used.contains(name)) continue;
            const NotedQuantity& quantity = budget_.quantities[*index_of(name)];
            const std::string symbol = names_.taken.take("y_" + quantity.symbol);
            budget_.equations += (budget_.equations.empty() ? "" : "\n") + symbol + " = " + quantity.symbol;
            budget_.results.push_back({symbol, quantity.name, quantity.unit});
        }
        finish();
        return {};
    }

    Result<void> read_inputs(const YamlNode& list, const std::vector<const YamlNode*>& inputs) {
        if (inputs.size() > most_stated_quantities)
            return list.refused(tell<"more than %1 inputs are not read">(most_stated_quantities));
        for (const YamlNode* input : inputs)
            if (auto quantity =
                    SuncalInput(choice_, keys_, names_, proposals_, observations_, together_).read(*input))
                budget_.quantities.push_back(std::move(*quantity));
            else
                return fail(quantity.error());
        return {};
    }

    Result<void> read_functions(const YamlNode& list, const std::vector<const YamlNode*>& functions) {
        if (functions.size() > most_stated_quantities)
            return list.refused(tell<"more than %1 functions are not read">(most_stated_quantities));
        for (const YamlNode* function : functions) {
            std::string name = function->text_of(keys_.name);
            if (name.empty()) name = "f_" + std::to_string(budget_.results.size());
            if (names_.symbols.contains(name))
                return function->refused(
                    tell<"a function has the name of an input or of another function">());
            const auto unit = unit_of(*function, {});
            if (!unit) return fail(unit.error());
            NotedResult result{names_.symbol_of(name, proposals_), description_of(*function), {}};
            if (!function->text_of("units").empty()) result.unit = unit->unit;
            if (unit->is_converted())
                proposals_.found.push_back(
                    tell<"%1: in %2 instead of %3">(in_quotes(plain_name(name)), unit->unit.display(),
                                                    plain_name(function->text_of("units"))));
            leave_out_others(proposals_, *function, in_quotes(plain_name(name)) + ": ",
                             {keys_.name, "name", "desc", "description", "type", keys_.equation, "units"});
            budget_.results.push_back(std::move(result));
        }
        for (std::size_t i = 0; i < functions.size(); ++i)
            if (auto done = read_equation(*functions[i], budget_.results[i]); !done) return done;
        return {};
    }

    Result<void> read_equation(const YamlNode& function, const NotedResult& result) {
        const YamlNode* node = function.find(keys_.equation);
        const std::string text = node ? node->text : std::string();
        const YamlNode& place = node ? *node : function;
        const std::size_t sign = text.find('='), semicolon = text.find(';');
        std::string equation;
        if (sign == std::string::npos) {
            equation = result.symbol + " = " + equation_of(text, names_.symbols, names_.used);
        } else if (semicolon == std::string::npos) {  // an equation "f = a*b"
            equation =
                result.symbol + " = " + equation_of(text.substr(sign + 1), names_.symbols, names_.used);
        } else {  // an equation "a*f**2 - b = 0; f~3", solved from a starting value
            const std::size_t tilde = text.find('~', semicolon);
            const auto start =
                tilde == std::string::npos ? std::optional(1.0) : number_in_text(text.substr(tilde + 1));
            if (!start) return place.refused(tell<"%1: no starting value">(in_quotes(plain_name(text))));
            if (!result.unit)
                return place.refused(tell<"%1: state the unit of what is solved for under 'units'">(
                    in_quotes(plain_name(text))));
            equation = "solve " + result.symbol + " = " + shortest_number(*start) + " [" +
                       result.unit->text() +
                       "]: " + equation_of(text.substr(0, semicolon), names_.symbols, names_.used);
        }
        if (const Message complaint = equation_complaint(equation); !complaint.empty())
            return place.refused(in_quotes(plain_name(equation)) + ": " + complaint);
        budget_.equations += (budget_.equations.empty() ? "" : "\n") + equation;
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
                return entry.refused(tell<"a correlation needs var1 and var2, two inputs, and cor, a number "
                                          "between -1 and 1">());
            budget_.correlations.push_back({*first, *second, *value});
        }
        return {};
    }

    std::optional<std::size_t> index_of(const std::string& name) const {
        const auto symbol = names_.symbols.find(name);
        for (std::size_t i = 0; symbol != names_.symbols.end() && i < budget_.quantities.size(); ++i)
            if (budget_.quantities[i].symbol == symbol->second) return i;
        return std::nullopt;
    }

    const ReadChoice& choice_;
    Proposals proposals_;
    StatedBudget budget_;
    SuncalNames names_;
    std::string skipped_;
    SuncalKeys keys_ = uncertainty_keys;
    std::size_t observations_ = 0;
    bool together_ = false;  ///< whether lists of observations were made together
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
            .takes =
                "calculations of modes uncertainty and system: functions, quantities with their components "
                "and observations -> measurement equation",
            .recognise = recognise_suncal,
            .read = read_suncal};
}

}  // namespace covaria
