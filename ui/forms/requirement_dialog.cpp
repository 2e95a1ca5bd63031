#include "ui/forms/requirement_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <string_view>

#include "core/text/symbol.h"
#include "ui/document/requirement_edits.h"
#include "ui/forms/finish_typing.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/quantity_edit.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t most_named = 8;

/// "x, y, z (pose 7) ...": of which results.
QString names_of(const std::vector<OutputQuantity>& outputs) {
    QStringList names;
    for (std::size_t i = 0; i < outputs.size() && i < most_named; ++i) {
        QString name = to_qt(symbol_to_unicode(outputs[i].symbol));
        if (!outputs[i].group.empty())
            name += QStringLiteral(" (%1)").arg(to_qt(said_name(outputs[i].group)));
        names << name;
    }
    if (outputs.size() > most_named) names << QStringLiteral("… (%1)").arg(outputs.size());
    return names.join(QStringLiteral(", "));
}

/// Marks an edit with what is wrong with it, and goes there; whether nothing is.
bool is_fine(QuantityEdit& edit, const QString& complaint) {
    edit.set_complaint(complaint);
    if (!complaint.isEmpty()) edit.setFocus();
    return complaint.isEmpty();
}

}  // namespace

RequirementDialog::RequirementDialog(const std::vector<OutputQuantity>& outputs, const Requirement* now,
                                     const DisplayUnits& units, std::size_t left_out, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Requirements for Results"));
    auto* words = new QLabel(names_of(outputs));
    if (left_out > 0)
        words->setText(words->text() + QLatin1Char('\n') +
                       tr("Left out, for their unit is another: %1.").arg(left_out));
    words->setWordWrap(true);
    auto* form = new QFormLayout;
    const Unit unit = outputs.empty() ? Unit() : units.of(outputs.front().unit);
    rows_.reserve(requirement_fields().size());  // connections below keep addresses of rows
    constexpr std::array<std::string_view, 3> wanted{"targetUncertainty", "lowerLimit", "upperLimit"};
    for (const RequirementField& field : requirement_fields()) {
        if (std::ranges::count(wanted, field.key) == 0) continue;
        auto* edit = new QuantityEdit;
        edit->setObjectName(QLatin1String(field.key));
        const QString title = core_text(field.title);
        edit->setAccessibleName(title);
        edit->set_help(core_text(field.help));
        edit->set_unit(field.is_interval ? unit.interval() : unit);
        edit->set_quantity(value_of(now ? *now : Requirement{}, field));
        keep_letters(*edit);
        form->addRow(title, edit);
        rows_.push_back({field, edit});
        connect(edit, &QuantityEdit::quantity_edited, this, [row = &rows_.back()] { row->is_typed = true; });
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    auto* column = new QVBoxLayout(this);
    column->addWidget(words);
    column->addLayout(form);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        finish_typing();
        for (const Row& row : rows_)
            if (!row.edit->is_valid()) return row.edit->setFocus();
        if (!is_target_positive() || !are_limits_in_order()) return;
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QuantityEdit& RequirementDialog::edit_of(std::string_view key) {
    return *std::ranges::find(rows_, key, [](const Row& row) {
                return std::string_view(row.field.key);
            })->edit;
}

bool RequirementDialog::is_target_positive() {
    QuantityEdit& target = edit_of("targetUncertainty");
    return is_fine(target, complaint_of_target(target.quantity()));
}

bool RequirementDialog::are_limits_in_order() {
    QuantityEdit& upper = edit_of("upperLimit");
    return is_fine(upper, complaint_of_limits(edit_of("lowerLimit").quantity(), upper.quantity()));
}

void RequirementDialog::apply_to(Requirement& requirement) const {
    for (const Row& row : rows_)
        if (row.is_typed) set_value(requirement, row.field, row.edit->quantity());
}

void ask_what_is_required(Document& document, const std::string& analysis,
                          std::vector<OutputQuantity> outputs, const DisplayUnits& units, QWidget* parent) {
    if (outputs.empty()) return;
    const auto dimension = outputs.front().unit.dimension();
    const std::size_t left_out =
        std::erase_if(outputs, [&](const OutputQuantity& o) { return o.unit.dimension() != dimension; });
    const AnalysisEntry* entry = document.project().find_analysis(analysis);
    if (!entry) return;
    const Requirement* now = find_requirement(*entry, outputs.front());
    RequirementDialog dialog(outputs, now, units, left_out, parent);
    if (dialog.exec() != QDialog::Accepted) return;
    change_requirements(document, analysis, outputs,
                        [&dialog](Requirement& requirement) { dialog.apply_to(requirement); });
}

}  // namespace covaria::ui
