// Plain lists of coordinates: a line with the number of points, then x y z of each. NIST's test data of
// least-squares features are such files (lin12.ds, cyl24.ds).
#include <charconv>
#include <cmath>

#include "core/base/text_places.h"
#include "core/readers/delimited_text.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/listed_points.h"

namespace covaria {

namespace {

constexpr const char* geometry_model = "geometry-from-points";

std::optional<std::size_t> announced_points(const std::vector<std::string>& cells) {
    std::size_t count = 0;
    if (cells.size() != 1) return {};
    const std::string& text = cells.front();
    const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || count == 0) return {};
    return count;
}

/// The next line with content, cut at tabs, commas, semicolons or blanks; moves `at` behind it.
std::vector<std::string> next_cells(std::string_view text, std::size_t& at, int& line) {
    while (at < text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string one(text.substr(at, end - at));
        at = end + 1;
        ++line;
        for (char& c : one)
            if (c == '\t' || c == ',' || c == ';' || c == '\r') c = ' ';
        std::vector<std::string> cells = blank_separated(one);
        if (!cells.empty()) return cells;
    }
    return {};
}

bool ends_with_ds(const std::string& file_name) {
    return file_name.size() > 3 && (file_name.ends_with(".ds") || file_name.ends_with(".DS"));
}

Recognition recognise_coordinates(std::string_view beginning, const std::string& file_name) {
    std::size_t at = 0;
    int line = 0;
    if (!announced_points(next_cells(beginning, at, line))) return Recognition::no;
    const std::vector<std::string> first = next_cells(beginning, at, line);
    if (first.size() != 3) return Recognition::no;
    for (const std::string& cell : first)
        if (!csv_number(cell, false)) return Recognition::no;
    return ends_with_ds(file_name) ? Recognition::certain : Recognition::possible;
}

struct FormInName {
    const char* beginning;
    const char* form;
};

/// The form that a file of NIST names; names of other files say nothing.
std::string form_of(const std::string& name, std::size_t points, Proposals& proposals) {
    static constexpr FormInName forms[] = {{"lin", "line"},   {"pla", "plane"},    {"cir", "circle"},
                                           {"sph", "sphere"}, {"cyl", "cylinder"}, {"con", "cone"}};
    for (const FormInName& known : forms) {
        const std::string beginning = known.beginning;
        if (!name.starts_with(beginning) || name.size() == beginning.size() ||
            name.find_first_not_of("0123456789", beginning.size()) != std::string::npos)
            continue;
        proposals.found.push_back(tell<"the name of the file says that it is a %1">(known.form));
        return known.form;
    }
    const std::string form = points >= 3 ? "plane" : points == 2 ? "line" : "point";
    proposals.found.push_back(tell<"the file does not say which form its points have: a %1 is fitted; choose "
                                   "another one in the table "
                                   "of features">(form));
    return form;
}

Result<Proposals> read_coordinates(const std::string& text, const ReadChoice& choice) {
    std::size_t at = 0;
    int line = 0;
    const auto announced = announced_points(next_cells(text, at, line));
    if (!announced) return refused_at(std::max(line, 1), tell<"the first line is not a number of points">());
    if (*announced > most_listed_points)
        return refused_at(line, tell<"more than %1 points: divide the file">(most_listed_points));
    const std::string name = plain_name(without_ending(choice.file_name));
    Proposals proposals{.title = name.empty() ? "Points" : name};
    const Unit unit = choice.length_unit.value_or(Unit::of("mm"));
    if (!choice.length_unit)
        proposals.found.push_back(tell<"lengths are taken as mm: the file does not say its unit">());
    TableRows features(table_of(geometry_model, "features")), points(table_of(geometry_model, "points"));
    for (const char* axis : {"x", "y", "z"}) points.set_unit(axis, unit);
    std::size_t count = 0;
    for (; at < text.size() && count < *announced; ++count) {
        const std::vector<std::string> cells = next_cells(text, at, line);
        if (cells.empty()) break;
        if (cells.size() != 3)
            return refused_at(line, tell<"x y z were expected, %1 columns found">(cells.size()));
        std::array<double, 3> p{};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto number = csv_number(cells[c], false);
            if (!number || !std::isfinite(*number))
                return refused_at(line, int(c) + 1, tell<"'%1' is not a number">(plain_name(cells[c])));
            p[c] = *number;
        }
        points.add({{"name", std::to_string(count + 1)}, {"x", p[0]}, {"y", p[1]}, {"z", p[2]}});
    }
    if (count < *announced)
        return refused_at(line,
                          tell<"the first line announces %1 points, but there are %2">(*announced, count));
    if (const auto cells = next_cells(text, at, line); !cells.empty())
        proposals.leave_out(line, tell<"what stands behind the %1 points">(count));
    features.add({{"name", proposals.title}, {"form", form_of(name, count, proposals)}});
    AnalysisEntry analysis{
        .id = id_of(proposals.title, "geometry"), .model = geometry_model, .name = proposals.title};
    analysis.notes = "From " +
                     (choice.file_name.empty() ? "a list of coordinates" : plain_name(choice.file_name)) +
                     ", which states no uncertainty.";
    analysis.setup.values["features"] = features.table();
    analysis.setup.values["points"] = points.table();
    const bool scatters = count > 7;
    if (scatters) analysis.setup.values["point_uncertainty"] = std::string("scatter");
    proposals.found.push_back(
        scatters ? tell<"%1 points; their uncertainty is taken from their scatter about the form">(count)
                 : tell<"%1 points; state their uncertainty: the file says nothing of it">(count));
    proposals.analyses.push_back(std::move(analysis));
    return proposals;
}

}  // namespace

Reader coordinate_list_reader() {
    return {.name = "coordinates",
            .title = "List of coordinates (NIST .ds)",
            .pattern = "*.ds *.txt *.xyz",
            .takes = "a line with the number of points, then x y z of each -> geometry from points",
            .recognise = recognise_coordinates,
            .read = read_coordinates};
}

}  // namespace covaria
