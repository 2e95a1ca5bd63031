#include "core/readers/gsi_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/text_places.h"
#include "core/base/utf8.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

constexpr double half_circle = std::numbers::pi;
constexpr std::size_t most_blocks = 300'000;

bool are_digits(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The angle of a reading in degrees, minutes, seconds and their tenths: "35945123".
double sexagesimal(double digits) {
    const double degrees = std::floor(digits / 1e5), minutes = std::floor(digits / 1e3) - 100.0 * degrees;
    const double seconds = (digits - 1e5 * degrees - 1e3 * minutes) / 10.0;
    return (degrees + minutes / 60.0 + seconds / 3600.0) * half_circle / 180.0;
}

/// The value in SI by the digit of the unit; empty for a unit that the kind of word does not have.
std::optional<double> in_si(double digits, char unit, bool angle) {
    switch (unit) {
        case '0':
            return angle ? std::nullopt : std::optional(digits / 1e3);
        case '1':
            return angle ? std::nullopt : std::optional(digits / 1e3 * 0.3048);
        case '2':
            return angle ? std::optional(digits / 1e5 * half_circle / 200.0) : std::nullopt;
        case '3':
            return angle ? std::optional(digits / 1e5 * half_circle / 180.0) : std::nullopt;
        case '4':
            return angle ? std::optional(sexagesimal(digits)) : std::nullopt;
        case '5':
            return angle ? std::optional(digits / 1e4 * half_circle / 3200.0) : std::nullopt;
        case '6':
            return angle ? std::nullopt : std::optional(digits / 1e4);
        case '7':
            return angle ? std::nullopt : std::optional(digits / 1e4 * 0.3048);
        case '8':
            return angle ? std::nullopt : std::optional(digits / 1e5);
        default:
            return std::nullopt;
    }
}

class BlockReader {
public:
    Result<void> read_line(std::string_view line, int number) {
        const std::size_t mark = line.empty() || line[0] != '*' ? 0 : 1;
        const std::size_t width = mark == 1 ? 24 : 16;
        for (std::size_t at = mark; at < line.size(); at += width) {
            std::string_view word = line.substr(at, width);
            word = word.substr(0, word.find_last_not_of(' ') + 1);
            if (word.empty()) continue;
            if (auto done = read_word(word, width - 1, number, static_cast<int>(at) + 1); !done) return done;
        }
        return {};
    }

    std::vector<GsiBlock> blocks;

private:
    Result<void> read_word(std::string_view word, std::size_t width, int line, int column) {
        if (word.size() < 8 || word.size() > width || !are_digits(word.substr(0, 2)) ||
            (word[6] != '+' && word[6] != '-'))
            return refused_at(line, column,
                              tell<"no word of GSI: index, information, sign and data are expected">());
        const int index = (word[0] - '0') * 10 + (word[1] - '0');
        if (index == 11 || (index >= 41 && index <= 49)) {
            if (blocks.size() == most_blocks)
                return refused_at(line, column, tell<"more than %1 blocks">(most_blocks));
            blocks.emplace_back().line = line;
        }
        if (blocks.empty()) return refused_at(line, column, tell<"a block begins with the word 11 or 41">());
        GsiBlock& block = blocks.back();
        if (index == 11) {
            const std::string_view data = word.substr(7);
            block.point =
                plain_name(std::string(data.substr(std::min(data.find_first_not_of('0'), data.size() - 1))));
            return {};
        }
        std::optional<double>* place = place_of(block, index);
        if (!place) {
            block.others.push_back(index);
            return {};
        }
        return read_number(word, index == 21 || index == 22, *place, line, column);
    }

    static std::optional<double>* place_of(GsiBlock& block, int index) {
        if (index >= 81 && index <= 83) return &block.target[index - 81];
        if (index >= 84 && index <= 86) return &block.station[index - 84];
        switch (index) {
            case 21:
                return &block.azimuth;
            case 22:
                return &block.zenith;
            case 31:
                return &block.distance;
            case 87:
                return &block.target_height;
            case 88:
                return &block.instrument_height;
            default:
                return nullptr;
        }
    }

    static Result<void> read_number(std::string_view word, bool angle, std::optional<double>& place, int line,
                                    int column) {
        const std::string_view data = word.substr(7);
        double digits = 0.0;
        if (!are_digits(data))
            return refused_at(line, column + 7, tell<"the data of a word must be digits">());
        std::from_chars(data.data(), data.data() + data.size(), digits);
        const auto value = in_si(digits, word[5], angle);
        if (!value)
            return refused_at(
                line, column + 5,
                tell<"the unit '%1' is none of %2">(plain_name(std::string(1, word[5])),
                                                    (angle ? tell<"an angle">() : tell<"a length">())));
        place = word[6] == '-' ? -*value : *value;
        return {};
    }
};

}  // namespace

bool is_gsi(std::string_view text) {
    const std::size_t first = text.find_first_not_of("\r\n \xEF\xBB\xBF");
    if (first == std::string_view::npos) return false;
    text.remove_prefix(first);
    if (text.front() == '*') text.remove_prefix(1);
    const std::string_view word = text.substr(0, 15);
    return word.size() == 15 && are_digits(word.substr(0, 6)) && (word[6] == '+' || word[6] == '-') &&
           (word.starts_with("11") || word.starts_with("4"));
}

Result<std::vector<GsiBlock>> read_gsi(const std::string& text) {
    BlockReader reader;
    std::string_view rest = without_byte_order_mark(text);
    // Lines end with line feeds, carriage returns or both; some files have none at all.
    for (int number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end);
        rest.remove_prefix(rest.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest.size()));
        line = line.substr(0, line.find_last_not_of(' ') + 1);
        if (auto done = reader.read_line(line, number); !done) return fail(done.error());
    }
    if (reader.blocks.empty()) return fail(ErrorCode::bad_input, tell<"the file has no blocks of GSI">());
    for (GsiBlock& block : reader.blocks)
        if (block.distance && *block.distance == 0.0) block.distance.reset();
    return std::move(reader.blocks);
}

}  // namespace covaria
