// Excel workbooks as they are written. This is the only file that knows libxlsxwriter.
#include "core/writers/xlsx_book.h"

#include <xlsxwriter.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
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
    std::array<lxw_format*, 5> looks{};
    ~Sheets() {
        if (book) workbook_close(book);
    }
};

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
    for (lxw_format*& look : s.looks) look = workbook_add_format(s.book);
    format_set_bold(s.looks[static_cast<std::size_t>(Look::head)]);
    format_set_bottom(s.looks[static_cast<std::size_t>(Look::head)], LXW_BORDER_THIN);
    format_set_text_wrap(s.looks[static_cast<std::size_t>(Look::head)]);
    format_set_bold(s.looks[static_cast<std::size_t>(Look::title)]);
    format_set_font_size(s.looks[static_cast<std::size_t>(Look::title)], 14);
    format_set_font_color(s.looks[static_cast<std::size_t>(Look::stated)], 0x1F4E79);
    format_set_bg_color(s.looks[static_cast<std::size_t>(Look::good)], 0xE2EFDA);
    format_set_bold(s.looks[static_cast<std::size_t>(Look::good)]);
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
    worksheet_set_landscape(sheets_->sheet);
    worksheet_fit_to_pages(sheets_->sheet, 1, 0);  // a sheet is as wide as a page and as long as it is
}

void XlsxBook::set_width(int column, double characters) {
    if (!sheets_->sheet) return;
    const auto at = static_cast<lxw_col_t>(column - 1);
    worksheet_set_column(sheets_->sheet, at, at, characters, nullptr);
}

void XlsxBook::text(int row, int column, const std::string& words, Look look) {
    std::string plain = plain_line(words);
    plain.resize(valid_utf8(std::string_view(plain).substr(0, longest_cell)));
    if (!sheets_->sheet || plain.empty()) return;
    worksheet_write_string(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                           static_cast<lxw_col_t>(column - 1), plain.c_str(),
                           sheets_->looks[static_cast<std::size_t>(look)]);
}

void XlsxBook::number(int row, int column, double value, Look look) {
    if (std::isnan(value)) return text(row, column, "undefined", look);
    if (std::isinf(value)) return text(row, column, "infinite", look);
    if (!sheets_->sheet) return;
    worksheet_write_number(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                           static_cast<lxw_col_t>(column - 1), value,
                           sheets_->looks[static_cast<std::size_t>(look)]);
}

void XlsxBook::formula(int row, int column, const std::string& formula, double value, Look look) {
    if (!std::isfinite(value)) return text_formula(row, column, formula, "infinite");
    if (!sheets_->sheet) return;
    worksheet_write_formula_num(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                                static_cast<lxw_col_t>(column - 1), formula.c_str(),
                                sheets_->looks[static_cast<std::size_t>(look)], value);
}

void XlsxBook::text_formula(int row, int column, const std::string& formula, const std::string& value) {
    if (!sheets_->sheet) return;
    worksheet_write_formula_str(sheets_->sheet, static_cast<lxw_row_t>(row - 1),
                                static_cast<lxw_col_t>(column - 1), formula.c_str(),
                                sheets_->looks[static_cast<std::size_t>(Look::good)], value.c_str());
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
