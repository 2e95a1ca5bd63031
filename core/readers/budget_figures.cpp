#include "core/readers/budget_figures.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/readers/budget_words.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

struct Shape {
    const char* statement;
    double divisor;  ///< ratio of half-width to standard uncertainty; 0: normal
};

/// The shape of a distribution by the beginning of what people call it, in small letters.
std::optional<Shape> shape_of(const std::string& words) {
    std::string lower;
    for (const char c : words) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto begins = [&](const char* word) { return lower.starts_with(word); };
    if (begins("rect") || begins("retang") || begins("rettang") || begins("uniform") || begins("gleich") ||
        begins("rechteck"))
        return Shape{"rectangular", std::sqrt(3.0)};
    if (begins("triang") || begins("dreieck")) return Shape{"triangular", std::sqrt(6.0)};
    if (begins("u-") || begins("u shaped") || begins("arcsin") || begins("arc sin") || lower == "u")
        return Shape{"arcsine", std::sqrt(2.0)};
    if (lower == "forme de u" || lower == "forma de u" || lower == "en u" || lower == "em u" ||
        lower == "a u" || begins("arcosen") || begins("arcosin"))
        return Shape{"arcsine", std::sqrt(2.0)};
    if (begins("normal") || begins("gauss") || begins("student") || begins("t-") || begins("t ") ||
        begins("type a") || lower == "t" || lower == "n")
        return Shape{"standard", 0.0};
    return std::nullopt;
}

bool is_near(double a, double b) {
    return std::abs(a - b) <= 0.005 * std::abs(b);
}

}  // namespace

bool is_sum_label(const std::string& label) {
    const std::vector<std::string> words = folded_words(label);
    const auto begins_with = [&](const char* known, std::size_t within) {
        const std::vector<std::string> all = folded_words(known);
        return std::any_of(
            words.begin(), words.begin() + static_cast<std::ptrdiff_t>(std::min(within, words.size())),
            [&](const std::string& word) { return std::find(all.begin(), all.end(), word) != all.end(); });
    };
    if (begins_with("sum total summe somme suma somma soma gesamt totale", 1))
        return words.size() == 1 || words[1] == "of" || words[1] == "der";
    const bool uncertainty = begins_with(
        "uncertainty unsicherheit messunsicherheit standardunsicherheit standardmessunsicherheit "
        "incertitude incertidumbre incertezza incerteza",
        words.size());
    if (begins_with("combined kombinierte kombiniert expanded erweiterte erweitert composée combinée élargie "
                    "combinada expandida composta estesa",
                    3))
        return uncertainty || words.size() <= 2;
    const auto meaning = meaning_of_head(label);
    return meaning && meaning->column == BudgetColumn::nu && words.size() > 1;
}

std::optional<double> divisor_in_text(const std::string& text) {
    if (const auto number = number_in_text(text)) return number;
    for (const std::string sign : {"√", "sqrt"}) {
        if (!text.starts_with(sign)) continue;
        std::string rest = text.substr(sign.size());
        if (rest.size() > 2 && rest.front() == '(' && rest.back() == ')')
            rest = rest.substr(1, rest.size() - 2);
        const auto number = number_in_text(rest);
        if (number && *number > 0.0) return std::sqrt(*number);
    }
    return std::nullopt;
}

double standard_uncertainty_of(const NotedComponent& component) {
    const double a = component.unit.interval_to_si(component.a.value_or(0.0));
    if (component.statement == "certificate-k") return a / component.b.value_or(1.0);
    for (const char* words : {"rectangular", "triangular", "arcsine"})
        if (component.statement == words) return a / shape_of(words)->divisor;
    return a;
}

Result<NotedComponent> stated_component_of(const BudgetFigures& figures, std::string& how) {
    const auto refused = [](const Message& message) { return fail(ErrorCode::bad_input, message); };
    std::optional<Shape> shape;
    if (!figures.distribution.empty()) {
        shape = shape_of(figures.distribution);
        if (!shape && figures.standard)
            how = "the distribution " + in_quotes(plain_name(figures.distribution)) +
                  " with a standard uncertainty: taken as normal";
        if (!shape && !figures.standard)
            return refused(
                tell<"the distribution %1 is not known; there are normal, rectangular, triangular, U-shaped">(
                    in_quotes(plain_name(figures.distribution))));
    }
    if (figures.divisor && !(*figures.divisor > 0.0))
        return refused(tell<"the divisor must be greater than 0">());
    NotedComponent c{.degrees_of_freedom = figures.nu};
    const std::optional<double> figure = figures.limits ? figures.limits : figures.expanded;
    for (const auto& value : {figure, figures.standard})
        if (value && !(*value >= 0.0)) return refused(tell<"an uncertainty must not be negative">());
    if (!figure && !figures.standard) return refused(tell<"no uncertainty is stated">());
    if (figure && !figures.divisor && !figures.standard && !shape && !figures.limits)
        return refused(tell<"neither divisor, k nor distribution says what the uncertainty %1 is">(
            shortest_number(*figure)));
    if (!shape && figures.divisor && is_near(*figures.divisor, std::sqrt(3.0))) {
        shape = Shape{"rectangular", std::sqrt(3.0)};
        how = "divisor √3 without a distribution: taken as rectangular";
    }
    if (!shape && figures.limits && !figures.divisor && !figures.standard) {
        shape = Shape{"rectangular", std::sqrt(3.0)};
        how = "limits without a distribution: taken as rectangular";
    }
    if (!shape) shape = Shape{"standard", 0.0};
    c.statement = shape->statement;
    if (figure && shape->divisor > 0.0 && (!figures.divisor || is_near(*figures.divisor, shape->divisor))) {
        c.a = *figure;
        return c;
    }
    if (figure && figures.divisor && shape->divisor == 0.0) {
        c.statement = "certificate-k";
        c.a = *figure;
        c.b = *figures.divisor;
        return c;
    }
    if (figure && !figures.divisor && !figures.standard)
        return refused(tell<"a normal distribution needs a divisor or k for the uncertainty %1">(
            shortest_number(*figure)));
    const double u = figures.standard ? *figures.standard : *figure / *figures.divisor;
    c.a = shape->divisor > 0.0 ? u * shape->divisor : u;
    if (!figures.standard && shape->divisor > 0.0)
        how = "divisor " + shortest_number(*figures.divisor) + " for a " + std::string(shape->statement) +
              " distribution: the half-width is taken as " + shortest_number(*c.a);
    return c;
}

}  // namespace covaria
