// Comp3D coordinates (.cor): code, name, x, y, z and their standard deviations, in metres.
#include <algorithm>
#include <array>
#include <map>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/project/csv_reader.h"
#include "core/readers/delimited_text.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/listed_points.h"

namespace covaria {

namespace {

/// A line without what follows the sign of comment.
std::string_view without_comment(std::string_view line) {
    return line.substr(0, line.find('*'));
}

bool is_code(const std::string& cell) {
    return cell.size() == 1 && cell[0] >= '0' && cell[0] <= '9';
}

class CorReader {
public:
    CorReader(PointList& list, Proposals& proposals) : list_(list), proposals_(proposals) {}

    Result<void> read_line(std::string_view line, int number) {
        if (line.find('*') != std::string_view::npos) ++comments_;
        const std::vector<std::string> cells = blank_separated(without_comment(line));
        if (cells.empty()) return {};
        if (cells[0].front() == '@') {
            proposals_.leave_out(number, "a file that it includes: " + in_quotes(plain_name(cells[0])));
            return {};
        }
        if (!is_code(cells[0])) return refused_at(number, 1, "the code of a point is expected, a digit");
        if (cells.size() != 5 && cells.size() != 8)
            return refused_at(number, static_cast<int>(cells.size()),
                              "code, name, x, y, z and three standard deviations are expected, there are " +
                                  std::to_string(cells.size()) + " columns");
        if (list_.points.size() == most_listed_points)
            return refused_at(number, "too many points: divide the file");
        ListedPoint point{.line = number, .name = cells[1]};
        for (std::size_t i = 2; i < cells.size(); ++i) {
            const auto value = csv_number(cells[i], false);
            if (!value || (i >= 5 && *value < 0.0))
                return refused_at(
                    number, static_cast<int>(i) + 1,
                    in_quotes(plain_name(cells[i])) + (value ? " is negative" : " is not a number"));
            if (i < 5)
                point.p[i - 2] = *value;
            else if (cells[0] == "1")
                point.u[i - 5] = *value;
        }
        if (cells[0] != "1" && cells.size() == 8) {
            auto& lines = codes_.try_emplace(cells[0], std::pair{number, 0}).first->second;
            ++lines.second;
        }
        list_.points.push_back(std::move(point));
        return {};
    }

    void finish() {
        for (const auto& [code, lines] : codes_)
            proposals_.leave_out(lines.first, "standard deviations of " + std::to_string(lines.second) +
                                                  " points of code " + code +
                                                  ": only those of code 1 are taken");
        if (comments_ > 0) proposals_.leave_out(0, std::to_string(comments_) + " comments");
    }

private:
    PointList& list_;
    Proposals& proposals_;
    std::map<std::string, std::pair<int, int>> codes_;
    std::size_t comments_ = 0;
};

Recognition recognise_cor(std::string_view beginning, const std::string& file_name) {
    if (!file_name.ends_with(".cor") && !file_name.ends_with(".COR")) return Recognition::no;
    while (!beginning.empty()) {
        const std::size_t end = std::min(beginning.find('\n'), beginning.size());
        const std::vector<std::string> cells = blank_separated(without_comment(beginning.substr(0, end)));
        beginning.remove_prefix(std::min(end + 1, beginning.size()));
        if (cells.empty() || cells[0].front() == '@') continue;
        const bool point = is_code(cells[0]) && (cells.size() == 5 || cells.size() == 8);
        return point ? Recognition::certain : Recognition::no;
    }
    return Recognition::no;
}

Result<Proposals> read_cor(const std::string& text, const ReadChoice& choice) {
    Proposals proposals{.title = without_ending(choice.file_name)};
    proposals.found.push_back("coordinates in metres");
    if (choice.length_unit)
        proposals.leave_out(0, "the stated unit of lengths: coordinates of Comp3D are in metres");
    PointList list{.title = proposals.title.empty() ? "Points" : proposals.title,
                   .unit = Unit::of("m"),
                   .source = "Comp3D, " + plain_name(choice.file_name)};
    CorReader reader(list, proposals);
    std::string_view rest = text;
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

}  // namespace

Reader comp3d_reader() {
    return {.name = "comp3d",
            .title = "Comp3D coordinates",
            .pattern = "*.cor",
            .takes = "code, name, x, y, z, standard deviations of points of code 1 -> an artefact",
            .recognise = recognise_cor,
            .read = read_cor};
}

}  // namespace covaria
