#include "core/readers/workbook.h"

#include <algorithm>
#include <cctype>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"
#include "core/readers/zip_parts.h"

namespace covaria {

namespace {

constexpr std::size_t largest_workbook = 16'000'000;  // bytes of XML, unpacked
constexpr std::size_t most_cells = 200'000;
constexpr int last_row = 1'048'576, last_column = 16'384;

/// The texts of a rich or plain string: <t> itself or in runs <r>; phonetic hints (<rPh>) are none of it.
std::string string_of(const pugi::xml_node& node) {
    std::string text;
    for (const pugi::xml_node& child : node.children()) {
        if (local_name(child) == "t") text += child.child_value();
        if (local_name(child) == "r") text += child_called(child, "t").child_value();
    }
    return text;
}

/// The path of a part: "worksheets/sheet1.xml" beside "xl/workbook.xml"; a path from the root loses only its
/// '/'.
std::string part_name(const std::string& target) {
    return target.starts_with('/') ? target.substr(1) : "xl/" + target;
}

class WorkbookReader {
public:
    explicit WorkbookReader(ZipParts parts) : parts_(std::move(parts)) {}

    Result<std::vector<WorkbookSheet>> read() {
        if (!parts_.has("xl/workbook.xml"))
            return fail(ErrorCode::bad_input, tell<"the file has no Excel workbook in it">());
        if (auto done = read_strings(); !done) return fail(done.error());
        auto targets = read_targets();
        if (!targets) return fail(targets.error());
        const auto workbook = parse("xl/workbook.xml");
        if (!workbook) return fail(workbook.error());
        std::vector<WorkbookSheet> sheets;
        for (const pugi::xml_node& sheet : child_called(workbook->root(), "sheets").children()) {
            if (local_name(sheet) != "sheet") continue;
            std::string id;
            for (const pugi::xml_attribute& attribute : sheet.attributes())
                if (std::string_view(attribute.name()).ends_with(":id")) id = attribute.value();
            const auto target = targets->find(id);
            if (target == targets->end()) continue;
            auto read = read_sheet(plain_name(sheet.attribute("name").value()), part_name(target->second));
            if (!read) return fail(read.error());
            if (!read->rows.empty()) sheets.push_back(std::move(*read));
        }
        if (sheets.empty()) return fail(ErrorCode::bad_input, tell<"the file has no sheet with cells">());
        return sheets;
    }

private:
    /// The XML of a part. Errors name the part beside their line in it.
    Result<XmlText> parse(const std::string& name) {
        const auto text = parts_.read(name);
        if (!text) return fail(text.error());
        auto xml = XmlText::parse(*text);
        if (!xml) {
            Error error = xml.error();
            error.message = plain_name(name) + ": " + error.message;
            return fail(std::move(error));
        }
        return xml;
    }

    Result<void> read_strings() {
        if (!parts_.has("xl/sharedStrings.xml")) return {};
        const auto xml = parse("xl/sharedStrings.xml");
        if (!xml) return fail(xml.error());
        for (const pugi::xml_node& item : xml->root().children())
            if (local_name(item) == "si") strings_.push_back(string_of(item));
        return {};
    }

    Result<std::map<std::string, std::string>> read_targets() {
        const auto xml = parse("xl/_rels/workbook.xml.rels");
        if (!xml) return fail(xml.error());
        std::map<std::string, std::string> targets;
        for (const pugi::xml_node& relation : xml->root().children())
            if (std::string_view(relation.attribute("Type").value()).ends_with("/worksheet") &&
                std::string_view(relation.attribute("TargetMode").value()) != "External")
                targets[relation.attribute("Id").value()] = relation.attribute("Target").value();
        return targets;
    }

    Result<WorkbookSheet> read_sheet(const std::string& name, const std::string& part) {
        const auto xml = parse(part);
        if (!xml) return fail(xml.error());
        WorkbookSheet sheet{.name = name};
        CellPlace next{0, 1};
        for (const pugi::xml_node& row : child_called(xml->root(), "sheetData").children()) {
            if (local_name(row) != "row") continue;
            next = {next.row + 1, 1};
            if (const auto number = row.attribute("r")) next.row = number.as_int(next.row);
            for (const pugi::xml_node& cell : row.children()) {
                if (local_name(cell) != "c") continue;
                if (const auto reference = cell.attribute("r")) {
                    const auto place = place_of_cell(reference.value());
                    if (!place)
                        return xml->refused(cell,
                                            tell<"%1: %2 is no place of a cell">(
                                                plain_name(part), in_quotes(plain_name(reference.value()))));
                    next = *place;
                }
                if (auto done = add_cell(*xml, sheet, cell, next); !done) return fail(done.error());
                ++next.column;
            }
        }
        return sheet;
    }

    Result<void> add_cell(const XmlText& xml, WorkbookSheet& sheet, const pugi::xml_node& node,
                          const CellPlace& place) {
        if (++cells_ > most_cells)
            return xml.refused(node, tell<"%1: more than %2 cells are not read">(sheet.name, most_cells));
        const std::string_view type = node.attribute("t").value();
        const pugi::xml_node value = child_called(node, "v");
        WorkbookCell cell;
        cell.text = type == "inlineStr" ? string_of(child_called(node, "is")) : value.child_value();
        if (type == "s") {
            const auto index = number_in_text(cell.text);
            if (!index || !(*index >= 0.0) || !(*index < static_cast<double>(strings_.size())))
                return sheet.refused(place.row, place.column, tell<"its text is missing from the file">());
            cell.text = strings_[static_cast<std::size_t>(*index)];
        } else if (type.empty() || type == "n") {
            cell.number = number_in_text(cell.text);
        } else if (type == "e") {
            cell.failure = "the error " + plain_name(cell.text) + " of the spreadsheet";
        }
        cell.text = plain_name(cell.text);
        if (cell.text.empty() && child_called(node, "f"))
            cell.failure =
                "a formula that was never computed: open and save the file in a spreadsheet program";
        if (!cell.text.empty() || !cell.failure.empty())
            sheet.rows[place.row][place.column] = std::move(cell);
        return {};
    }

    ZipParts parts_;
    std::vector<std::string> strings_;
    std::size_t cells_ = 0;
};

}  // namespace

const WorkbookCell* WorkbookSheet::cell(int row, int column) const {
    const auto r = rows.find(row);
    if (r == rows.end()) return nullptr;
    const auto c = r->second.find(column);
    return c == r->second.end() ? nullptr : &c->second;
}

int WorkbookSheet::first_column() const {
    int first = 0;
    for (const auto& [row, cells] : rows)
        first = first == 0 ? cells.begin()->first : std::min(first, cells.begin()->first);
    return first;
}

void WorkbookSheet::set_cell(int row, int column, const std::string& text) {
    if (WorkbookCell cell{plain_name(text), number_in_text(text), {}}; !cell.text.empty()) {
        rows[row][column] = std::move(cell);
        return;
    }
    const auto found = rows.find(row);
    if (found == rows.end()) return;
    found->second.erase(column);
    if (found->second.empty()) rows.erase(found);
}

std::string WorkbookSheet::place(int row, int column) const {
    return name + "!" + column_letters(column) + std::to_string(row);
}

tl::unexpected<Error> WorkbookSheet::refused(int row, int column, const Message& message) const {
    return fail(Error{ErrorCode::bad_input, place(row, column) + ": " + message, {}, {}, row});
}

std::optional<CellPlace> place_of_cell(std::string_view reference) {
    CellPlace place;
    std::size_t at = 0;
    for (;
         at < reference.size() && reference[at] >= 'A' && reference[at] <= 'Z' && place.column <= last_column;
         ++at)
        place.column = place.column * 26 + (reference[at] - 'A' + 1);
    for (; at < reference.size() && std::isdigit(static_cast<unsigned char>(reference[at])) &&
           place.row <= last_row;
         ++at)
        place.row = place.row * 10 + (reference[at] - '0');
    const bool good = at == reference.size() && place.row >= 1 && place.row <= last_row &&
                      place.column >= 1 && place.column <= last_column;
    return good ? std::optional<CellPlace>(place) : std::nullopt;
}

std::string column_letters(int column) {
    std::string letters;
    for (int n = column; n > 0; n = (n - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (n - 1) % 26));
    return letters;
}

Result<std::vector<WorkbookSheet>> read_workbook(const std::string& bytes) {
    if (bytes.starts_with("\xD0\xCF\x11\xE0"))
        return fail(
            ErrorCode::bad_input,
            tell<"the file has a password or the old format .xls: save it as .xlsx without a password">());
    auto parts = ZipParts::open(bytes, largest_workbook);
    if (!parts) return fail(parts.error());
    return WorkbookReader(std::move(*parts)).read();
}

}  // namespace covaria
