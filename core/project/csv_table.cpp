#include "core/project/csv_table.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/counted_problems.h"
#include "core/base/file_io.h"
#include "core/project/table_columns.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

Problem problem_at(int line, Message message) {
    return {Severity::error, {}, std::move(message), {}, line};
}

std::optional<bool> csv_flag(const std::string& text) {
    static const std::array<std::string, 3> yes{"true", "yes", "1"}, no{"false", "no", "0"};
    if (std::find(yes.begin(), yes.end(), text) != yes.end()) return true;
    if (std::find(no.begin(), no.end(), text) != no.end()) return false;
    return std::nullopt;
}

// A choice may be written by its title; check_setup judges what is neither key nor title.
std::string choice_key(const ColumnSpec& column, const std::string& text) {
    for (const Choice& choice : column.choices)
        if (choice.title == text) return choice.key;
    return text;
}

class RowsReader {
public:
    /// `decimal_comma` says that numbers may have one, because another character separates the cells.
    RowsReader(bool decimal_comma, const FieldSpec& field, std::vector<std::size_t> target, CsvTable& out)
        : decimal_comma_(decimal_comma), field_(field), target_(std::move(target)), out_(out) {}

    void read_row(const CsvRow& row) {
        if (row.cells.size() != target_.size() && !only_empty_beyond(row))
            report(row.line,
                   tell<"this row has %1 cells; there are %2 columns">(row.cells.size(), target_.size()));
        std::vector<SetupCell> cells(field_.columns.size());
        for (std::size_t i = 0; i < std::min(row.cells.size(), target_.size()); ++i)
            if (target_[i] != SetupSchema::npos)
                cells[target_[i]] = read_cell(field_.columns[target_[i]], row.cells[i], row.line);
        out_.table.rows.push_back(std::move(cells));
        out_.lines.push_back(row.line);
    }

private:
    // Spreadsheets put separators behind the last cell.
    bool only_empty_beyond(const CsvRow& row) const {
        const auto begin =
            row.cells.begin() + static_cast<std::ptrdiff_t>(std::min(row.cells.size(), target_.size()));
        return row.cells.size() > target_.size() &&
               std::all_of(begin, row.cells.end(), [](const std::string& cell) { return cell.empty(); });
    }

    SetupCell read_cell(const ColumnSpec& column, const std::string& text, int line) {
        if (text.empty()) return {};
        if (column.kind == FieldKind::number || column.kind == FieldKind::integer) {
            if (const auto number = csv_number(text, decimal_comma_)) return *number;
            report(line, not_a_number(column, text));
            return {};
        }
        if (column.kind == FieldKind::flag) {
            if (const auto flag = csv_flag(text)) return *flag;
            report(line, tell<"column '%1': '%2' is neither true nor false">(column.key, text));
            return {};
        }
        return column.kind == FieldKind::choice ? choice_key(column, text) : text;
    }

    Message not_a_number(const ColumnSpec& column, const std::string& text) const {
        const Message words = tell<"column '%1': '%2' is not a number">(column.key, text);
        if (!csv_number(text, !decimal_comma_)) return words;
        std::string right = text;
        std::replace(right.begin(), right.end(), decimal_comma_ ? '.' : ',', decimal_comma_ ? ',' : '.');
        return tell<"%1; in this file write %2">(words, right);
    }

    // The last message counts the rest, so that a file of wrong cells does not become a memory of messages.
    void report(int line, Message message) {
        if (++reported_ < most_of_a_kind)
            out_.problems.add(problem_at(line, std::move(message)));
        else if (reported_ == most_of_a_kind)
            out_.problems.add(problem_at(line, counted_words(1)));
        else
            out_.problems.items().back().message = counted_words(reported_ - most_of_a_kind + 1);
    }

    bool decimal_comma_;
    const FieldSpec& field_;
    std::vector<std::size_t> target_;
    CsvTable& out_;
    std::size_t reported_ = 0;
};

/// The headers, with those of `renamed` replaced and those that are not read left out; `read` says which ones
/// remain.
std::vector<std::string> renamed_headers(const std::vector<std::string>& headers, const CsvColumns& renamed,
                                         std::vector<std::size_t>& read, Problems& problems) {
    for (const auto& [header, column] : renamed)
        if (std::find(headers.begin(), headers.end(), header) == headers.end())
            problems.error({}, tell<"the file has no column '%1'%2; its columns are %3">(
                                   header, did_you_mean(header, headers), listed(headers)));
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < headers.size(); ++i) {
        const auto found = std::find_if(renamed.begin(), renamed.end(),
                                        [&](const auto& pair) { return pair.first == headers[i]; });
        if (found != renamed.end() && found->second.empty()) continue;
        kept.push_back(found == renamed.end() ? headers[i] : found->second);
        read.push_back(i);
    }
    return kept;
}

std::size_t lines_in(std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

/// Cells of a row without the empty ones at its end: separators behind the last header are no columns.
std::vector<std::string> headers_in(const CsvRow& row) {
    std::vector<std::string> headers = row.cells;
    while (!headers.empty() && headers.back().empty()) headers.pop_back();
    return headers;
}

/// The reader of a table, which takes the head, then row by row.
class TableReader {
public:
    /// `expected` is the number of rows that room is made for.
    TableReader(const FieldSpec& field, const CsvColumns& renamed, std::size_t expected)
        : field_(field), renamed_(renamed), expected_(expected) {}

    /// Takes a row; false where the head cannot be read.
    bool take(const CsvRow& row, bool decimal_comma) {
        if (!head_read_)
            read_head(row, decimal_comma);
        else
            rows_->read_row(row);
        return rows_.has_value();
    }
    CsvTable finish() {
        if (!head_read_)
            out_.problems.add(problem_at(1, tell<"there is no row with the names of the columns">()));
        return std::move(out_);
    }

private:
    void read_head(const CsvRow& row, bool decimal_comma) {
        head_read_ = true;
        Problems found;
        std::vector<std::size_t> read;  // indices of the columns of the file
        const std::vector<std::string> all = headers_in(row);
        const auto columns = match_columns(field_, renamed_headers(all, renamed_, read, found), found);
        for (std::size_t i = 0; columns && i < field_.columns.size(); ++i)  // the head is in the file
            if (const ColumnSpec& column = field_.columns[i]; column.kind == FieldKind::number)
                if (const Message objection = column_unit_objection(field_, column, columns->units[i]);
                    !objection.empty())
                    found.error({}, objection);
        for (const Problem& problem : found.items()) out_.problems.add(problem_at(row.line, problem.message));
        if (!columns || found.has_errors()) return;
        out_.table.units = columns->units;
        out_.table.rows.reserve(expected_);
        out_.lines.reserve(expected_);
        std::vector<std::size_t> target(all.size(), SetupSchema::npos);
        for (std::size_t i = 0; i < read.size(); ++i) target[read[i]] = columns->target[i];
        rows_.emplace(decimal_comma, field_, std::move(target), out_);
    }

    const FieldSpec& field_;
    const CsvColumns& renamed_;
    std::size_t expected_;
    CsvTable out_;
    bool head_read_ = false;
    std::optional<RowsReader> rows_;  // there once a head could be read
};

}  // namespace

std::vector<std::string> headers_of(const CsvText& csv) {
    return headers_in(csv.rows.front());
}

CsvTable table_from_csv(const CsvText& csv, const FieldSpec& field, const CsvColumns& renamed) {
    TableReader reader(field, renamed, csv.rows.size());
    for (const CsvRow& row : csv.rows)
        if (!reader.take(row, csv.separator != ',')) break;
    return reader.finish();
}

CsvTable table_from_csv_rows(const CsvText& csv, const FieldSpec& field, const std::vector<Unit>& units) {
    CsvTable out;
    out.table.units = units;
    std::vector<std::size_t> target;
    const std::size_t given = csv.rows.empty() ? 0 : csv.rows.front().cells.size();
    for (std::size_t i = 0; i < std::min(given, field.columns.size()); ++i) target.push_back(i);
    RowsReader reader(csv.separator != ',', field, target, out);
    for (const CsvRow& row : csv.rows) reader.read_row(row);
    return out;
}

bool has_header(const CsvText& csv, const FieldSpec& field) {
    if (csv.rows.empty()) return false;
    const auto& cells = csv.rows.front().cells;
    return std::any_of(cells.begin(), cells.end(), [&](const std::string& cell) {
        return find_table_column(field, header_name(cell)) != SetupSchema::npos;
    });
}

Message too_many_rows(const FieldSpec& field, std::string_view text) {
    constexpr std::size_t block = 16;  // bytes that the heap keeps of each row
    const std::size_t row =
        field.columns.size() * sizeof(SetupCell) + sizeof(std::vector<SetupCell>) + block + sizeof(int);
    const std::size_t lines = lines_in(text), needed = lines * row + text.size();
    if (needed <= largest_table) return {};
    const double most = static_cast<double>(lines) * largest_table / static_cast<double>(needed);
    return tell<
        "it has %1 lines, and there is memory for about %2 of these rows: leave rows out, or take means "
        "of several">(lines, static_cast<std::size_t>(most));
}

CsvTable table_from_csv_file(const std::filesystem::path& file, const FieldSpec& field,
                             const CsvColumns& renamed) {
    CsvTable out;
    const Result<std::string> text = read_file(file);
    if (!text) {
        out.problems.add({Severity::error, {}, text.error().message, file.string(), 0});
        return out;
    }
    if (const Message refused = too_many_rows(field, *text); !refused.empty()) {
        out.problems.add({Severity::error, {}, refused, file.string(), 1});
        return out;
    }
    TableReader reader(field, renamed, lines_in(*text));
    const char separator = csv_separator(*text);
    const auto scanned =
        scan_csv(*text, separator, [&](CsvRow&& row) { return reader.take(row, separator != ','); });
    out = scanned ? reader.finish() : CsvTable{};
    if (!scanned) out.problems.add(problem_at(scanned.error().line, scanned.error().message));
    for (Problem& problem : out.problems.items()) problem.file = file.string();
    return out;
}

}  // namespace covaria
