#include "core/project/options_json.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "core/project/option_fields.h"
#include "core/project/setup_json.h"
#include "core/setup/message_text.h"

namespace covaria {

std::optional<std::uint64_t> seed_from(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (status != std::errc{} || end != text.data() + text.size()) return {};
    return seed;
}

namespace {

// Reads one key into the member that it is declared for; a key that is absent leaves the default.
struct OptionReader {
    const Json& value;
    ObjectReader& reader;
    const OptionField& field;
    EvaluationOptions& options;

    void refuse(const Message& demand, const Message& given) {
        reader.problems().error(
            reader.path_of(field.key),
            tell<"'%1' must be %2; it is %3">(Message::declared(field.title), demand, given));
    }

    bool is_text() { return reader.has(field.key) && value.at(field.key).is_string(); }

    void operator()(const ChosenOption& member) {
        const std::string given = reader.text(field.key);
        if (!is_text()) return;
        std::vector<std::string> keys;
        for (const Choice& choice : field.choices) keys.push_back(choice.key);
        if (std::find(keys.begin(), keys.end(), given) != keys.end())
            member.set(options, given);
        else
            refuse(tell<"one of %1">(listed(keys)), "'" + given + "'" + did_you_mean(given, keys));
    }

    void operator()(const SeedOption& seed) {
        const std::string text = reader.text(field.key);
        if (!is_text()) return;
        if (const auto number = seed_from(text))
            options.*seed.member = *number;
        else
            refuse(seed_words(), "'" + text + "'");
    }

    std::optional<std::uint64_t> whole_number() {
        const auto number = reader.number(field.key);
        if (!number) return {};
        if (*number >= 0 && *number <= largest_whole_number &&
            *number == static_cast<double>(static_cast<std::uint64_t>(*number)))
            return static_cast<std::uint64_t>(*number);
        refuse(tell<"a whole number that is not negative">(), readable_number(*number));
        return {};
    }

    void operator()(std::uint64_t EvaluationOptions::*member) {
        const auto number = whole_number();
        if (number && static_cast<double>(*number) > field.range.high)
            refuse(tell<"no more than %1">(readable_number(field.range.high)),
                   readable_number(static_cast<double>(*number)));
        else if (number)
            options.*member = *number;
    }

    void operator()(int EvaluationOptions::*member) {
        if (const auto number = whole_number())
            options.*member = static_cast<int>(std::min<std::uint64_t>(*number, 100));
    }

    void operator()(double EvaluationOptions::*member) {
        if (const auto number = reader.number(field.key)) options.*member = *number;
    }

    void operator()(std::optional<double> EvaluationOptions::*member) {
        options.*member = reader.number(field.key);
    }

    /// Reads a quantity; a bare number is meant in the SI unit of every output.
    void operator()(std::optional<Quantity> EvaluationOptions::*member) {
        if (!reader.has(field.key)) return;
        if (value.at(field.key).is_object())
            options.*member = reader.quantity(field.key);
        else if (const auto number = reader.number(field.key))
            options.*member = Quantity{*number, Unit()};
    }

    void operator()(bool EvaluationOptions::*member) {
        if (const auto flag = reader.flag(field.key)) options.*member = *flag;
    }
};

// Writes a member that differs from its default.
struct OptionWriter {
    JsonWriter& out;
    const OptionField& field;
    const EvaluationOptions& options;
    const EvaluationOptions defaults = {};

    template <class T>
    bool begins(T EvaluationOptions::*member) {
        const bool changed = !(options.*member == defaults.*member);
        if (changed) out.key(field.key);
        return changed;
    }

    void operator()(const ChosenOption& member) {
        if (member.get(options) == member.get(defaults)) return;
        out.key(field.key);
        out.text(member.get(options));
    }
    void operator()(const SeedOption& seed) {
        if (begins(seed.member)) out.text(std::to_string(options.*seed.member));
    }
    void operator()(std::uint64_t EvaluationOptions::*member) {
        if (begins(member)) out.integer(options.*member);
    }
    void operator()(int EvaluationOptions::*member) {
        if (begins(member)) out.integer(static_cast<std::uint64_t>(options.*member));
    }
    void operator()(double EvaluationOptions::*member) {
        if (begins(member)) out.finite_number(options.*member);
    }
    void operator()(std::optional<double> EvaluationOptions::*member) {
        if (begins(member)) out.finite_number((options.*member).value());
    }
    void operator()(std::optional<Quantity> EvaluationOptions::*member) {
        if (!begins(member)) return;
        const Quantity& quantity = (options.*member).value();
        if (quantity.unit == Unit())
            out.finite_number(quantity.value);
        else
            write_quantity(out, quantity);
    }
    void operator()(bool EvaluationOptions::*member) {
        if (begins(member)) out.boolean(options.*member);
    }
};

}  // namespace

EvaluationOptions options_from_json(const Json& value, const std::string& path, Problems& problems) {
    EvaluationOptions options;
    ObjectReader reader(value, path, "'options'", problems);
    for (const OptionField& field : option_fields())
        std::visit(OptionReader{value, reader, field, options}, field.member);
    reader.refuse_unknown_keys();
    return options;
}

void write_options(JsonWriter& out, const EvaluationOptions& options) {
    out.begin_object();
    for (const OptionField& field : option_fields())
        std::visit(OptionWriter{out, field, options}, field.member);
    out.end();
}

}  // namespace covaria
