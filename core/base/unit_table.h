// The units Covaria knows, with their exact factors to SI. A new unit is one line in unit_table.cpp.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/unit.h"

namespace covaria::detail {

/// SI prefixes that a unit takes (SI brochure, 9th edition, 3 and 4).
enum class Prefixes { none, all, large };

struct UnitEntry {
    std::string_view name;     ///< name in files: "ohm"
    std::string_view display;  ///< name for people: "Ω"
    double numerator;          ///< one unit = numerator/denominator in SI
    double denominator;
    Dimension dimension;
    Prefixes prefixes = Prefixes::none;
    std::array<std::string_view, 3> words = {};  ///< words of people for it; the first two may be spellings
    double offset = 0.0;                         ///< SI value of zero on the scale (degC, degF)
    /// A name for one kind of quantity only (Bq, Gy): never chosen as the name of a dimension.
    bool one_kind_only = false;
};

/// A unit with its prefix: "km".
struct KnownUnit {
    std::string name;
    std::string display;
    double numerator = 1.0;
    double denominator = 1.0;
    Dimension dimension = {};
    double offset = 0.0;
};

std::span<const UnitEntry> unit_table();
/// All units of the table, each with every prefix that it takes.
std::vector<KnownUnit> all_units();

/// The unit with this name, prefix included; a further name ("l", "mil", "inch") is read as its unit.
std::optional<KnownUnit> find_unit(std::string_view name);

/// The names most like an unknown one, as a sentence for the user: ' Did you mean "mm" or "um"?'; lists all
/// units when none is alike.
Message unit_suggestion(std::string_view unknown);

}  // namespace covaria::detail
