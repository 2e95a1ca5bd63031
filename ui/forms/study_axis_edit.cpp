#include "ui/forms/study_axis_edit.h"

#include <QFormLayout>
#include <QLabel>
#include <cmath>
#include <limits>

#include "ui/document/quantity_text.h"
#include "ui/forms/form_labels.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

StudyAxisEdit::StudyAxisEdit(Choices choices, Use use, std::size_t number, QWidget* parent)
    : QGroupBox((use == Use::axis ? tr("Axis %1") : tr("Variable %1")).arg(number + 1), parent),
      target_(new TargetBox(std::move(choices), this)),
      change_(new QComboBox(this)),
      from_(new QuantityEdit(this)),
      to_(new QuantityEdit(this)),
      values_(new QuantityEdit(this)),
      spacing_(new QComboBox(this)),
      tolerance_(new QuantityEdit(this)),
      remove_(new QPushButton(use == Use::axis ? tr("Remove Axis") : tr("Remove Variable"), this)),
      use_(use),
      title_(title()) {
    const QString name =
        (use == Use::axis ? QStringLiteral("axis_%1_") : QStringLiteral("variable_%1_")).arg(number);
    target_->setObjectName(name + QStringLiteral("target"));
    change_->setObjectName(name + QStringLiteral("change"));
    from_->setObjectName(name + QStringLiteral("from"));
    to_->setObjectName(name + QStringLiteral("to"));
    values_->setObjectName(name + QStringLiteral("values"));
    spacing_->setObjectName(name + QStringLiteral("spacing"));
    tolerance_->setObjectName(name + QStringLiteral("tolerance"));
    remove_->setObjectName(name + QStringLiteral("remove"));
    build();
}

void StudyAxisEdit::build() {
    for (QComboBox* box : {change_, spacing_}) may_be_narrow(*box);
    change_->addItem(tr("takes these values"), int(StudyChange::value));
    change_->addItem(tr("is multiplied with"), int(StudyChange::factor));
    change_->addItem(tr("has added to it"), int(StudyChange::added));
    spacing_->addItem(tr("evenly spaced"), int(StudySpacing::linear));
    spacing_->addItem(tr("logarithmically spaced"), int(StudySpacing::logarithmic));
    from_->setAccessibleName(tr("From"));
    to_->setAccessibleName(tr("To"));
    values_->setAccessibleName(tr("Number of values"));
    values_->set_integer(true);
    values_->set_range({2.0, 100000.0});
    tolerance_->setAccessibleName(tr("Tolerance"));
    tolerance_->set_keeps_unit(false);
    tolerance_->set_interval(true);
    tolerance_->set_range({0.0, std::numeric_limits<double>::infinity()});
    tolerance_->set_help(tr("It can be put into effect only so well: what counts is the worst within it"));
    for (QuantityEdit* edit : {from_, to_, values_, tolerance_}) edit->set_optional(false);
    for (QuantityEdit* edit : {from_, to_, values_, tolerance_}) keep_letters(*edit);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Varied"), target_);
    form->addRow(tr("It"), change_);
    form->addRow(tr("From"), from_);
    form->addRow(tr("To"), to_);
    if (use_ == Use::axis) {
        form->addRow(tr("Values"), values_);
        form->addRow(QString(), spacing_);
    } else {
        form->addRow(tr("Tolerance"), tolerance_);
    }
    for (QWidget* other :
         {static_cast<QWidget*>(values_), static_cast<QWidget*>(spacing_), static_cast<QWidget*>(tolerance_)})
        other->setVisible(form->indexOf(other) >= 0);
    form->addRow(QString(), remove_);
    connect_parts();
}

void StudyAxisEdit::connect_parts() {
    connect(target_, &TargetBox::chosen, this, [this](const StudyAxis& chosen) {
        emit edited(
            [chosen](StudyAxis& axis) {
                const std::size_t values = axis.values;
                axis = chosen;
                axis.values = std::min(values, chosen.values < 11 ? chosen.values : values);
            },
            {});
    });
    connect(change_, &QComboBox::activated, this, [this](int row) {
        const auto change = static_cast<StudyChange>(change_->itemData(row).toInt());
        emit edited(
            [change](StudyAxis& axis) {
                if (axis.change == change) return;
                axis.change = change;
                if (change == StudyChange::factor) {
                    axis.unit = {};
                    axis.from = 0.5;
                    axis.to = 2.0;
                }
            },
            {});
    });
    connect(spacing_, &QComboBox::activated, this, [this](int row) {
        const auto spacing = static_cast<StudySpacing>(spacing_->itemData(row).toInt());
        emit edited([spacing](StudyAxis& axis) { axis.spacing = spacing; }, {});
    });
    connect(from_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        take_end(true, quantity.value_or(Quantity{}));
    });
    connect(to_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        take_end(false, quantity.value_or(Quantity{}));
    });
    connect(values_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        const auto count = static_cast<std::size_t>(quantity ? quantity->value : 2.0);
        emit edited([count](StudyAxis& axis) { axis.values = count; }, QStringLiteral("values"));
    });
    connect(tolerance_, &QuantityEdit::quantity_edited, this,
            [this](const std::optional<Quantity>& quantity) {
                emit tolerance_edited(quantity ? quantity->value : 0.0);
            });
    connect(remove_, &QPushButton::clicked, this, &StudyAxisEdit::remove_wanted);
}

/// Both ends have one unit: the other end follows into that of the one just typed.
void StudyAxisEdit::take_end(bool first, const Quantity& quantity) {
    emit edited(
        [first, quantity](StudyAxis& axis) {
            double& other = first ? axis.to : axis.from;
            const auto convert = axis.change == StudyChange::added ? converted_interval : converted;
            other = convert(other, axis.unit, quantity.unit);
            axis.unit = quantity.unit;
            (first ? axis.from : axis.to) = quantity.value;
        },
        first ? QStringLiteral("from") : QStringLiteral("to"));
}

void StudyAxisEdit::show_axis(const StudyAxis& axis, const StudyTarget* target, bool only) {
    axis_ = axis;
    QString words = target ? to_qt(target->title.message()) : tr("choose what is varied");
    if (target && axis.change == StudyChange::factor) words += tr(" (factor)");
    target_->show_title(words);
    const bool factor_only = target && (target->kind == StudyTarget::Kind::components ||
                                        target->kind == StudyTarget::Kind::component);
    change_->setEnabled(!factor_only);
    change_->setCurrentIndex(change_->findData(int(axis.change)));
    Unit unit = axis.unit;
    if (axis.change != StudyChange::factor && target && axis.unit == Unit{}) unit = target->unit;
    from_->set_unit(unit);
    to_->set_unit(unit);
    from_->set_quantity(Quantity{axis.from, axis.unit});
    to_->set_quantity(Quantity{axis.to, axis.unit});
    values_->set_quantity(Quantity{double(axis.values), {}});
    spacing_->setCurrentIndex(spacing_->findData(int(axis.spacing)));
    remove_->setVisible(!only);
}

void StudyAxisEdit::show_tolerance(double tolerance) {
    tolerance_->set_unit(axis_.unit);
    tolerance_->set_quantity(Quantity{tolerance, axis_.unit});
}

void StudyAxisEdit::set_place(UnreadTexts& unread, const TextPlace& place) {
    from_->set_place(unread, {place.entry, place.part + "/from"});
    to_->set_place(unread, {place.entry, place.part + "/to"});
    if (use_ == Use::axis) values_->set_place(unread, {place.entry, place.part + "/values"});
    if (use_ == Use::variable) tolerance_->set_place(unread, {place.entry, place.part + "/tolerance"});
    target_->set_place(unread, {place.entry, place.part + "/target"});
}

void StudyAxisEdit::set_complaint(const QString& complaint) {
    setTitle(complaint.isEmpty() ? title_ : tr("%1: has a problem").arg(title_));
    setToolTip(complaint);
}

}  // namespace covaria::ui
