// A table with what can be done to it.
#include "ui/forms/table_editor.h"

#include <QAction>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>

#include "core/text/display_units.h"
#include "ui/forms/complaint.h"
#include "ui/forms/csv_import_dialog.h"
#include "ui/forms/flow_layout.h"
#include "ui/forms/read_only_hint.h"
#include "ui/forms/row_tools.h"
#include "ui/theme/core_text.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

/// Places of q_1, q_2 ... and of s_1, s_2 ..., of columns that may be empty.
std::vector<std::vector<int>> numbered_columns(const std::vector<ColumnSpec>& columns) {
    std::vector<std::vector<int>> found;
    std::string letter;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string& key = columns[i].key;
        const std::size_t line = key.rfind('_');
        const bool numbered = columns[i].optional && line != std::string::npos && line + 1 < key.size() &&
                              key.find_first_not_of("0123456789", line + 1) == std::string::npos;
        const std::string now = numbered ? key.substr(0, line) : std::string();
        if (numbered && now != letter) found.emplace_back();
        if (numbered) found.back().push_back(static_cast<int>(i));
        letter = now;
    }
    return found;
}

}  // namespace

TableEditor::TableEditor(const FieldSpec& field, const FieldContext& context, QWidget* parent)
    : FieldEditor(parent),
      field_(field),
      model_(new SetupTableModel(context.document, context.address, context.schema, field.key, this)),
      view_(new SpreadsheetView(*model_, this)),
      tools_(new RowTools(*this, *view_, this)),
      note_(new QLabel(this)),
      origin_(new QLabel(this)),
      embed_(new QPushButton(tr("Take into the project"), this)),
      all_columns_(new QPushButton(tr("All columns"), this)),
      numbered_(numbered_columns(field.columns)) {
    view_->setAccessibleName(core_text(field.title));
    view_->setObjectName(to_qt(field.key));
    keep_room(*note_, 1);
    auto* buttons = new FlowLayout;
    auto* import = new QAction(tr("Import CSV …"), this);
    connect(import, &QAction::triggered, this, &TableEditor::import_csv);
    tools_->add(QStringLiteral("import"), import->text(), import);
    buttons->addWidget(embed_);
    buttons->addWidget(all_columns_);
    origin_->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(tools_);
    layout->addWidget(view_);
    layout->addLayout(buttons);
    layout->addWidget(origin_);
    layout->addWidget(note_);
    setFocusProxy(view_);
    all_columns_->setCheckable(true);
    all_columns_->setToolTip(tr("Shows also the columns that no row has something in"));
    connect(all_columns_, &QPushButton::toggled, this, &TableEditor::hide_unused_columns);
    view_->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(view_->horizontalHeader(), &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        choose_unit(view_->horizontalHeader()->logicalIndexAt(at),
                    view_->horizontalHeader()->mapToGlobal(at));
    });
    connect(embed_, &QPushButton::clicked, model_, &SetupTableModel::embed);
    new ReadOnlyHint(*view_, [this] { return model_->is_linked() ? embed_->toolTip() : QString(); });
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& cell) {
                if (cell.isValid()) emit part_selected(QStringLiteral("/rows/%1").arg(cell.row()));
            });
    set_value({});
    set_complaint({});
}

QWidget* TableEditor::take_tools() {
    layout()->removeWidget(tools_);
    return tools_;
}

void TableEditor::hide_unused_columns() {
    const SetupTable& table = model_->table();
    const auto is_used = [&table](int column) {
        return std::ranges::any_of(table.rows, [at = static_cast<std::size_t>(column)](const auto& row) {
            return at < row.size() && !std::holds_alternative<std::monostate>(row[at]);
        });
    };
    const bool some_are = std::ranges::any_of(
        numbered_, [&](const auto& columns) { return std::ranges::any_of(columns, is_used); });
    bool some_hide = false;
    for (const std::vector<int>& columns : numbered_) {
        bool further = false;  // whether a column to the right is used
        for (auto column = columns.rbegin(); column != columns.rend(); ++column) {
            further = further || is_used(*column);
            some_hide = some_hide || (some_are && !further);
            view_->setColumnHidden(*column, some_are && !further && !all_columns_->isChecked());
        }
    }
    all_columns_->setVisible(some_hide);
}

void TableEditor::set_value(const SetupValue&) {
    hide_unused_columns();
    embed_->setVisible(model_->is_linked());
    origin_->setVisible(model_->is_linked());
    origin_->setText(tr("Read from %1").arg(to_qt(model_->table().csv_file)));
    embed_->setToolTip(tr("The rows are read from %1. Taken into the project they can be edited here.")
                           .arg(to_qt(model_->table().csv_file)));
}

void TableEditor::set_complaint(const QString& complaint) {
    mark(*view_, complaint, help_text(field_));
    show_note(*note_, complaint);
}

void TableEditor::focus_part(const std::string& path) {
    view_->setFocus(Qt::OtherFocusReason);
    const QModelIndex cell = model_->index_of_path(path);
    if (!cell.isValid()) return;
    view_->setCurrentIndex(cell);
    view_->scrollTo(cell);
}

void TableEditor::choose_unit(int column, const QPoint& position) {
    if (column < 0 || field_.columns[static_cast<std::size_t>(column)].kind != FieldKind::number) return;
    QMenu menu(this);
    for (const Unit& unit : DisplayUnits::choices(model_->unit(column)))
        menu.addAction(to_qt(unit.display()), this, [this, column, unit] { model_->set_unit(column, unit); });
    menu.exec(position);
}

void TableEditor::import_csv() {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Import CSV into %1").arg(core_text(field_.title)), {},
                                     tr("Tables (*.csv *.tsv *.txt);;All files (*)"));
    if (file.isEmpty()) return;
    CsvImportDialog dialog(field_, model_->table().units, file, this);
    if (dialog.exec() == QDialog::Accepted)
        model_->replace_table(dialog.table(), tr("Import %1").arg(core_text(field_.title)));
}

}  // namespace covaria::ui
