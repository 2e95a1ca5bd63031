#include "app/section_option.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/base/unit.h"
#include "ui/document/quantity_text.h"
#include "ui/theme/strings.h"

namespace covaria {
namespace {

Error not_a_section(const std::string& text) {
    return {ErrorCode::usage, in_quotes(text) + " is no section: write x=0.25 (m), -y=250mm or z"};
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
    const auto at = ui::parse_quantity(ui::to_qt(text.substr(equals + 1)), Unit::of("m"), QLocale::c());
    if (!at || !*at || !std::isfinite((*at)->si())) return fail(not_a_section(text));
    section.plane.at = (*at)->si();
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
            "the middle")
        ->type_name("AXIS[=LENGTH]");
}

}  // namespace covaria
