#include "core/views/result_words.h"

#include <algorithm>
#include <map>

#include "core/base/file_names.h"
#include "core/base/name.h"
#include "core/text/symbol.h"

namespace covaria::result_words {

std::string type_text(EvaluationType type) {
    return type == EvaluationType::type_a ? "A" : "B";
}

std::string unit_text(const Unit& unit) {
    return unit.text() == "1" ? "1" : unit.display();
}

std::string id_part(const std::string& text) {
    std::string out = file_name_part(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

Text output_text(const OutputQuantity& quantity, const DocumentLanguage& in) {
    const Text symbol = symbol_text(quantity.symbol);
    return quantity.group.empty() ? symbol : symbol + (" (" + in.say(said_name(quantity.group)) + ")");
}

Message output_label(const OutputQuantity& quantity) {
    const std::string symbol = symbol_to_unicode(quantity.symbol);
    return quantity.group.empty() ? Message(symbol) : symbol + " (" + said_name(quantity.group) + ")";
}

Measured value_in(const Unit& unit, double si) {
    return {si, Measured::Scale::value, unit};
}

Measured interval_in(const Unit& unit, double si) {
    return {si, Measured::Scale::interval, unit};
}

Message contributor_title(const ContributorResult& result) {
    return result.contributor.empty() ? tell<"the set-up">() : said_name(result.contributor);
}

bool is_measurand(const OutputResult& output) {
    return output.quantity.role == OutputRole::measurand;
}

std::vector<Name> measurand_groups(const UncertaintyResult& result) {
    std::vector<Name> groups;
    for (const OutputResult& output : result.outputs)
        if (is_measurand(output) &&
            std::find(groups.begin(), groups.end(), output.quantity.group) == groups.end())
            groups.push_back(output.quantity.group);
    return groups;
}

std::vector<std::size_t> measurands_of(const UncertaintyResult& result, const std::string& group) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i]) && result.outputs[i].quantity.group == group)
            indices.push_back(i);
    return indices;
}

bool groups_alike(const UncertaintyResult& result, const std::vector<Name>& groups) {
    const auto quantities = [&result](const std::string& group) {
        std::vector<std::pair<std::string, std::string>> list;
        for (const std::size_t i : measurands_of(result, group))
            list.emplace_back(result.outputs[i].quantity.symbol, result.outputs[i].quantity.unit.text());
        return list;
    };
    return std::all_of(groups.begin(), groups.end(), [&](const std::string& group) {
        return quantities(group) == quantities(groups.front());
    });
}

std::vector<Name> groups_like_the_first(const UncertaintyResult& result) {
    std::vector<Name> groups = measurand_groups(result);
    if (groups.empty()) return groups;
    const Name first = groups.front();
    std::erase_if(groups, [&](const Name& group) { return !groups_alike(result, {first, group}); });
    return groups;
}

std::vector<Name> groups_in_full(const UncertaintyResult& result) {
    const std::vector<Name> all = measurand_groups(result);
    if (all.size() <= 2) return all;
    const std::vector<Name> groups = groups_like_the_first(result);
    std::map<std::string, double> sum_of_symbol;
    for (const std::string& group : groups)
        for (const std::size_t i : measurands_of(result, group))
            sum_of_symbol[result.outputs[i].quantity.symbol] += result.outputs[i].expanded_uncertainty;
    const auto weight = [&](const std::string& group) {
        double sum = 0.0;
        for (const std::size_t i : measurands_of(result, group)) {
            const double whole = sum_of_symbol[result.outputs[i].quantity.symbol];
            if (whole > 0.0) sum += result.outputs[i].expanded_uncertainty / whole;
        }
        return sum;
    };
    return {*std::max_element(groups.begin(), groups.end(),
                              [&](const auto& a, const auto& b) { return weight(a) < weight(b); })};
}

}  // namespace covaria::result_words
