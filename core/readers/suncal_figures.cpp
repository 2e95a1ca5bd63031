#include "core/readers/suncal_figures.h"

#include <cctype>
#include <charconv>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/math/normal_quantile.h"
#include "core/readers/entry_texts.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr std::size_t longest_figure = 200;

/// Reader of sums of products of numbers. Parentheses are few, because the text is short.
class FigureText {
public:
    FigureText(std::string_view text, double mean) : rest_(text), mean_(std::abs(mean)) {}

    std::optional<double> read() {
        const auto value = sum();
        if (!value || !rest_.empty() || !std::isfinite(*value)) return std::nullopt;
        return value;
    }

private:
    bool take(std::string_view word) {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        return true;
    }

    std::optional<double> sum() {
        const bool minus = take("-");
        auto value = product();
        if (value && minus) *value = -*value;
        while (value) {
            const bool add = take("+");
            if (!add && !take("-")) break;
            const auto next = product();
            value = next ? std::optional(*value + (add ? *next : -*next)) : std::nullopt;
        }
        return value;
    }

    std::optional<double> product() {
        auto value = factor();
        while (value) {
            if (rest_.starts_with("**")) return std::nullopt;
            const bool times = take("*");
            if (!times && !take("/")) break;
            const auto next = factor();
            value = next ? std::optional(times ? *value * *next : *value / *next) : std::nullopt;
        }
        return value;
    }

    std::optional<double> factor() {
        if (take("(")) return closed();
        double number = 0.0;
        const auto [end, status] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        if (status != std::errc{}) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        for (const auto& [word, share] :
             {std::pair("%", 1e2), std::pair("ppm", 1e6), std::pair("ppb", 1e9)}) {
            if (!take(word)) continue;
            if (!take("range(")) return number / share * mean_;
            const auto range = closed();
            return range ? std::optional(number / share * *range) : std::nullopt;
        }
        take("");
        return number;
    }

    std::optional<double> closed() {
        if (++depth_ > 10) return std::nullopt;
        const auto value = sum();
        return value && take(")") ? value : std::nullopt;
    }

    std::string_view rest_;
    double mean_;
    int depth_ = 0;
};

bool is_limits(const std::string& distribution, const std::map<std::string, double>& figures,
               NotedComponent& c, std::string& complaint) {
    static const std::map<std::string, const char*> limits{
        {"uniform", "rectangular"},        {"rectangular", "rectangular"},
        {"triangular", "triangular"},      {"arcsine", "arcsine"},
        {"resolution", "resolution"},      {"curvtrap", "curvilinear-trapezoid"},
        {"ctrap", "curvilinear-trapezoid"}};
    const auto kind = limits.find(distribution);
    if (kind == limits.end()) return false;
    if (!figures.contains("a")) {
        complaint = "a is missing";
        return true;
    }
    c.statement = kind->second;
    c.a = figures.at("a");
    if (!distribution.ends_with("trap")) return true;
    if (figures.contains("d"))
        c.b = figures.at("d");
    else
        complaint = "d is missing";
    return true;
}

}  // namespace

std::optional<double> suncal_figure(const std::string& text, double mean) {
    if (text.size() > longest_figure) return std::nullopt;
    return FigureText(text, mean).read();
}

std::string state_suncal(const std::string& distribution, const std::map<std::string, double>& figures,
                         NotedComponent& c, std::string& how) {
    const auto has = [&](const char* key) { return figures.contains(key); };
    std::string complaint;
    if (is_limits(distribution, figures, c, complaint)) return complaint;
    c.statement = "standard";
    if (distribution == "poisson") {
        if (!has("v") || !(figures.at("v") >= 0.0)) return "v is missing, the mean of the counts";
        c.a = std::sqrt(figures.at("v"));
        how = "Poisson distribution: the standard uncertainty √v is taken, the shape as normal";
        return {};
    }
    const bool normal = distribution == "normal" || distribution == "norm" || distribution == "gaussian";
    if (!normal && distribution != "t" && !distribution.empty())
        return "the distribution " + in_quotes(plain_name(distribution)) + " is not taken over";
    if (!has("unc") && !has("std")) return "neither unc nor std is stated";
    c.a = figures.at(has("unc") ? "unc" : "std");
    if (!has("unc")) return {};
    if (has("conf")) {
        const double p = figures.at("conf");
        if (!(p > 0.0 && p < 1.0)) return "conf must lie between 0 and 1";
        if (distribution == "t" || !c.degrees_of_freedom) {
            c.statement = "certificate-p";
            c.b = 100.0 * p;
        } else {  // Suncal's normal distribution takes the factor of infinite degrees of freedom
            c.statement = "certificate-k";
            c.b = normal_quantile(0.5 * (1.0 + p));
        }
    } else if (has("k") && figures.at("k") != 1.0) {
        c.statement = "certificate-k";
        c.b = figures.at("k");
    }
    return {};
}

}  // namespace covaria
