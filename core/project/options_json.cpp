#include "core/project/options_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "core/project/setup_json.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

struct MethodName {
    Method method;
    const char* key;
};
constexpr std::array<MethodName, 3> methods{{{Method::first_order, "first-order"},
                                             {Method::monte_carlo, "monte-carlo"},
                                             {Method::adaptive, "adaptive"}}};

constexpr std::array<VarianceReduction, 3> variance_reductions{
    VarianceReduction::none, VarianceReduction::control_variate, VarianceReduction::sobol};

constexpr double largest_whole_number = 9007199254740992.0;  // 2^53: beyond, doubles skip whole numbers

// Reads into members of EvaluationOptions; a key that is absent leaves the default.
class OptionsReader {
public:
    OptionsReader(const Json& value, const std::string& path, Problems& problems)
        : value_(value), reader_(value, path, "'options'", problems), problems_(problems) {}

    EvaluationOptions read() {
        EvaluationOptions options;
        method(options.method);
        count("trials", options.trials);
        seed(options.seed);
        variance_reduction(options.variance_reduction);
        if (auto number = reader_.number("coverageProbability")) options.coverage_probability = *number;
        options.coverage_factor = reader_.number("coverageFactor");
        if (auto flag = reader_.flag("secondOrder")) options.second_order = *flag;
        count("oneAtATimeTrials", options.one_at_a_time_trials);
        count("contributorTrials", options.contributor_trials);
        count("sobolTrials", options.sobol_trials);
        std::uint64_t digits = static_cast<std::uint64_t>(options.significant_digits);
        count("significantDigits", digits);
        options.significant_digits = static_cast<int>(std::min<std::uint64_t>(digits, 100));
        tolerance(options.tolerance);
        count("minimumBatches", options.minimum_batches);
        count("maximumTrials", options.maximum_trials);
        reader_.refuse_unknown_keys();
        return options;
    }

private:
    void method(Method& out) {
        std::vector<std::string> keys;
        for (const MethodName& name : methods) keys.push_back(name.key);
        if (const auto chosen = choice("method", keys)) out = methods[*chosen].method;
    }

    void variance_reduction(VarianceReduction& out) {
        std::vector<std::string> keys;
        for (const VarianceReduction reduction : variance_reductions) keys.emplace_back(key_of(reduction));
        if (const auto chosen = choice("varianceReduction", keys)) out = variance_reductions[*chosen];
    }

    /// Which of these texts it is.
    std::optional<std::size_t> choice(const std::string& name, const std::vector<std::string>& keys) {
        const std::string key = reader_.text(name);
        if (!reader_.has(name) || !value_.at(name).is_string()) return {};
        const auto found = std::find(keys.begin(), keys.end(), key);
        if (found != keys.end()) return static_cast<std::size_t>(found - keys.begin());
        problems_.error(reader_.path_of(name), "'" + name + "' must be one of " + listed(keys) + "; it is '" +
                                                   key + "'" + did_you_mean(key, keys));
        return {};
    }

    /// A quantity; a bare number is meant in the SI unit of every output.
    void tolerance(std::optional<Quantity>& out) {
        if (!reader_.has("tolerance")) return;
        if (value_.at("tolerance").is_object())
            out = reader_.quantity("tolerance");
        else if (const auto number = reader_.number("tolerance"))
            out = Quantity{*number, Unit()};
    }

    void count(const std::string& key, std::uint64_t& out) {
        const auto number = reader_.number(key);
        if (!number) return;
        if (*number >= 0 && *number <= largest_whole_number &&
            *number == static_cast<double>(static_cast<std::uint64_t>(*number)))
            out = static_cast<std::uint64_t>(*number);
        else
            problems_.error(reader_.path_of(key),
                            "'" + key + "' must be a whole number that is not negative; it is " +
                                readable_number(*number));
    }

    void seed(std::uint64_t& out) {
        const std::string text = reader_.text("seed");
        if (!reader_.has("seed") || !value_.at("seed").is_string()) return;
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), out);
        if (status != std::errc{} || end != text.data() + text.size())
            problems_.error(reader_.path_of("seed"),
                            "'seed' must be a whole number from 0 to 18446744073709551615, in "
                            "quotes; it is '" +
                                text + "'");
    }

    const Json& value_;
    ObjectReader reader_;
    Problems& problems_;
};

// Calls `write` for a member that differs from its default.
template <class T, class Write>
void write_changed(JsonWriter& out, const char* key, const T& value, const T& default_value, Write write) {
    if (value == default_value) return;
    out.key(key);
    write(value);
}

const char* method_key(Method method) {
    for (const MethodName& name : methods)
        if (name.method == method) return name.key;
    return "";
}

}  // namespace

EvaluationOptions options_from_json(const Json& value, const std::string& path, Problems& problems) {
    return OptionsReader(value, path, problems).read();
}

void write_options(JsonWriter& out, const EvaluationOptions& options) {
    const EvaluationOptions defaults;
    const auto count = [&](std::uint64_t value) { out.integer(value); };
    const auto number = [&](double value) { out.finite_number(value); };
    const auto maybe = [&](const std::optional<double>& value) {
        if (value)
            out.finite_number(*value);
        else
            out.null();
    };
    out.begin_object();
    write_changed(out, "method", options.method, defaults.method,
                  [&](Method method) { out.text(method_key(method)); });
    write_changed(out, "trials", options.trials, defaults.trials, count);
    write_changed(out, "seed", options.seed, defaults.seed,
                  [&](std::uint64_t seed) { out.text(std::to_string(seed)); });
    write_changed(out, "varianceReduction", options.variance_reduction, defaults.variance_reduction,
                  [&](VarianceReduction reduction) { out.text(std::string(key_of(reduction))); });
    write_changed(out, "coverageProbability", options.coverage_probability, defaults.coverage_probability,
                  number);
    write_changed(out, "coverageFactor", options.coverage_factor, defaults.coverage_factor, maybe);
    write_changed(out, "secondOrder", options.second_order, defaults.second_order,
                  [&](bool value) { out.boolean(value); });
    write_changed(out, "oneAtATimeTrials", options.one_at_a_time_trials, defaults.one_at_a_time_trials,
                  count);
    write_changed(out, "contributorTrials", options.contributor_trials, defaults.contributor_trials, count);
    write_changed(out, "sobolTrials", options.sobol_trials, defaults.sobol_trials, count);
    write_changed(out, "significantDigits", options.significant_digits, defaults.significant_digits,
                  [&](int value) { out.integer(static_cast<std::uint64_t>(value)); });
    write_changed(out, "tolerance", options.tolerance, defaults.tolerance,
                  [&](const std::optional<Quantity>& tolerance) {
                      if (tolerance->unit == Unit())
                          out.finite_number(tolerance->value);
                      else
                          write_quantity(out, *tolerance);
                  });
    write_changed(out, "minimumBatches", options.minimum_batches, defaults.minimum_batches, count);
    write_changed(out, "maximumTrials", options.maximum_trials, defaults.maximum_trials, count);
    out.end();
}

}  // namespace covaria
