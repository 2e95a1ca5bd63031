// The section of a picture as people type it on the command line: x=0.25, -y=250mm, z.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "viz/scene/section_plane.h"

namespace CLI {
class App;
}

namespace covaria {

struct WantedSection {
    SectionPlane plane;
    bool in_middle = false;  ///< wherever that is: its position was not stated
};

/// "x=0.25": what lies beyond x = 0.25 m is cut away; "-x=0.25": what lies before it; "x=250mm", "x = 10 in"
/// state the unit; "x" alone goes through the middle.
Result<WantedSection> section_from(const std::string& text);
/// Adds --section. `section` must outlive the parser.
void add_section_option(CLI::App& command, std::optional<WantedSection>& section);

}  // namespace covaria
