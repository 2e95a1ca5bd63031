// Tables of points: with headers or stated columns, and SpatialAnalyzer's ASCII formats, which have none.
#include <algorithm>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/base/utf8.h"
#include "core/readers/delimited_text.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/listed_points.h"
#include "core/readers/point_columns.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

/// Reader of rows with known columns, which become points of a list.
class PointRows {
public:
    PointRows(PointColumns columns, const DelimitedText& format, PointList& list, Proposals& proposals)
        : columns_(std::move(columns)), format_(format), list_(list), proposals_(proposals) {}

    Result<void> add(const CsvRow& row) {
        if (list_.points.size() == most_listed_points)
            return refused_at(row.line, tell<"more than %1 points: divide the file">(most_listed_points));
        ListedPoint point{.line = row.line};
        std::string collection;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const std::string cell = i < row.cells.size() ? row.cells[i] : std::string();
            switch (columns_[i].kind) {
                case PointColumnKind::unread:
                    break;
                case PointColumnKind::name:
                    point.name = cell;
                    break;
                case PointColumnKind::group:
                    point.group = cell;
                    break;
                case PointColumnKind::collection:
                    collection = cell;
                    break;
                default:
                    if (auto read = read_figure(i, cell, point); !read) return read;
            }
        }
        if (!collection.empty()) point.group = collection + (point.group.empty() ? "" : "/" + point.group);
        if (auto fits = check_width(row); !fits) return fits;
        list_.points.push_back(std::move(point));
        return {};
    }

private:
    Result<void> read_figure(std::size_t i, const std::string& cell, ListedPoint& point) {
        const PointColumn& column = columns_[i];
        const bool coordinate = column.kind == PointColumnKind::coordinate;
        if (cell.empty() && !coordinate) return {};
        const auto number = csv_number(cell, format_.decimal_comma);
        const auto refused = [&](const Message& what) {
            return refused_at(point.line, static_cast<int>(i) + 1,
                              "(" + column.word + ") " + in_quotes(plain_name(cell)) + what);
        };
        if (!number) return refused(cell.empty() ? tell<" is empty">() : tell<" is not a number">());
        if (!coordinate && *number < 0.0) return refused(tell<": an uncertainty must not be negative">());
        const double value = in_unit_of_list(*number, column);
        if (!std::isfinite(value)) return refused(tell<" is too large">());
        if (coordinate)
            point.p[static_cast<std::size_t>(column.axis)] = value;
        else
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (column.axis < 0 || column.axis == static_cast<int>(axis))
                    point.u[axis] = column.kind == PointColumnKind::expanded ? value / 2.0 : value;
        return {};
    }

    double in_unit_of_list(double value, const PointColumn& column) const {
        if (!column.unit || *column.unit == list_.unit) return value;
        return list_.unit.from_si(column.unit->to_si(value));
    }

    /// Checks whether a row has more cells than columns. Between blanks it is refused then: a name may have
    /// several words, and all behind it would be another column.
    Result<void> check_width(const CsvRow& row) {
        std::size_t width = row.cells.size();
        while (width > columns_.size() && row.cells[width - 1].empty()) --width;
        if (width <= columns_.size()) return {};
        if (format_.separator == ' ')
            return refused_at(
                row.line, static_cast<int>(columns_.size()) + 1,
                tell<"the line has %1 columns instead of %2; put names that contain blanks into quotes">(
                    width, columns_.size()));
        proposals_.leave_out(row.line, tell<"what stands behind column %1">(columns_.size()));
        return {};
    }

    PointColumns columns_;
    DelimitedText format_;
    PointList& list_;
    Proposals& proposals_;
};

/// The unit of coordinates: as stated, else as the header of x says, else mm.
Unit unit_of_list(const PointColumns& columns, const ReadChoice& choice, Proposals& proposals) {
    for (const PointColumn& column : columns)
        if (column.kind == PointColumnKind::coordinate && column.axis == 0 && column.unit)
            return *column.unit;
    if (choice.length_unit) return *choice.length_unit;
    proposals.found.push_back(tell<"lengths are taken as mm: the file does not say its unit">());
    return Unit::of("mm");
}

void say_columns(const PointColumns& columns, const DelimitedText& format, Proposals& proposals) {
    std::string words;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const PointColumn& column = columns[i];
        if (column.kind == PointColumnKind::unread)
            proposals.leave_out(
                0, tell<"column %1%2">(i + 1,
                                       (column.word == "-" ? "" : " " + in_quotes(plain_name(column.word)))));
        words += (i > 0 ? ", " : "") +
                 (column.kind == PointColumnKind::unread ? std::string("-") : plain_name(column.word));
        if (column.kind == PointColumnKind::standard) words += " (u)";
        if (column.kind == PointColumnKind::expanded) words += " (U, k = 2)";
    }
    proposals.found.push_back(tell<"%1: %2">(format.words(), words));
}

/// The text from the line on that is read, and the number of lines above the headers.
struct TableText {
    std::string_view text;
    int lines_before = 0;
};

/// The text from the line of headers on, if there is one among the first lines; else all of it.
TableText from_headers(std::string_view text) {
    text = without_byte_order_mark(text);
    std::size_t at = 0;
    bool titles = false;  // comments alone do not count here: they are read and counted
    for (int line = 0; line < 30 && at < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view one = text.substr(at, end - at);
        const std::vector<std::string> cells = first_cells(one, delimited_text_of(one));
        if (are_point_headers(cells)) return titles ? TableText{text.substr(at), line} : TableText{text, 0};
        titles = titles || !cells.empty();
        at = end + 1;
    }
    return {text, 0};
}

Result<Proposals> read_points(const TableText& table, const ReadChoice& choice, const DelimitedText& format,
                              PointColumns columns, bool skip_first, const std::string& what) {
    Proposals proposals{.title = without_ending(choice.file_name)};
    const std::string_view text = table.text;
    if (table.lines_before > 0)
        proposals.leave_out(1, tell<"%1 lines above the headers">(table.lines_before));
    bool units = skip_first && std::none_of(columns.begin(), columns.end(), [](const PointColumn& column) {
                     return column.unit.has_value();
                 });
    if (units) {
        std::size_t number = 0, ignored = 0;
        static_cast<void>(scan_table(text, format, ignored, [&](CsvRow&& row) {
            if (number++ == 0) return true;
            units = take_line_of_units(row.cells, columns);
            return false;
        }));
    }
    say_columns(columns, format, proposals);
    PointList list{.title = proposals.title.empty() ? "Points" : proposals.title,
                   .unit = unit_of_list(columns, choice, proposals),
                   .source = what + (choice.file_name.empty() ? "" : ", " + plain_name(choice.file_name))};
    PointRows rows(std::move(columns), format, list, proposals);
    Result<void> added;
    std::size_t comments = 0;
    const auto scanned = scan_table(text, format, comments, [&](CsvRow&& row) {
        if (std::exchange(skip_first, false)) return true;
        if (std::exchange(units, false)) return true;
        row.line += table.lines_before;
        added = rows.add(row);
        return added.has_value();
    });
    if (!scanned) {
        Error error = scanned.error();
        error.line += table.lines_before;
        return fail(std::move(error));
    }
    if (!added) return fail(added.error());
    if (comments > 0) proposals.leave_out(0, tell<"%1 lines of comment">(comments));
    auto proposed = propose_points(std::move(list), proposals);
    if (!proposed) return fail(proposed.error());
    return proposals;
}

Recognition recognise_table(std::string_view beginning, const std::string&) {
    const std::string_view from = from_headers(beginning).text;
    return are_point_headers(first_cells(from, delimited_text_of(from))) ? Recognition::possible
                                                                         : Recognition::no;
}

Result<Proposals> read_table(const std::string& text, const ReadChoice& choice) {
    const TableText table = from_headers(text);
    const DelimitedText format = delimited_text_of(table.text);
    const std::vector<std::string> first = first_cells(table.text, format);
    const bool numbers = std::any_of(first.begin(), first.end(), [&](const std::string& cell) {
        return csv_number(cell, format.decimal_comma).has_value();
    });
    if (choice.columns.empty() && numbers)
        return fail(ErrorCode::usage,
                    tell<"the table has no line of headers; state the columns: %1">(point_column_words()));
    auto columns =
        choice.columns.empty() ? point_columns_of_headers(first) : stated_point_columns(choice.columns);
    if (!columns) return fail(columns.error());
    return read_points(table, choice, format, std::move(*columns), !numbers, "table of points");
}

/// The numbers of words before the numbers of a row, of its numbers, and of cells behind them.
struct RowShape {
    std::size_t words = 0, numbers = 0, behind = 0;
};

RowShape shape_of(const std::vector<std::string>& cells, const DelimitedText& format) {
    const auto is_number = [&](const std::string& cell) {
        return csv_number(cell, format.decimal_comma).has_value();
    };
    RowShape shape;
    std::size_t at = 0;
    for (; at < cells.size() && !is_number(cells[at]); ++at) ++shape.words;
    for (; at < cells.size() && is_number(cells[at]); ++at) ++shape.numbers;
    for (; at < cells.size(); ++at) shape.behind += !cells[at].empty();
    return shape;
}

Recognition recognise_spatial_analyzer(std::string_view beginning, const std::string&) {
    const DelimitedText format = delimited_text_of(beginning);
    const RowShape shape = shape_of(first_cells(beginning, format), format);
    return shape.words <= 3 && shape.numbers >= 3 && shape.numbers <= 8 ? Recognition::possible
                                                                        : Recognition::no;
}

/// The columns of "[collection] [group] point X Y Z [Ux Uy Uz]". Only a reader that was named settles rows
/// that look alike.
Result<PointColumns> spatial_analyzer_columns(RowShape shape, bool chosen) {
    const std::string numbers = std::to_string(shape.numbers);
    // The names of points may be numbers.
    if (chosen && shape.words == 0 && (shape.numbers == 4 || shape.numbers == 7))
        shape = {1, shape.numbers - 1};
    if (chosen && shape.words == 0 && (shape.numbers == 5 || shape.numbers == 8))
        shape = {2, shape.numbers - 2};
    if (chosen && shape.words == 1 && (shape.numbers == 4 || shape.numbers == 7))
        shape = {2, shape.numbers - 1};
    const bool coordinates = shape.numbers == 3, uncertainties = shape.numbers == 6;
    if (shape.behind > 0 || shape.words > 3 || (!coordinates && !uncertainties))
        return fail(ErrorCode::usage,
                    tell<"its columns may mean several things (names that are numbers, offsets, weights, "
                         "tolerances, notes); state the columns: %1">(point_column_words()));
    if (uncertainties && !chosen)
        return fail(
            ErrorCode::usage,
            tell<"six numbers may be X Y Z Ux Uy Uz, but also X Y Z with weights, a vector or the angles of "
                 "a frame: name the reader if they are uncertainties, or state the columns: %1">(
                point_column_words()));
    std::vector<std::string> words{"collection", "group", "name"};
    words.erase(words.begin(), words.end() - static_cast<std::ptrdiff_t>(shape.words));
    for (const char* axis : {"x", "y", "z"}) words.emplace_back(axis);
    if (uncertainties)
        for (const char* u : {"u_x", "u_y", "u_z"}) words.emplace_back(u);
    return stated_point_columns(words);
}

Result<Proposals> read_spatial_analyzer(const std::string& text, const ReadChoice& choice) {
    const DelimitedText format = delimited_text_of(text);
    const std::vector<std::string> first = first_cells(text, format);
    if (first.empty()) return fail(ErrorCode::bad_input, tell<"the file has no points">());
    auto columns = choice.columns.empty() ? spatial_analyzer_columns(shape_of(first, format), choice.chosen)
                                          : stated_point_columns(choice.columns);
    if (!columns) return fail(columns.error());
    return read_points({text, 0}, choice, format, std::move(*columns), false, "SpatialAnalyzer points")
        .map([](Proposals proposals) {
            proposals.found.insert(proposals.found.begin() + 1,
                                   "coordinates are read as Cartesian: cylindric and polar ones look alike");
            return proposals;
        });
}

/// The first rows of a file of points; with columns as the reader finds them, where it does.
Result<SourceTable> rows_of_points(const std::string& whole, const ReadChoice& choice, bool headers) {
    const std::string_view text = headers ? from_headers(whole).text : std::string_view(whole);
    const DelimitedText format = delimited_text_of(text);
    SourceTable table;
    std::size_t comments = 0, width = 0;
    const auto scanned = scan_table(text, format, comments, [&](CsvRow&& row) {
        width = std::max(width, row.cells.size());
        for (std::string& cell : row.cells) cell = plain_name(cell);
        table.rows.push_back(std::move(row.cells));
        return table.rows.size() < SourceTable::most_rows;
    });
    if (!scanned) return fail(scanned.error());
    if (table.rows.empty()) return fail(ErrorCode::bad_input, tell<"the file has no points">());
    auto columns = !choice.columns.empty() ? stated_point_columns(choice.columns)
                   : headers               ? point_columns_of_headers(table.rows.front())
                             : spatial_analyzer_columns(shape_of(table.rows.front(), format), choice.chosen);
    table.columns.resize(width);
    for (std::size_t i = 0; columns && i < std::min(width, columns->size()); ++i)
        table.columns[i] = word_of((*columns)[i]);
    for (auto& [key, title] : point_column_titles()) table.words.push_back({key, title});
    return table;
}

Result<SourceTable> table_with_headers(const std::string& text, const ReadChoice& choice) {
    return rows_of_points(text, choice, true);
}

Result<SourceTable> table_without_headers(const std::string& text, const ReadChoice& choice) {
    return rows_of_points(text, choice, false);
}

}  // namespace

Reader spatial_analyzer_reader() {
    return {
        .name = "spatialanalyzer",
        .title = "SpatialAnalyzer points (ASCII)",
        .pattern = "*.txt *.asc *.csv",
        .takes = "[collection] [group] point X Y Z [Ux Uy Uz], without headers -> an artefact for each group",
        .recognise = recognise_spatial_analyzer,
        .read = read_spatial_analyzer,
        .table = table_without_headers};
}

Reader point_table_reader() {
    return {.name = "points",
            .title = "Table of points",
            .pattern = "*.csv *.txt *.xyz",
            .takes =
                "columns with headers (name, group, x, y, z, u_x ...) or stated ones -> an artefact for each "
                "group",
            .recognise = recognise_table,
            .read = read_table,
            .table = table_with_headers};
}

}  // namespace covaria
