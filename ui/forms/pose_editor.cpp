// Lengths, and angles beside them.
#include "ui/forms/pose_editor.h"

#include <QGridLayout>

#include "ui/forms/flow_layout.h"
#include "ui/forms/form_labels.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int letters = 10;  // least width of each of two fields beside each other

void name(QLabel& label, const QString& symbol, const FieldSpec& field) {
    label.setText(symbol);
    label.buddy()->setAccessibleName(core_text(field.title) + ' ' + symbol);
}

}  // namespace

PoseEditor::PoseEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent)
    : FieldEditor(parent), field_(field), context_(context) {
    const std::array<QString, 3> axes{"x", "y", "z"};
    auto* flow = new FlowLayout(this);  // puts the angles below where six numbers are too wide
    flow->setContentsMargins(0, 0, 0, 0);
    std::array<QGridLayout*, 2> columns{};
    for (QGridLayout*& column : columns) {
        auto* part = new QWidget(this);
        column = new QGridLayout(part);
        column->setContentsMargins(0, 0, 0, 0);
        column->setHorizontalSpacing(4);
        column->setColumnStretch(1,
                                 1);  // fields that want no width by themselves would share it with a letter
        flow->addWidget(part);
    }
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        auto* edit = edits_[i] = new QuantityEdit(this);
        keep_whole_text(*edit, letters);
        edit->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // no wider than it must be
        edit->setTextMargins(-1, 0, -1, 0);
        edit->set_keeps_unit(false);
        edit->set_optional(false);
        edit->set_help(help_text(field));
        edit->setObjectName(to_qt(field.key) + '_' + QString::number(i));
        edit->set_place(context.document.unread(),
                        {context.address, "/setup/" + field.key + (i < 3 ? "/position/" : "/angles/") +
                                              std::to_string(i % 3)});
        auto* label = new QLabel(this);
        label->setBuddy(edit);
        if (i < 3)
            name(*label, axes[i], field);
        else
            angles_[i - 3] = label;
        const int row = static_cast<int>(i % 3);
        columns[i / 3]->addWidget(label, row, 0);
        columns[i / 3]->addWidget(edit, row, 1);
        connect(edit, &QuantityEdit::quantity_edited, this, [this, i] { collect(i); });
    }
    name_angles();
    setFocusProxy(edits_[0]);
}

void PoseEditor::name_angles() {
    const Setup* setup = find_setup(context_.document.project(), context_.address);
    const bool photogrammetric = field_.photogrammetric_if && context_.schema && setup &&
                                 holds(*field_.photogrammetric_if, *context_.schema, *setup);
    const QString letters = photogrammetric ? QStringLiteral("ωφκ") : QStringLiteral("αβγ");
    for (std::size_t i = 0; i < angles_.size(); ++i) name(*angles_[i], letters[static_cast<int>(i)], field_);
}

void PoseEditor::set_value(const SetupValue& value) {
    const PoseValue* pose = std::get_if<PoseValue>(&value);
    pose_ = pose ? *pose : PoseValue{};
    name_angles();
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        const Unit& unit = i < 3 ? pose_.length_unit : pose_.angle_unit;
        edits_[i]->set_unit(unit);
        edits_[i]->set_quantity(Quantity{i < 3 ? pose_.position[i] : pose_.angles[i - 3], unit});
    }
}

void PoseEditor::collect(std::size_t changed) {
    const double value = edits_[changed]->quantity()->value;
    if (changed < 3)
        pose_.position[changed] = value;
    else
        pose_.angles[changed - 3] = value;
    emit edited(SetupValue(pose_));
}

void PoseEditor::set_complaint(const QString& complaint) {
    for (QuantityEdit* edit : edits_) edit->set_complaint(complaint);
}

void PoseEditor::focus_part(const std::string& path) {
    const std::size_t base = path.starts_with("/angles") ? 3 : 0;
    const char last = path.empty() ? '0' : path.back();
    edits_[base + (last >= '0' && last <= '2' ? static_cast<std::size_t>(last - '0') : 0)]->setFocus();
}

}  // namespace covaria::ui
