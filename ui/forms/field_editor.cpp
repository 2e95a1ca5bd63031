// The list of editors, one per kind of field.
#include "ui/forms/field_editor.h"

#include "ui/document/quantity_text.h"
#include "ui/forms/file_editor.h"
#include "ui/forms/lines_editor.h"
#include "ui/forms/pose_editor.h"
#include "ui/forms/simple_editors.h"
#include "ui/forms/table_editor.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void FieldEditor::focus_part(const std::string&) {
    setFocus(Qt::OtherFocusReason);
}

FieldEditor* make_field_editor(const FieldSpec& field, const FieldContext& context, QWidget* parent) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::integer:
            return new NumberEditor(field, context, parent);
        case FieldKind::choice:
            return new ListEditor(field, parent);
        case FieldKind::text:
            if (!field.file_ending.empty()) {
                const QString ending = to_qt(field.file_ending);
                const QString filter = FieldEditor::tr("%1 files").arg(ending.toUpper());
                return new FileEditor(field, context.document,
                                      QStringLiteral("%1 (*.%2 *.%3)").arg(filter, ending, ending.toUpper()),
                                      parent);
            }
            if (field.several_lines) return new LinesEditor(field, context, parent);
            return new TextEditor(field, parent);
        case FieldKind::flag:
            return new FlagEditor(field, parent);
        case FieldKind::pose:
            return new PoseEditor(field, context, parent);
        case FieldKind::table:
            return new TableEditor(field, context, parent);
        case FieldKind::reference:
            return new ReferenceEditor(field, context, parent);
    }
    return nullptr;
}

QString help_text(const FieldSpec& field) {
    QString text = core_text(field.help);
    const auto limit = [&](double si) {
        return quantity_text({QString::number(field.unit.from_si(si), 'g', 12).toDouble(), field.unit},
                             QLocale());
    };
    const bool low = field.range.low != -Range::infinity_value;
    const bool high = field.range.high != Range::infinity_value;
    if (low && high)
        text += ' ' + FieldEditor::tr("From %1 to %2.").arg(limit(field.range.low), limit(field.range.high));
    else if (low)
        text +=
            ' ' + (field.range.low_open ? FieldEditor::tr("More than %1.") : FieldEditor::tr("At least %1."))
                      .arg(limit(field.range.low));
    else if (high)
        text += ' ' + FieldEditor::tr("At most %1.").arg(limit(field.range.high));
    return text;
}

}  // namespace covaria::ui
