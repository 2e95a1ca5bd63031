#include "core/readers/budget_columns.h"

#include <algorithm>
#include <cctype>

#include "core/base/in_quotes.h"
#include "core/readers/budget_words.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// Whether a text is a symbol that may stand in parentheses: the a of "half-width (a)" is no year.
bool is_symbol(const std::string& text) {
    return std::ranges::any_of(budget_symbols(),
                               [&](const BudgetSymbol& known) { return text == known.symbol; }) &&
           text != "%";
}

/// The head without the unit behind it, where there is one: "u(x_i) [mm]", "Value (mm)", "Value / mm", "c /
/// (nm/K)".
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
                at != std::string::npos && at > 0 && (open == '[' || word[at - 1] == ' ') &&
                !is_symbol(word.substr(at + 1, word.size() - at - 2)))
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

std::optional<double> coverage_factor_in(std::string& word) {
    for (std::size_t at = word.find('k'); at != std::string::npos; at = word.find('k', at + 1)) {
        if (at > 0 && std::isalnum(static_cast<unsigned char>(word[at - 1]))) continue;
        std::size_t begin = word.find_first_not_of(' ', at + 1);
        if (begin == std::string::npos || word[begin] != '=') continue;
        begin = std::min(word.find_first_not_of(' ', begin + 1), word.size());
        const std::size_t end = std::min(word.find_first_not_of("0123456789.,", begin), word.size());
        std::string digits = word.substr(begin, end - begin);
        std::replace(digits.begin(), digits.end(), ',', '.');
        const auto k = number_in_text(digits);
        if (!k || !(*k > 0.0)) continue;
        word = plain_name(word.substr(0, at) + word.substr(end));
        for (const char* empty : {"()", "[]", "( )", "(, )"})
            if (const std::size_t left = word.find(empty); left != std::string::npos)
                word = plain_name(word.replace(left, std::string(empty).size(), " "));
        if (!word.empty() && word.back() == ',') word.pop_back();
        return k;
    }
    return std::nullopt;
}

BudgetHead budget_head_of(const std::string& header) {
    std::string bare = plain_name(header);
    const std::optional<double> k = coverage_factor_in(bare);
    BudgetHead head = with_unit_behind(bare);
    const auto meaning = meaning_of_head(head.word);
    head.word = k ? plain_name(header) : head.word;
    const bool is_share =
        meaning && meaning->column == BudgetColumn::contribution && head.unit && head.unit->text() == "%";
    head.understood = meaning && (!k || meaning->column == BudgetColumn::expanded);
    if (!head.understood || is_share) return head;
    head.column = meaning->column;
    head.weak = meaning->weak;
    head.k = k;
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
        if (head.word.empty() || head.word == as_headed) {
            heads.push_back({.word = as_headed});
            continue;
        }
        const auto found = std::find(keys.begin(), keys.end(), head.word);
        if (found == keys.end())
            return fail(ErrorCode::usage, tell<"a column cannot be %1; there are %2">(
                                              in_quotes(plain_name(typed)), listed(keys)));
        head.column = budget_column_words()[static_cast<std::size_t>(found - keys.begin())].column;
        head.understood = true;
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
