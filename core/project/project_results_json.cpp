#include "core/project/project_results_json.h"

#include <cmath>

#include "core/text/numbers.h"

namespace covaria {

namespace {

void read_units(ObjectReader& reader, DisplayUnits& units) {
    const Json* list = reader.list("units");
    for (std::size_t i = 0; list && i < list->size(); ++i) {
        const std::string path = reader.path_of("units") + "/" + std::to_string(i);
        const Json& item = (*list)[i];
        if (!item.is_string()) {
            reader.problems().error(path,
                                    tell<"a unit is needed here, such as \"mm\", not %1">(json_words(item)));
            continue;
        }
        const std::size_t before = reader.problems().items().size();
        const Unit unit = unit_from(item.get<std::string>(), path, reader.problems());
        if (reader.problems().items().size() > before) continue;
        if (unit.dimension().is_one())
            reader.problems().error(path,
                                    tell<"a unit with a dimension is needed here, not '%1'">(unit.text()));
        else if (has_unit(units, unit.dimension()))
            reader.problems().error(
                path,
                tell<"'%1' is of the same dimension as a unit before it; give one of each">(unit.text()));
        else
            units.choose(unit);
    }
}

}  // namespace

ProjectResults project_results_from_json(const Json& value, const std::string& path, Problems& problems) {
    ProjectResults results;
    ObjectReader reader(value, path, tell<"what the project states for results">(), problems);
    read_units(reader, results.style.units);
    if (const auto digits = reader.number("digits")) {
        if (*digits >= fewest_digits && *digits <= most_digits && *digits == std::floor(*digits))
            results.style.digits = static_cast<int>(*digits);
        else
            problems.error(reader.path_of("digits"),
                           tell<"'digits' must be a whole number from %1 to %2 (JCGM 100 7.2.6)">(
                               fewest_digits, most_digits));
    }
    if (const auto k = reader.number("coverageFactor")) {
        if (*k > 0.0)
            results.coverage_factor = *k;
        else
            problems.error(reader.path_of("coverageFactor"),
                           tell<"the coverage factor must be greater than zero; without one, k follows from "
                                "the degrees of freedom or the coverage interval">());
    }
    reader.refuse_unknown_keys();
    return results;
}

void write_project_results(JsonWriter& out, const ProjectResults& results) {
    out.begin_object();
    if (const auto& units = results.style.units.chosen(); !units.empty()) {
        out.key("units");
        out.begin_list(JsonWriter::Style::one_line);
        for (const Unit& unit : units) out.text(unit.text());
        out.end();
    }
    if (results.style.digits) {
        out.key("digits");
        out.integer(static_cast<std::uint64_t>(*results.style.digits));
    }
    if (results.coverage_factor) {
        out.key("coverageFactor");
        out.finite_number(*results.coverage_factor);
    }
    out.end();
}

}  // namespace covaria
