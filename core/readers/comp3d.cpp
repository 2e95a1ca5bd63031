// Lists of Comp3D (IGN) that stand alone: coordinates (.cor) with their standard deviations, observations
// (.obs) with theirs. Lengths are in metres; the unit of angles stands in neither file, but in the settings
// of the computation.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/base/utf8.h"
#include "core/project/csv_reader.h"
#include "core/readers/comp3d_lists.h"
#include "core/readers/comp3d_survey.h"
#include "core/readers/delimited_text.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/listed_points.h"
#include "core/readers/stated_quantities.h"
#include "core/readers/unstated_units.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// Whether a line of so many cells is one of: code name x y z [sx sy sz] [eta xi].
bool is_width(std::size_t cells) {
    return cells == 5 || cells == 7 || cells == 8 || cells == 10;
}

/// The axes whose coordinates a code constrains to their values; all others are approximate.
std::string constrained_by(const Comp3dCode& code) {
    std::string axes;
    for (std::size_t i = 0; i < 3; ++i)
        if (code.constrains(i)) axes += "xyz"[i];
    return axes;
}

class CorReader {
public:
    CorReader(PointList& list, Proposals& proposals) : list_(list), proposals_(proposals) {}

    Result<void> read_line(std::string_view line, int number) {
        if (line.find('*') != std::string_view::npos) ++comments_;
        const std::vector<std::string> cells = blank_separated(comp3d_content(line));
        if (cells.empty()) return {};
        if (cells[0].front() == '@') {
            proposals_.leave_out(number,
                                 tell<"a file that it includes: %1">(in_quotes(plain_name(cells[0]))));
            return {};
        }
        if (!Comp3dCode::of(cells[0]))
            return refused_at(number, 1, tell<"the code of a point is expected, a digit">());
        if (cells[0] == "-1") {
            proposals_.leave_out(number, tell<"a point that is not to be used: %1">(
                                             in_quotes(plain_name(cells.size() > 1 ? cells[1] : ""))));
            return {};
        }
        if (!is_width(cells.size()))
            return refused_at(number, static_cast<int>(cells.size()),
                              tell<"code, name, x, y, z, three standard deviations and two deflections of "
                                   "the vertical are expected, there are %1 columns">(cells.size()));
        if (list_.points.size() == most_listed_points)
            return refused_at(number, tell<"too many points: divide the file">());
        return add_point(cells, number);
    }

    void finish() {
        for (const auto& [code, lines] : codes_)
            proposals_.leave_out(lines.first,
                                 tell<"standard deviations of %1 points of code %2: it constrains %3">(
                                     lines.second, code,
                                     constrained_by(*Comp3dCode::of(code)).empty()
                                         ? tell<"none of their coordinates">()
                                         : tell<"%1 only">(constrained_by(*Comp3dCode::of(code)))));
        if (deflections_ > 0)
            proposals_.leave_out(0, tell<"deflections of the vertical of %1 points">(deflections_));
        if (approximate_ > 0)
            proposals_.found.push_back(tell<"%1 points are not constrained: their coordinates are "
                                            "approximate ones for the adjustment">(approximate_));
        if (comments_ > 0) proposals_.leave_out(0, tell<"%1 comments">(comments_));
    }

private:
    Result<void> add_point(const std::vector<std::string>& cells, int number) {
        ListedPoint point{.line = number, .name = cells[1]};
        const bool stated = cells.size() == 8 || cells.size() == 10;
        const std::string constrained = constrained_by(*Comp3dCode::of(cells[0]));
        for (std::size_t i = 2; i < cells.size(); ++i) {
            const auto value = csv_number(cells[i], false);
            if (!value)
                return refused_at(number, static_cast<int>(i) + 1,
                                  tell<"%1 is not a number">(in_quotes(plain_name(cells[i]))));
            if (i < 5) point.p[i - 2] = *value;
            if (i < 5 || i >= 8 || !stated || constrained.find("xyz"[i - 5]) == std::string::npos) continue;
            if (*value >= 0.0)
                point.u[i - 5] = *value;
            else
                proposals_.leave_out(number,
                                     tell<"%1: the constraint of %2, which is switched off">(
                                         in_quotes(plain_name(point.name)), std::string(1, "xyz"[i - 5])));
        }
        if (stated && constrained.size() < 3) {
            auto& lines = codes_.try_emplace(cells[0], std::pair{number, 0}).first->second;
            ++lines.second;
        }
        if (cells.size() == 7 || cells.size() == 10) ++deflections_;
        if (constrained.empty()) ++approximate_;
        list_.points.push_back(std::move(point));
        return {};
    }

    PointList& list_;
    Proposals& proposals_;
    std::size_t deflections_ = 0, approximate_ = 0;
    std::map<std::string, std::pair<int, int>> codes_;
    std::size_t comments_ = 0;
};

Recognition recognise_cor(std::string_view beginning, const std::string& file_name) {
    if (!file_name.ends_with(".cor") && !file_name.ends_with(".COR")) return Recognition::no;
    while (!beginning.empty()) {
        const std::size_t end = std::min(beginning.find('\n'), beginning.size());
        const std::vector<std::string> cells = blank_separated(comp3d_content(beginning.substr(0, end)));
        beginning.remove_prefix(std::min(end + 1, beginning.size()));
        if (cells.empty() || cells[0].front() == '@') continue;
        const bool point = Comp3dCode::of(cells[0]) && (cells[0] == "-1" || is_width(cells.size()));
        return point ? Recognition::certain : Recognition::no;
    }
    return Recognition::no;
}

}  // namespace

Result<Proposals> read_comp3d_coordinates(const std::string& text, const ReadChoice& choice) {
    Proposals proposals{.title = without_ending(choice.file_name)};
    proposals.found.push_back(tell<"coordinates in metres">());
    if (choice.length_unit)
        proposals.leave_out(0, tell<"the stated unit of lengths: coordinates of Comp3D are in metres">());
    PointList list{.title = proposals.title.empty() ? "Points" : proposals.title,
                   .unit = Unit::of("m"),
                   .source = "Comp3D, " + plain_name(choice.file_name)};
    CorReader reader(list, proposals);
    std::string_view rest = without_byte_order_mark(text);
    for (int number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        if (auto done = reader.read_line(rest.substr(0, end), number); !done) return fail(done.error());
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    reader.finish();
    auto proposed = propose_points(std::move(list), proposals);
    if (!proposed) return fail(proposed.error());
    return proposals;
}

namespace {

/// Observations between two points, one a line.
class ObsReader {
public:
    explicit ObsReader(const ReadChoice& choice) : choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
        if (proposals_.title.empty()) proposals_.title = "Observations";
    }

    Result<void> read_line(std::string_view line, int number) {
        const std::vector<std::string> cells = blank_separated(comp3d_content(line));
        if (cells.empty()) return {};
        const auto code = cells[0].size() <= 3 ? csv_number(cells[0], false) : std::nullopt;
        if (cells[0].front() == '@' || (cells.size() > 2 && cells[2].front() == '@')) {
            proposals_.leave_out(number,
                                 tell<"a file that it includes: %1">(in_quotes(plain_name(cells.back()))));
            return {};
        }
        if (!code || *code != std::floor(*code))
            return refused_at(number, 1, tell<"the code of an observation is expected, a whole number">());
        const Kind* kind = kind_of(static_cast<int>(std::abs(*code)));
        if (!kind) {
            proposals_.leave_out(number, tell<"an observation of code %1">(plain_name(cells[0])));
            return {};
        }
        if (cells.size() != 5 && cells.size() != 6 && cells.size() != 8)
            return refused_at(number, static_cast<int>(cells.size()),
                              tell<"code, two points, value, one or two standard deviations and two heights "
                                   "are expected, there are %1 columns">(cells.size()));
        std::array<double, 5> figures{};
        for (std::size_t i = 3; i < cells.size(); ++i) {
            const auto value = csv_number(cells[i], false);
            if (!value)
                return refused_at(number, static_cast<int>(i) + 1,
                                  tell<"%1 is not a number">(in_quotes(plain_name(cells[i]))));
            figures[i - 3] = *value;
        }
        const std::string between = plain_name(cells[1]) + " - " + plain_name(cells[2]);
        if (*code < 0.0 || (figures[1] < 0.0 && kind->code != 9)) {
            proposals_.leave_out(number, tell<"%1 %2: it is switched off">(std::string(kind->name), between));
            return {};
        }
        return kind->code == 9 ? add_centring(between, figures, number)
                               : add(*kind, between, figures, number);
    }

    Result<Proposals> finish() {
        if (beyond_ > 0)
            proposals_.leave_out(0, tell<"%1 observations: more than %2">(beyond_, most_stated_quantities));
        if (quantities_.empty())
            return fail(ErrorCode::bad_input, tell<"the file has no observation that is taken">());
        proposals_.found.push_back(tell<"%1 observations, lengths in metres; each is its own result: write "
                                        "the equations of what you measure with them">(quantities_.size()));
        proposals_.analyses.push_back(
            analysis_of(id_of(proposals_.title, "observations"), proposals_.title,
                        "From Comp3D, " + plain_name(choice_.file_name) + ". Standard deviations as stated.",
                        quantities_));
        return std::move(proposals_);
    }

private:
    struct Kind {
        int code;
        const char* name;
        bool angle, distance;
    };

    static const Kind* kind_of(int code) {
        static constexpr std::array<Kind, 9> kinds{{{1, "slope distance", false, true},
                                                    {2, "horizontal distance", false, true},
                                                    {3, "slope distance", false, true},
                                                    {4, "height difference", false, false},
                                                    {5, "horizontal direction", true, false},
                                                    {6, "zenith angle", true, false},
                                                    {7, "horizontal direction", true, false},
                                                    {8, "azimuth", true, false},
                                                    {9, "centring", false, false}}};
        const auto found =
            std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.code == code; });
        return found == kinds.end() ? nullptr : &*found;
    }

    Result<void> add(const Kind& kind, const std::string& between, const std::array<double, 5>& figures,
                     int number) {
        Unit unit = Unit::of("m");
        if (kind.angle) {
            unit = unstated_unit(choice_, "angles", "angles", Unit::of("gon"), proposals_);
            if (unit.dimension() != Unit::of("rad").dimension())
                return fail(ErrorCode::usage,
                            tell<"the unit of angles must be one of an angle: gon, deg, rad">());
        }
        double u = figures[1];
        if (kind.distance)
            u += figures[2] * std::abs(figures[0]);
        else if (figures[2] != 0.0)
            proposals_.leave_out(
                number, tell<"%1 %2: the part of its standard deviation that depends on the distance">(
                            std::string(kind.name), between));
        StatedQuantity q{.symbol = "", .name = std::string(kind.name) + " " + between, .value = figures[0]};
        q.unit = unit;
        q.a = u;
        if (figures[3] != 0.0 || figures[4] != 0.0)
            q.source =
                "heights " + shortest_number(figures[3]) + " m and " + shortest_number(figures[4]) + " m";
        take(std::move(q), number);
        return {};
    }

    /// Adds a centring, which is two observations of 0; a negative standard deviation switches one off, and
    /// where the second is 0 it is the first.
    Result<void> add_centring(const std::string& between, const std::array<double, 5>& figures, int number) {
        const double second = figures[2] == 0.0 ? figures[1] : figures[2];
        for (const auto& [axis, u] : {std::pair("x", figures[1]), std::pair("y", second)}) {
            const std::string name = "centring " + between + ", " + axis;
            if (u < 0.0) {
                proposals_.leave_out(number, tell<"%1: it is switched off">(name));
                continue;
            }
            StatedQuantity q{.symbol = "", .name = name};
            q.unit = Unit::of("m");
            q.a = u;
            take(std::move(q), number);
        }
        return {};
    }

    void take(StatedQuantity q, int number) {
        if (quantities_.size() == most_stated_quantities) {
            ++beyond_;
            return;
        }
        q.symbol = "o_" + std::to_string(quantities_.size() + 1);
        q.name = plain_name(q.name);
        q.statement = "standard";
        q.source = "line " + std::to_string(number) + (q.source.empty() ? "" : ", ") + q.source;
        quantities_.push_back(std::move(q));
    }

    const ReadChoice& choice_;
    Proposals proposals_;
    std::vector<StatedQuantity> quantities_;
    std::size_t beyond_ = 0;
};

}  // namespace

Result<Proposals> read_comp3d_quantities(const std::string& text, const ReadChoice& choice) {
    ObsReader reader(choice);
    std::string_view rest = without_byte_order_mark(text);
    for (int number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        if (auto done = reader.read_line(rest.substr(0, end), number); !done) return fail(done.error());
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return reader.finish();
}

Reader comp3d_reader() {
    return {.name = "comp3d",
            .title = "Comp3D coordinates",
            .pattern = "*.cor",
            .takes =
                "code, name, x, y, z, standard deviations of coordinates that are constrained -> an artefact",
            .recognise = recognise_cor,
            .read = read_comp3d_coordinates};
}

}  // namespace covaria
