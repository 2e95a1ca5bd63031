#include "ui/models/stated_part.h"

#include <QLocale>

#include "core/quantity/statement.h"
#include "ui/document/quantity_text.h"
#include "ui/document/setup_cells.h"
#include "ui/models/setup_table_model.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

Unit unit_in(const FieldSpec& table, const std::vector<SetupCell>& row, const char* key,
             const Unit& or_else) {
    const std::string* text = cell_in<std::string>(table, row, key);
    return text && !text->empty() ? Unit::parse(*text).value_or(or_else) : or_else;
}

/// Empty: the row has no such figure.
QString stated_part_words(const FieldSpec& table, const std::vector<SetupCell>& row) {
    const std::string* key = cell_in<std::string>(table, row, "statement");
    const StatementKind* kind = key ? find_statement(*key) : nullptr;
    const double* figure = cell_in<double>(table, row, "a");
    if (!figure || !kind || !kind->a_has_unit || kind->key == "limits") return {};  // limits are values
    const Unit of_quantity = unit_in(table, row, "unit", Unit());
    const Unit stated = unit_in(table, row, "stated_unit", of_quantity);
    if (!stated.dimension().is_one() || stated == Unit()) return {};
    const QString words = quantity_text({*figure, stated}, QLocale());
    return (is_part_of_estimate(stated, of_quantity)
                ? SetupTableModel::tr("%1 of the value")
                : SetupTableModel::tr("%1 absolute, not a part of the value"))
        .arg(words);
}

}  // namespace

QString below_stated_part(const FieldSpec& table, const std::vector<SetupCell>& row, const QString& words) {
    const QString part = stated_part_words(table, row);
    return part.isEmpty() ? words : part + QStringLiteral("\n\n") + words;
}

}  // namespace covaria::ui
