// Excel workbooks as they are written. This is the only file that knows libxlsxwriter.
#include "core/writers/xlsx_book.h"

#include <xlsxwriter.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <utility>

#include "core/base/c_numbers.h"
#include "core/base/file_io.h"
#include "core/base/utf8.h"
#include "core/readers/entry_texts.h"
#include "core/readers/workbook.h"

namespace covaria {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_sheet_name = 31, longest_cell = 8000;
constexpr time_t no_clock = 946684800;  // 2000-01-01: equal results give equal bytes

std::string lower_name(const std::string& text) {
    std::string lower = text;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

std::string first_characters(const std::string& text, std::size_t count) {
    std::size_t at = 0;
    for (std::size_t n = 0; at < text.size() && n < count; ++n) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
    }
    return text.substr(0, at);
}

}  // namespace

struct XlsxBook::Sheets {
    /// A folder of our own, which is removed with this object.
    class TemporaryFolder {
    public:
        TemporaryFolder() {
            std::error_code ignored;
            std::string name = (fs::temp_directory_path(ignored) / "covaria-xlsx-XXXXXX").string();
            if (mkdtemp(name.data())) path_ = name;
        }
        ~TemporaryFolder() {
            std::error_code ignored;
            if (!path_.empty()) fs::remove_all(path_, ignored);
        }
        TemporaryFolder(const TemporaryFolder&) = delete;
        TemporaryFolder& operator=(const TemporaryFolder&) = delete;
        const fs::path& path() const { return path_; }

    private:
        fs::path path_;
    };

    TemporaryFolder folder;
    std::string file, temporary;
    lxw_workbook* book = nullptr;
    lxw_worksheet* sheet = nullptr;
    std::string sheet_name;
    std::map<std::pair<Look, std::string>, lxw_format*> formats;
    ~Sheets() {
        if (book) workbook_close(book);
    }
    lxw_format* format_of(Look look, const std::string& number = {});
};

lxw_format* XlsxBook::Sheets::format_of(Look look, const std::string& number) {
    lxw_format*& format = formats[{look, number}];
    if (format) return format;
    format = workbook_add_format(book);
    if (!number.empty()) format_set_num_format(format, number.c_str());
    switch (look) {
        case Look::plain:
            break;
        case Look::after_number:
            format_set_indent(format, 1);
            break;
        case Look::head_of_numbers:
            format_set_align(format, LXW_ALIGN_RIGHT);
            [[fallthrough]];
        case Look::head:
            format_set_bold(format);
            format_set_bottom(format, LXW_BORDER_THIN);
            format_set_text_wrap(format);
            break;
        case Look::title:
            format_set_bold(format);
            format_set_font_size(format, 14);
            break;
        case Look::stated:
            format_set_font_color(format, 0x1F4E79);
            format_set_align(format, LXW_ALIGN_RIGHT);
            break;
        case Look::good:
            format_set_bg_color(format, 0xE2EFDA);
            format_set_bold(format);
            break;
    }
    return format;
}

XlsxBook::XlsxBook() : sheets_(std::make_unique<Sheets>()) {
    Sheets& s = *sheets_;
    if (s.folder.path().empty()) return;
    s.file = (s.folder.path() / "book.xlsx").string();
    s.temporary = s.folder.path().string();
    lxw_workbook_options options = {};
    options.tmpdir = s.temporary.data();
    s.book = workbook_new_opt(s.file.c_str(), &options);
    if (!s.book) return;
    lxw_doc_properties properties = {};
    properties.created = no_clock;
    workbook_set_properties(s.book, &properties);
}

XlsxBook::~XlsxBook() = default;

void XlsxBook::add_sheet(const std::string& wanted) {
    std::string plain = plain_name(wanted);
    for (char& c : plain)
        if (std::string_view("[]:*?/\\'").find(c) != std::string_view::npos) c = '_';
    if (plain.empty() || lower_name(plain) == "history") plain = "Sheet";
    std::string name = first_characters(plain, longest_sheet_name);
    for (int n = 2; !names_.insert(lower_name(name)).second; ++n) {
        const std::string number = " (" + std::to_string(n) + ")";
        name = first_characters(plain, longest_sheet_name - number.size()) + number;
    }
    if (sheets_->book) sheets_->sheet = workbook_add_worksheet(sheets_->book, name.c_str());
    if (!sheets_->sheet) return;
    sheets_->sheet_name = name;
    constexpr std::uint8_t a4 = 9;
    worksheet_set_paper(sheets_->sheet, a4);
    worksheet_set_landscape(sheets_->sheet);
    worksheet_set_margins(sheets_->sheet, 0.5, 0.5, 0.6, 0.6);
    worksheet_set_footer(sheets_->sheet, "&L&8&A&R&8&P / &N");
    worksheet_fit_to_pages(sheets_->sheet, 1, 0);  // a sheet is as wide as a page and as long as it is
}

void XlsxBook::set_width(int column, double characters) {
    if (!sheets_->sheet) return;
    const auto at = static_cast<lxw_col_t>(column - 1);
    worksheet_set_column(sheets_->sheet, at, at, characters, nullptr);
}

void XlsxBook::freeze_heads(int row, int column) {
    if (!sheets_->sheet) return;
    worksheet_freeze_panes(sheets_->sheet, static_cast<lxw_row_t>(row), static_cast<lxw_col_t>(column));
    worksheet_repeat_rows(sheets_->sheet, static_cast<lxw_row_t>(row - 1), static_cast<lxw_row_t>(row - 1));
}

void XlsxBook::name_cell(const std::string& name, int row, int column) {
    if (!sheets_->sheet) return;
    const std::string sheet = "'" + sheets_->sheet_name + "'!";
    const std::string cell = "=" + sheet + "$" + column_letters(column) + "$" + std::to_string(row);
    workbook_define_name(sheets_->book, (sheet + name).c_str(), cell.c_str());
}

void XlsxBook::bars(int row, int column, const std::string& title, int texts, int numbers, int first,
                    int last) {
    if (!sheets_->sheet) return;
    constexpr double bar_height = 20, around = 90, width = 620;  // pixels
    lxw_chart* chart = workbook_add_chart(sheets_->book, LXW_CHART_BAR);
    lxw_chart_series* series = chart_add_series(chart, nullptr, nullptr);
    const auto at = [](int place) { return static_cast<lxw_row_t>(place - 1); };
    const auto in = [](int place) { return static_cast<lxw_col_t>(place - 1); };
    const char* sheet = sheets_->sheet_name.c_str();
    chart_series_set_categories(series, sheet, at(first), in(texts), at(last), in(texts));
    chart_series_set_values(series, sheet, at(first), in(numbers), at(last), in(numbers));
    lxw_chart_fill orange = {.color = 0xD97F0C, .none = 0, .transparency = 0};
    chart_series_set_fill(series, &orange);
    chart_series_set_invert_if_negative(series);
    chart_title_set_name(chart, plain_line(title).c_str());
    lxw_chart_font small = {};
    small.size = 11;
    chart_title_set_name_font(chart, &small);
    chart_legend_set_position(chart, LXW_CHART_LEGEND_NONE);
    // Of bars, the library calls the upright axis y. The first line of the budget is the upper bar.
    chart_axis_set_reverse(chart->y_axis);
    chart_axis_set_label_position(chart->y_axis, LXW_CHART_AXIS_LABEL_POSITION_LOW);
    chart_axis_set_label_position(chart->x_axis, LXW_CHART_AXIS_LABEL_POSITION_HIGH);
    lxw_chart_options place = {};
    constexpr double usual_width = 480, usual_height = 288;  // pixels of a chart that is not scaled
    place.x_scale = width / usual_width;
    place.y_scale = (around + bar_height * (last - first + 1)) / usual_height;
    worksheet_insert_chart_opt(sheets_->sheet, at(row), in(column), chart, &place);
}

void XlsxBook::text(int row, int column, const std::string& words, Look look) {
    std::string plain = plain_line(words);
    plain.resize(valid_utf8(std::string_view(plain).substr(0, longest_cell)));
    if (!sheets_->sheet || plain.empty()) return;
    worksheet_write_string(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                           static_cast<lxw_col_t>(column - 1), plain.c_str(), sheets_->format_of(look));
}

void XlsxBook::number(int row, int column, double value, Look look, const std::string& format) {
    if (std::isnan(value)) return text(row, column, "undefined", look);
    if (std::isinf(value)) return text(row, column, "infinite", look);
    if (!sheets_->sheet) return;
    worksheet_write_number(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                           static_cast<lxw_col_t>(column - 1), value, sheets_->format_of(look, format));
}

void XlsxBook::formula(int row, int column, const std::string& formula, double value, Look look,
                       const std::string& format) {
    if (!std::isfinite(value)) return text_formula(row, column, formula, "infinite");
    if (!sheets_->sheet) return;
    worksheet_write_formula_num(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                                static_cast<lxw_col_t>(column - 1), formula.c_str(),
                                sheets_->format_of(look, format), value);
}

void XlsxBook::text_formula(int row, int column, const std::string& formula, const std::string& value) {
    if (!sheets_->sheet) return;
    worksheet_write_formula_str(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                                static_cast<lxw_col_t>(column - 1), formula.c_str(),
                                sheets_->format_of(Look::good), value.c_str());
}

Result<std::string> XlsxBook::finish() {
    const auto failed = [] {
        return fail(ErrorCode::io, tell<"the workbook cannot be made in the folder for temporary files">());
    };
    if (!sheets_->book) return failed();
    lxw_workbook* book = std::exchange(sheets_->book, nullptr);
    sheets_->sheet = nullptr;
    const CNumbers with_points;  // cells are written now, with points in their numbers
    if (workbook_close(book) != LXW_NO_ERROR) return failed();
    return read_file(sheets_->file);
}

std::string cell_name(int row, int column) {
    return column_letters(column) + std::to_string(row);
}

}  // namespace covaria
