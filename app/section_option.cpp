#include "app/section_option.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/base/unit.h"

namespace covaria {
namespace {

Error not_a_section(const std::string& text) {
    return {ErrorCode::usage, in_quotes(text) + " is no section: write x=0.25 (m), -y=250mm or z"};
}

/// A length in m; without a unit it is in metres.
std::optional<double> length_from(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
    if (read.ptr == end) return value;
    const auto unit = Unit::parse(CLI::detail::trim_copy(std::string(read.ptr, end)));
    if (!unit || unit->dimension() != Unit::of("m").dimension()) return std::nullopt;
    return unit->to_si(value);
}

}  // namespace

Result<WantedSection> section_from(const std::string& text) {
    const std::size_t equals = text.find('=');
    std::string axis = CLI::detail::trim_copy(text.substr(0, equals));
    WantedSection section;
    section.plane.hides_high = !axis.starts_with('-');
    if (!section.plane.hides_high) axis.erase(0, 1);
    const std::size_t place = std::string("xyz").find(axis);
    if (axis.size() != 1 || place == std::string::npos) return fail(not_a_section(text));
    section.plane.axis = static_cast<int>(place);
    section.in_middle = equals == std::string::npos;
    if (section.in_middle) return section;
    const auto at = length_from(CLI::detail::trim_copy(text.substr(equals + 1)));
    if (!at) return fail(not_a_section(text));
    section.plane.at = *at;
    return section;
}

void add_section_option(CLI::App& command, std::optional<WantedSection>& section) {
    command
        .add_option_function<std::string>(
            "--section",
            [&section](const std::string& text) {
                const auto wanted = section_from(text);
                if (!wanted) throw CLI::ValidationError("--section", wanted.error().message.english());
                section = *wanted;
            },
            "cut away what lies beyond a plane: x=0.25 (in m, or x=250mm), before it: -x=0.25; x alone: in "
            "the "
            "middle")
        ->type_name("AXIS[=LENGTH]");
}

}  // namespace covaria
