#include "app/value_rows.h"

#include <algorithm>

#include "core/base/file_io.h"
#include "core/project/csv_reader.h"

namespace covaria {
namespace {

bool gives_values(const std::string& head) {
    return head.starts_with('/');
}

Error at_line(const std::filesystem::path& file, int line, const Message& message) {
    return {ErrorCode::bad_input, message, {}, file.string(), line};
}

ValueRow row_of(const CsvRow& row, std::size_t number, const std::vector<std::string>& heads,
                std::size_t name_column) {
    ValueRow made{row.cells[name_column], number, row.line, {}};
    for (std::size_t column = 0; column < heads.size(); ++column)
        if (gives_values(heads[column]) && !row.cells[column].empty())
            made.values.push_back(heads[column] + "=" + row.cells[column]);
    return made;
}

}  // namespace

Result<std::vector<ValueRow>> read_value_rows(const std::filesystem::path& file) {
    const auto text = read_file(file);
    if (!text) return fail(text.error());
    auto csv = read_csv(*text);
    if (!csv) return fail(at_line(file, csv.error().line, csv.error().message));
    if (csv->rows.size() < 2) return fail(at_line(file, 1, "a head and at least one row are needed"));
    const std::vector<std::string> heads = csv->rows.front().cells;
    const auto name = std::find_if_not(heads.begin(), heads.end(), gives_values);
    if (name == heads.end() || std::none_of(heads.begin(), heads.end(), gives_values))
        return fail(
            at_line(file, csv->rows.front().line,
                    "one column must name the rows (serial number), the others be places in the project "
                    "(/assets/0/setup/temperature)"));
    std::vector<ValueRow> rows;
    for (std::size_t i = 1; i < csv->rows.size(); ++i) {
        CsvRow& row = csv->rows[i];
        if (row.cells.size() > heads.size())
            return fail(at_line(file, row.line, "the row has more cells than the head"));
        row.cells.resize(heads.size());
        rows.push_back(row_of(row, i, heads, static_cast<std::size_t>(name - heads.begin())));
    }
    return rows;
}

}  // namespace covaria
