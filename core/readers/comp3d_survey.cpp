#include "core/readers/comp3d_survey.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/base/utf8.h"
#include "core/project/csv_reader.h"
#include "core/readers/delimited_text.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

/// Bounds of files that include each other, and of what is kept of them.
constexpr std::size_t most_open = 8, most_included = 1000, most_kept = 300'000;

tl::unexpected<Error> refused_line(const Comp3dPlace& at, int column, const Message& what) {
    Error error = refused_at(at.line, column, what).value();
    error.file = at.file;
    return fail(std::move(error));
}

/// The numbers of the cells from the first on.
Result<std::vector<double>> numbers_after(std::span<const std::string> cells, std::size_t first,
                                          const Comp3dPlace& at) {
    std::vector<double> numbers;
    for (std::size_t i = first; i < cells.size(); ++i) {
        const auto value = csv_number(cells[i], false);
        if (!value)
            return refused_line(at, static_cast<int>(i) + 1,
                                tell<"%1 is not a number">(in_quotes(plain_name(cells[i]))));
        numbers.push_back(*value);
    }
    return numbers;
}

bool is_include(const std::string& cell) {
    return cell.starts_with('@');
}

/// What the codes stand for that no network here has.
Message words_of_code(int code, const std::string& origin) {
    switch (code) {
        case 19:
            return tell<"baselines of GNSS from %1: they are geocentric">(origin);
        case 21:
            return tell<"equal height differences whose size is not known">();
        default:
            return tell<"an observation of code %1">(code);
    }
}

/// The figures of a sighting by the number of its cells; false where there is no such number.
bool take_coordinate_figures(const std::vector<double>& n, Comp3dSighting& sighting) {
    const std::size_t count = n.size();
    if (count != 4 && count != 5 && count != 7 && count != 8) return false;
    const bool common = count < 7;
    for (std::size_t i = 0; i < 3; ++i) {
        sighting.value[i] = n[i];
        sighting.sigma[i] = common ? n[3] : n[3 + i];
        sighting.sigma_relative[i] = common ? (count == 5 ? n[4] : 0.0) : n[6];
    }
    sighting.height = count == 8 ? n[7] : 0.0;
    return true;
}

bool take_polar_figures(const std::vector<double>& n, Comp3dSighting& sighting) {
    const std::size_t count = n.size();
    if (count < 6 || count > 8) return false;
    const std::size_t of_length = count == 6 ? 4 : 5;
    for (std::size_t i = 0; i < 3; ++i) {
        sighting.value[i] = n[i];
        sighting.sigma[i] = i < 2 ? n[3] : n[of_length];
        sighting.sigma_relative[i] = i < 2 ? (count == 6 ? 0.0 : n[4]) : n[of_length + 1];
    }
    sighting.height = count == 8 ? n[7] : 0.0;
    return true;
}

}  // namespace

std::string_view comp3d_content(std::string_view line) {
    return line.substr(0, line.find('*'));
}

std::optional<Comp3dCode> Comp3dCode::of(const std::string& cell) {
    if (cell == "-1") return Comp3dCode{-1};
    if (cell.size() == 1 && cell[0] >= '0' && cell[0] <= '9') return Comp3dCode{cell[0] - '0'};
    return std::nullopt;
}

bool Comp3dCode::has(std::size_t axis) const {
    return code >= 0 && (axis < 2 ? code < 4 || code > 5 : code < 6);
}

bool Comp3dCode::constrains(std::size_t axis) const {
    return code == 1 || (axis < 2 ? code == 2 || code == 7 || code == 9 : code == 3 || code == 5);
}

void Comp3dSurveyReader::leave_out(const Comp3dPlace& at, const Message& what) {
    if (at.file.empty()) return proposals_.leave_out(at.line, what);
    proposals_.leave_out(0, at.line > 0 ? tell<"%1, line %2: %3">(plain_name(at.file), at.line, what)
                                        : tell<"%1: %2">(plain_name(at.file), what));
}

Result<void> Comp3dSurveyReader::read_points(const std::string& text, const std::string& file) {
    return read_lines(text, file, &Comp3dSurveyReader::take_point);
}

Result<void> Comp3dSurveyReader::read_observations(const std::string& text, const std::string& file) {
    return read_lines(text, file, &Comp3dSurveyReader::take_observation);
}

Result<void> Comp3dSurveyReader::read_lines(const std::string& text, const std::string& file, TakeLine take) {
    open_.push_back(file);
    std::string_view rest = without_byte_order_mark(text);
    for (int number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const Cells cells = blank_separated(comp3d_content(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (cells.empty()) continue;
        const Comp3dPlace at{file, number};
        auto done = is_include(cells[0]) ? include(cells[0].substr(1), at, take) : (this->*take)(cells, at);
        if (!done) return done;
    }
    open_.pop_back();
    return {};
}

/// The text of a file that another one names, by its path from there or from the first of them.
std::optional<std::string> Comp3dSurveyReader::text_beside(const std::string& name, const Comp3dPlace& at) {
    const std::string shown = in_quotes(plain_name(name));
    if (!beside_.read || ++included_ > most_included) {
        leave_out(at, tell<"a file that it includes: %1">(shown));
        return std::nullopt;
    }
    const std::filesystem::path folder = std::filesystem::path(at.file).parent_path();
    auto text = beside_.read((folder / name).generic_string());
    if (!text && !folder.empty()) text = beside_.read(name);
    if (text) return std::move(*text);
    leave_out(at, tell<"a file that it includes: %1: %2">(shown, text.error().message));
    return std::nullopt;
}

Result<void> Comp3dSurveyReader::include(const std::string& name, const Comp3dPlace& at, TakeLine take) {
    if (!name.empty() && (open_.size() >= most_open || std::ranges::find(open_, name) != open_.end()))
        return refused_line(
            at, 1,
            tell<"the file %1 includes itself, or too many one in another">(in_quotes(plain_name(name))));
    const auto text = text_beside(name, at);
    return text ? read_lines(*text, name, take) : Result<void>();
}

Result<void> Comp3dSurveyReader::take_point(const Cells& cells, const Comp3dPlace& at) {
    const auto code = Comp3dCode::of(cells[0]);
    if (!code) return refused_line(at, 1, tell<"the code of a point is expected, a digit">());
    const std::size_t n = cells.size();
    if (n < 2 || (!code->is_ignored() && n != 5 && n != 7 && n != 8 && n != 10))
        return refused_line(at, static_cast<int>(n),
                            tell<"code, name, x, y, z, three standard deviations and two deflections of "
                                 "the vertical are expected, there are %1 columns">(n));
    if (survey_.points.size() == most_kept)
        return refused_line(at, 1, tell<"too many points: divide the file">());
    Comp3dPoint point{.at = at, .code = *code, .name = plain_name(cells[1])};
    if (!code->is_ignored()) {
        const auto numbers = numbers_after(cells, 2, at);
        if (!numbers) return fail(numbers.error());
        std::copy_n(numbers->begin(), 3, point.p.begin());
        for (std::size_t axis = 0; axis < 3 && n >= 8; ++axis) point.sigma[axis] = (*numbers)[3 + axis];
        point.is_deflected = n == 7 || n == 10;
    }
    survey_.points.push_back(std::move(point));
    return {};
}

Result<void> Comp3dSurveyReader::take_observation(const Cells& cells, const Comp3dPlace& at) {
    const auto typed = cells[0].size() <= 3 ? csv_number(cells[0], false) : std::nullopt;
    if (!typed || *typed != std::floor(*typed))
        return refused_line(at, 1, tell<"the code of an observation is expected, a whole number">());
    const int code = static_cast<int>(std::abs(*typed));
    if ((cells.size() > 1 && is_include(cells[1])) || (cells.size() > 2 && is_include(cells[2])))
        return take_subfile(*typed < 0.0 ? -code : code, cells, at);
    if (!((code >= 1 && code <= 9) || code == 14 || code == 15)) {
        leave_out(at, words_of_code(code, plain_name(cells.size() > 1 ? cells[1] : "")));
        return {};
    }
    if (cells.size() != 5 && cells.size() != 6 && cells.size() != 8)
        return refused_line(at, static_cast<int>(cells.size()),
                            tell<"code, two points, value, one or two standard deviations and two heights "
                                 "are expected, there are %1 columns">(cells.size()));
    auto numbers = numbers_after(cells, 3, at);
    if (!numbers) return fail(numbers.error());
    if (survey_.observations.size() == most_kept)
        return refused_line(at, 1, tell<"too many observations: divide the file">());
    numbers->resize(5, 0.0);
    const std::vector<double>& n = *numbers;
    survey_.observations.push_back(
        {at, code, plain_name(cells[1]), plain_name(cells[2]), n[0], n[1], n[2], n[3], n[4], *typed > 0.0});
    return {};
}

Result<void> Comp3dSurveyReader::take_subfile(int code, const Cells& cells, const Comp3dPlace& at) {
    const std::size_t named = is_include(cells[1]) ? 1 : 2;
    const std::string file = cells[named].substr(1), origin = named == 2 ? plain_name(cells[1]) : "";
    const bool is_equality = code == 22 && named == 1;
    if (!is_equality && ((code != 11 && code != 12 && code != 18) || origin.empty())) {
        const Message words = words_of_code(std::abs(code), origin);
        leave_out(at, tell<"%1; a file that it includes: %2">(words, in_quotes(plain_name("@" + file))));
        return {};
    }
    const auto text = text_beside(file, at);
    if (!text) return {};
    if (code == 18) {
        survey_.axes.push_back({.at = at, .origin = origin});
        return read_lines(*text, file, &Comp3dSurveyReader::take_position);
    }
    if (is_equality) {
        survey_.equalities.push_back({.name = plain_name(file)});
        return read_lines(*text, file, &Comp3dSurveyReader::take_pair);
    }
    survey_.subframes.push_back({.at = at,
                                 .is_polar = code == 12,
                                 .is_level = cells.size() > 3 && cells[3] == "1",
                                 .origin = origin,
                                 .name = plain_name(file)});
    return read_lines(*text, file, &Comp3dSurveyReader::take_sighting);
}

Result<void> Comp3dSurveyReader::take_position(const Cells& cells, const Comp3dPlace& at) {
    if (cells[0] == "L") {
        leave_out(at, tell<"where the origin of the axis is along it">());
        return {};
    }
    const auto numbers = numbers_after(cells, 3, at);
    if (!numbers) return fail(numbers.error());
    if (numbers->size() != 2)
        return refused_line(at, static_cast<int>(cells.size()),
                            tell<"a target, a position, a point and two standard deviations are expected">());
    auto& positions = survey_.axes.back().positions;
    if (positions.size() == most_kept)
        return refused_line(at, 1, tell<"too many observations: divide the file">());
    positions.push_back({at, plain_name(cells[0]), plain_name(cells[2]), (*numbers)[0], (*numbers)[1]});
    return {};
}

Result<void> Comp3dSurveyReader::take_pair(const Cells& cells, const Comp3dPlace& at) {
    const auto numbers = numbers_after(cells, 2, at);
    if (!numbers) return fail(numbers.error());
    if (numbers->size() != 1)
        return refused_line(at, static_cast<int>(cells.size()),
                            tell<"two points and a standard deviation are expected">());
    auto& pairs = survey_.equalities.back().pairs;
    if (pairs.size() == most_kept)
        return refused_line(at, 1, tell<"too many observations: divide the file">());
    pairs.push_back({at, plain_name(cells[0]), plain_name(cells[1]), numbers->front()});
    return {};
}

Result<void> Comp3dSurveyReader::take_sighting(const Cells& cells, const Comp3dPlace& at) {
    Comp3dSubframe& subframe = survey_.subframes.back();
    const auto numbers = numbers_after(cells, 1, at);
    if (!numbers) return fail(numbers.error());
    Comp3dSighting sighting{.at = at, .target = plain_name(cells[0])};
    const bool taken = subframe.is_polar ? take_polar_figures(*numbers, sighting)
                                         : take_coordinate_figures(*numbers, sighting);
    if (!taken)
        return refused_line(
            at, static_cast<int>(cells.size()),
            tell<"a target with three figures and their standard deviations is expected, there "
                 "are %1 columns">(cells.size()));
    if (subframe.sightings.size() == most_kept)
        return refused_line(at, 1, tell<"too many observations: divide the file">());
    subframe.sightings.push_back(std::move(sighting));
    return {};
}

}  // namespace covaria
