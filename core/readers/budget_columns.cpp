#include "core/readers/budget_columns.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// Whole headers that mean something, capital letters told apart.
constexpr std::array<std::pair<std::string_view, BudgetColumn>, 29> whole_heads{
    {{"U", BudgetColumn::expanded},
     {"u", BudgetColumn::standard},
     {"k", BudgetColumn::divisor},
     {"c", BudgetColumn::c},
     {"ci", BudgetColumn::c},
     {"c_i", BudgetColumn::c},
     {"cᵢ", BudgetColumn::c},
     {"nu", BudgetColumn::nu},
     {"nu_i", BudgetColumn::nu},
     {"ν", BudgetColumn::nu},
     {"νi", BudgetColumn::nu},
     {"ν_i", BudgetColumn::nu},
     {"νᵢ", BudgetColumn::nu},
     {"vi", BudgetColumn::nu},
     {"dof", BudgetColumn::nu},
     {"DoF", BudgetColumn::nu},
     {"df", BudgetColumn::nu},
     {"x_i", BudgetColumn::value},
     {"xi", BudgetColumn::value},
     {"xᵢ", BudgetColumn::value},
     {"X_i", BudgetColumn::quantity},
     {"Xi", BudgetColumn::quantity},
     {"u(x_i)", BudgetColumn::standard},
     {"u(xi)", BudgetColumn::standard},
     {"u_i", BudgetColumn::standard},
     {"u_i(y)", BudgetColumn::contribution},
     {"ui(y)", BudgetColumn::contribution},
     {"a", BudgetColumn::limits},
     {"±", BudgetColumn::limits}}};

/// Words within headers, the first that is found decides.
constexpr std::array<std::pair<std::string_view, BudgetColumn>, 38> words_in_heads{
    {{"contribution", BudgetColumn::contribution},
     {"beitrag", BudgetColumn::contribution},
     {"sensitivity", BudgetColumn::c},
     {"empfindlichkeit", BudgetColumn::c},
     {"degrees of freedom", BudgetColumn::nu},
     {"freiheitsgrad", BudgetColumn::nu},
     {"distribution", BudgetColumn::distribution},
     {"verteilung", BudgetColumn::distribution},
     {"divisor", BudgetColumn::divisor},
     {"teiler", BudgetColumn::divisor},
     {"coverage factor", BudgetColumn::divisor},
     {"k factor", BudgetColumn::divisor},
     {"k-factor", BudgetColumn::divisor},
     {"erweiterungsfaktor", BudgetColumn::divisor},
     {"standard uncertainty", BudgetColumn::standard},
     {"std. uncertainty", BudgetColumn::standard},
     {"std uncertainty", BudgetColumn::standard},
     {"standardunsicherheit", BudgetColumn::standard},
     {"standardmessunsicherheit", BudgetColumn::standard},
     {"expanded", BudgetColumn::expanded},
     {"erweiterte", BudgetColumn::expanded},
     {"half-width", BudgetColumn::limits},
     {"half width", BudgetColumn::limits},
     {"halbbreite", BudgetColumn::limits},
     {"limit", BudgetColumn::limits},
     {"grenze", BudgetColumn::limits},
     {"±", BudgetColumn::limits},
     {"+/-", BudgetColumn::limits},
     {"estimate", BudgetColumn::value},
     {"schätzwert", BudgetColumn::value},
     {"value", BudgetColumn::value},
     {"wert", BudgetColumn::value},
     {"unit", BudgetColumn::unit},
     {"einheit", BudgetColumn::unit},
     {"symbol", BudgetColumn::quantity},
     {"quantity", BudgetColumn::quantity},
     {"größe", BudgetColumn::quantity},
     {"remark", BudgetColumn::source}}};

constexpr std::array<std::pair<std::string_view, BudgetColumn>, 6> names_in_heads{
    {{"source of uncertainty", BudgetColumn::name},
     {"description", BudgetColumn::name},
     {"component", BudgetColumn::name},
     {"name", BudgetColumn::name},
     {"bezeichnung", BudgetColumn::name},
     {"source", BudgetColumn::source}}};

std::string lower_case(const std::string& text) {
    std::string lower = text;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

/// "u(x_i) [mm]", "Value (mm)", "Value / mm", "c / (nm/K)": the unit behind, where it is one.
BudgetHead with_unit_behind(const std::string& header) {
    BudgetHead head{.word = plain_name(header)};
    std::string& word = head.word;
    const auto cut = [&](std::size_t begin, std::size_t length, std::size_t keep) {
        const auto unit = Unit::parse(plain_name(word.substr(begin, length)));
        if (!unit) return false;
        head.unit = *unit;
        word = plain_name(word.substr(0, keep));
        return true;
    };
    if (const std::size_t at = word.rfind(" / "); at != std::string::npos && at > 0)
        if (cut(at + 3, std::string::npos, at)) return head;
    for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')})
        if (word.size() > 2 && word.back() == close)
            if (const std::size_t at = word.rfind(open);
                at != std::string::npos && at > 0 && (open == '[' || word[at - 1] == ' '))
                if (cut(at + 1, word.size() - at - 2, at)) return head;
    return head;
}

}  // namespace

const std::vector<BudgetColumnWord>& budget_column_words() {
    static const std::vector<BudgetColumnWord> words{
        {BudgetColumn::quantity, "quantity", "symbol of the quantity"},
        {BudgetColumn::name, "name", "what it is"},
        {BudgetColumn::value, "value", "estimate"},
        {BudgetColumn::unit, "unit", "unit of estimate and uncertainty"},
        {BudgetColumn::standard, "u", "standard uncertainty"},
        {BudgetColumn::expanded, "U", "uncertainty before the divisor"},
        {BudgetColumn::limits, "limits", "half-width of the limits"},
        {BudgetColumn::divisor, "divisor", "divisor, coverage factor k"},
        {BudgetColumn::distribution, "distribution", "distribution"},
        {BudgetColumn::nu, "nu", "degrees of freedom"},
        {BudgetColumn::c, "c", "sensitivity coefficient"},
        {BudgetColumn::contribution, "contribution", "contribution to u(y)"},
        {BudgetColumn::source, "source", "where the figure comes from"},
        {BudgetColumn::unread, "-", "not read"}};
    return words;
}

BudgetHead budget_head_of(const std::string& header) {
    BudgetHead head = with_unit_behind(header);
    for (const auto& [word, column] : whole_heads)
        if (head.word == word) {
            head.column = column;
            return head;
        }
    const std::string lower = lower_case(head.word);
    for (const auto& [word, column] : names_in_heads)
        if (lower.find(word) != std::string::npos) {
            head.column = column;
            return head;
        }
    for (const auto& [word, column] : words_in_heads)
        if (lower.find(word) != std::string::npos) {
            head.column = column;
            return head;
        }
    if (lower.find("uncertainty") != std::string::npos || lower.find("unsicherheit") != std::string::npos)
        head.column = BudgetColumn::expanded;
    return head;
}

bool are_budget_heads(const std::vector<BudgetHead>& heads) {
    const auto has = [&](BudgetColumn column) {
        return std::any_of(heads.begin(), heads.end(),
                           [&](const BudgetHead& head) { return head.column == column; });
    };
    const auto known = std::count_if(heads.begin(), heads.end(), [](const BudgetHead& head) {
        return head.column != BudgetColumn::unread;
    });
    return known >= 3 && (has(BudgetColumn::quantity) || has(BudgetColumn::name)) &&
           (has(BudgetColumn::standard) || has(BudgetColumn::expanded) || has(BudgetColumn::limits));
}

Result<std::vector<BudgetHead>> stated_budget_columns(const std::vector<std::string>& words) {
    std::vector<BudgetHead> heads;
    std::vector<std::string> keys;
    for (const BudgetColumnWord& word : budget_column_words()) keys.emplace_back(word.key);
    for (const std::string& typed : words) {
        BudgetHead head = with_unit_behind(typed);
        const auto found = std::find(keys.begin(), keys.end(), head.word);
        if (found == keys.end())
            return fail(ErrorCode::usage, tell<"a column cannot be %1; there are %2">(
                                              in_quotes(plain_name(typed)), listed(keys)));
        head.column = budget_column_words()[static_cast<std::size_t>(found - keys.begin())].column;
        heads.push_back(std::move(head));
    }
    return heads;
}

Result<void> check_budget_columns(const std::vector<BudgetHead>& heads) {
    for (std::size_t i = 0; i < heads.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (heads[i].column == heads[j].column && heads[i].column != BudgetColumn::unread)
                return fail(ErrorCode::usage, tell<"the columns %1 and %2 mean the same; state the columns">(
                                                  in_quotes(heads[j].word), in_quotes(heads[i].word)));
    if (!are_budget_heads(heads))
        return fail(ErrorCode::usage, tell<"a budget needs columns for the quantity or its name, for an "
                                           "uncertainty (u, U or limits) and one more; state the columns">());
    return {};
}

}  // namespace covaria
