#include "core/readers/point_columns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/base/in_quotes.h"
#include "core/project/csv_reader.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Meaning = std::pair<PointColumnKind, int>;

struct ColumnWord {
    const char* word;
    PointColumnKind kind;
    int axis;
    const char* title;
};

constexpr std::array<ColumnWord, 15> column_words{
    {{"name", PointColumnKind::name, 0, "name of the point"},
     {"group", PointColumnKind::group, 0, "group"},
     {"collection", PointColumnKind::collection, 0, "collection"},
     {"x", PointColumnKind::coordinate, 0, "x"},
     {"y", PointColumnKind::coordinate, 1, "y"},
     {"z", PointColumnKind::coordinate, 2, "z"},
     {"u", PointColumnKind::standard, -1, "standard uncertainty of x, y, z"},
     {"u_x", PointColumnKind::standard, 0, "standard uncertainty of x"},
     {"u_y", PointColumnKind::standard, 1, "standard uncertainty of y"},
     {"u_z", PointColumnKind::standard, 2, "standard uncertainty of z"},
     {"U", PointColumnKind::expanded, -1, "expanded uncertainty of x, y, z, k = 2"},
     {"U_x", PointColumnKind::expanded, 0, "expanded uncertainty of x, k = 2"},
     {"U_y", PointColumnKind::expanded, 1, "expanded uncertainty of y, k = 2"},
     {"U_z", PointColumnKind::expanded, 2, "expanded uncertainty of z, k = 2"},
     {"-", PointColumnKind::unread, 0, "not read"}}};

/// The word and the unit of a header "X [mm]", "X (mm)" or "X/mm"; brackets around anything else stay in the
/// word.
PointColumn split_unit(const std::string& text) {
    PointColumn column{.word = text};
    const auto cut = [&](std::size_t keep, std::size_t begin, std::size_t length) {
        const auto unit = Unit::parse(text.substr(begin, length));
        if (!unit || unit->dimension() != Unit::of("m").dimension()) return;
        column.unit = *unit;
        column.word = text.substr(0, keep);
        while (!column.word.empty() && column.word.back() == ' ') column.word.pop_back();
    };
    const std::size_t open = text.find_last_of("[("), slash = text.rfind('/');
    if (open != std::string::npos && (text.back() == ']' || text.back() == ')'))
        cut(open, open + 1, text.size() - open - 2);
    else if (slash != std::string::npos)
        cut(slash, slash + 1, std::string::npos);
    return column;
}

std::string letters_of(const std::string& word) {
    std::string letters;
    for (const char c : word)
        if (std::isalnum(static_cast<unsigned char>(c)))
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The word with its coordinate in short: "x" of "X Coord" and "Coordinate X", "stddevx" of "std dev X".
std::string coordinate_letters(std::string letters) {
    for (const std::string name : {"coordinate", "koordinate", "coord", "koord"}) {
        if (letters.starts_with(name)) letters.erase(0, name.size());
        if (letters.ends_with(name)) letters.erase(letters.size() - name.size());
    }
    return letters;
}

Meaning meaning_of_header(const std::string& word) {
    const std::string letters = coordinate_letters(letters_of(word));
    if (is_one_of(letters,
                  {"name", "point", "pointname", "pt", "ptname", "id", "target", "pointid", "targetname",
                   "label", "punkt", "punktname", "punktnr", "punktnummer", "bezeichnung", "nr", "no"}))
        return {PointColumnKind::name, 0};
    if (is_one_of(letters, {"group", "groupname", "pointgroup", "gruppe"}))
        return {PointColumnKind::group, 0};
    if (is_one_of(letters, {"collection", "collectionname"})) return {PointColumnKind::collection, 0};
    if (letters.empty() || letters.back() < 'x' || letters.back() > 'z') return {PointColumnKind::unread, 0};
    const int axis = letters.back() - 'x';
    const std::string before = letters.substr(0, letters.size() - 1);
    if (before.empty()) return {PointColumnKind::coordinate, axis};
    if (is_one_of(before, {"u", "s", "sigma", "std", "stddev"})) return {PointColumnKind::standard, axis};
    return {PointColumnKind::unread, 0};
}

/// Whether a word such as U_x means two things: by the GUM it is an expanded uncertainty, but SpatialAnalyzer
/// writes Ux for one standard uncertainty.
bool means_two_things(const std::string& word) {
    return word.size() > 2 && word.front() == 'U' && !std::isalnum(static_cast<unsigned char>(word[1]));
}

tl::unexpected<Error> column_choice(const Message& what) {
    return fail(ErrorCode::usage, tell<"%1; state the columns: %2">(what, point_column_words()));
}

constexpr std::size_t most_point_columns = 1000;

Result<void> check(const PointColumns& columns) {
    if (columns.size() > most_point_columns)
        return fail(ErrorCode::bad_input, tell<"more than %1 columns are not read">(most_point_columns));
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (columns[i].kind != PointColumnKind::unread && columns[i].kind == columns[j].kind &&
                (columns[i].axis == columns[j].axis || columns[i].axis < 0 || columns[j].axis < 0))
                return column_choice("columns " + std::to_string(j + 1) + " (" + columns[j].word + ") and " +
                                     std::to_string(i + 1) + " (" + columns[i].word + ") are the same");
    for (int axis = 0; axis < 3; ++axis)
        if (std::none_of(columns.begin(), columns.end(), [&](const PointColumn& column) {
                return column.kind == PointColumnKind::coordinate && column.axis == axis;
            }))
            return column_choice(std::string("no column is ") + "xyz"[axis]);
    return {};
}

}  // namespace

std::vector<std::pair<std::string, std::string>> point_column_titles() {
    std::vector<std::pair<std::string, std::string>> titles;
    for (const ColumnWord& word : column_words) titles.emplace_back(word.word, word.title);
    return titles;
}

std::string word_of(const PointColumn& column) {
    for (const ColumnWord& word : column_words)
        if (word.kind == column.kind && word.axis == column.axis)
            return std::string(word.word) + (column.unit ? " [" + column.unit->text() + "]" : "");
    return "-";
}

std::string point_column_words() {
    return "name, group, collection, x, y, z, u_x, u_y, u_z or u (standard uncertainties), U_x, U_y, U_z or "
           "U "
           "(expanded, k = 2), - (not read)";
}

Result<PointColumns> stated_point_columns(const std::vector<std::string>& words) {
    PointColumns columns;
    for (const std::string& word : words) {
        PointColumn column = split_unit(word);
        const auto known = std::find_if(column_words.begin(), column_words.end(),
                                        [&](const ColumnWord& w) { return column.word == w.word; });
        if (known == column_words.end()) {
            std::vector<std::string> names;
            for (const ColumnWord& w : column_words) names.emplace_back(w.word);
            return column_choice(tell<"there is no column %1%2">(in_quotes(word), did_you_mean(word, names)));
        }
        column.kind = known->kind;
        column.axis = known->axis;
        columns.push_back(std::move(column));
    }
    if (auto checked = check(columns); !checked) return fail(checked.error());
    return columns;
}

Result<PointColumns> point_columns_of_headers(const std::vector<std::string>& headers) {
    PointColumns columns;
    for (const std::string& header : headers) {
        PointColumn column = split_unit(header);
        if (means_two_things(column.word))
            return column_choice("the header " + in_quotes(header) +
                                 " may mean an expanded or a standard uncertainty");
        std::tie(column.kind, column.axis) = meaning_of_header(column.word);
        columns.push_back(std::move(column));
    }
    if (auto checked = check(columns); !checked) return fail(checked.error());
    return columns;
}

bool take_line_of_units(const std::vector<std::string>& cells, PointColumns& columns) {
    PointColumns taken = columns;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        if (taken[i].kind == PointColumnKind::unread || taken[i].kind == PointColumnKind::name ||
            taken[i].kind == PointColumnKind::group || taken[i].kind == PointColumnKind::collection)
            continue;
        std::string text = i < cells.size() ? cells[i] : std::string();
        if (text.size() > 2 && (text.front() == '[' || text.front() == '('))
            text = text.substr(1, text.size() - 2);
        const auto unit = Unit::parse(text);
        if (!unit || csv_number(text, true) || unit->dimension() != Unit::of("m").dimension()) return false;
        taken[i].unit = *unit;
    }
    columns = std::move(taken);
    return true;
}

bool are_point_headers(const std::vector<std::string>& cells) {
    std::array<bool, 3> has{};
    for (const std::string& cell : cells) {
        if (csv_number(cell, true)) return false;
        const auto [kind, axis] = meaning_of_header(split_unit(cell).word);
        if (kind == PointColumnKind::coordinate) has[static_cast<std::size_t>(axis)] = true;
    }
    return has[0] && has[1] && has[2];
}

}  // namespace covaria
