// Reading is that of core/project, so that import and linked files agree.
#include "ui/forms/csv_import_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/file_io.h"
#include "core/project/table_columns.h"
#include "core/text/head_with_unit.h"
#include "core/text/symbol.h"
#include "ui/document/quantity_text.h"
#include "ui/document/setup_cells.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr int preview_rows = 200;
constexpr int shown_problems = 8;

}  // namespace

CsvImportDialog::CsvImportDialog(const FieldSpec& field, std::vector<Unit> units, const QString& file,
                                 QWidget* parent)
    : QDialog(parent),
      field_(field),
      units_(std::move(units)),
      separator_(new QComboBox(this)),
      columns_(new QTableWidget(this)),
      preview_(new QTableWidget(this)),
      summary_(new QLabel(this)) {
    setWindowTitle(tr("Import %1 into %2").arg(QFileInfo(file).fileName(), core_text(field.title)));
    if (auto read = read_file(to_path(file)))
        text_ = QByteArray::fromStdString(*read);
    else
        read_failure_ = to_qt(read.error().message) + QLatin1Char('.');
    separator_->addItem(tr("found by itself"), QString());
    separator_->addItem(tr("comma"), QString(","));
    separator_->addItem(tr("semicolon"), QString(";"));
    separator_->addItem(tr("tab"), QString("\t"));
    preview_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    preview_->setAccessibleName(tr("Preview"));
    preview_->setObjectName("preview");
    summary_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    accept_ = buttons->button(QDialogButtonBox::Ok);
    accept_->setText(tr("Import"));
    make_columns_table();
    auto* form = new QFormLayout;
    form->addRow(tr("&Separator of cells"), separator_);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(columns_);
    layout->addWidget(preview_, 1);
    layout->addWidget(summary_);
    layout->addWidget(buttons);
    resize(760, 620);
    connect(separator_, &QComboBox::currentIndexChanged, this, &CsvImportDialog::read);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    read();
}

void CsvImportDialog::make_columns_table() {
    columns_->setColumnCount(2);
    columns_->setHorizontalHeaderLabels({tr("Column of the file"), tr("is read as")});
    columns_->horizontalHeader()->setStretchLastSection(true);
    columns_->verticalHeader()->hide();
    columns_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    columns_->setAccessibleName(tr("Columns of the file"));
    columns_->setObjectName("columns");
    columns_->setMaximumHeight(170);
}

/// Lists the headers, a line each, with the columns they may stand for; anew only for other headers.
void CsvImportDialog::offer_columns(const std::vector<std::string>& headers) {
    columns_->setVisible(!headers.empty());
    if (headers == headers_) return;
    headers_ = headers;
    columns_->setRowCount(static_cast<int>(headers.size()));
    for (int row = 0; row < columns_->rowCount(); ++row) {
        const std::string& header = headers[static_cast<std::size_t>(row)];
        columns_->setItem(row, 0, new QTableWidgetItem(to_qt(header)));
        auto* choice = new QComboBox;
        choice->setAccessibleName(tr("Column %1 is read as").arg(to_qt(header)));
        const bool known = find_table_column(field_, header_name(header)) != SetupSchema::npos;
        choice->addItem(known ? tr("as it is named") : tr("unknown: choose"), to_qt(header));
        choice->addItem(tr("not read"), QString());
        for (const ColumnSpec& column : field_.columns)
            choice->addItem(
                to_qt(to_unicode(head_with_unit(title_text(core_words(column.title)), column.unit))),
                to_qt(column_header(column, column.unit)));
        columns_->setCellWidget(row, 1, choice);
        connect(choice, &QComboBox::currentIndexChanged, this, &CsvImportDialog::read);
    }
    columns_->resizeColumnToContents(0);
}

CsvColumns CsvImportDialog::renamed() const {
    CsvColumns renamed;
    for (int row = 0; row < columns_->rowCount(); ++row) {
        const auto* choice = qobject_cast<QComboBox*>(columns_->cellWidget(row, 1));
        if (choice && choice->currentIndex() > 0)
            renamed.emplace_back(headers_[static_cast<std::size_t>(row)],
                                 to_std(choice->currentData().toString()));
    }
    return renamed;
}

void CsvImportDialog::read() {
    imported_ = {};
    QString failure = read_failure_;
    const QString chosen = separator_->currentData().toString();
    const std::optional<char> separator =
        chosen.isEmpty() ? std::nullopt : std::optional<char>(chosen.at(0).toLatin1());
    const std::string_view text(text_.data(), static_cast<std::size_t>(text_.size()));
    if (const Message refused = too_many_rows(field_, text); !refused.empty()) {
        failure = tr("The file cannot be imported: %1.").arg(to_qt(refused));
    } else if (const auto csv = read_csv(text, separator); !csv) {
        failure = csv.error().line > 0
                      ? tr("Line %1: %2").arg(csv.error().line).arg(to_qt(csv.error().message))
                      : to_qt(csv.error().message);
    } else if (has_header(*csv, field_)) {
        offer_columns(headers_of(*csv));
        imported_ = table_from_csv(*csv, field_, renamed());
    } else {
        offer_columns({});
        imported_ = table_from_csv_rows(*csv, field_, units_);
    }
    show_preview();
    show_summary(failure);
}

void CsvImportDialog::show_preview() {
    const SetupTable& table = imported_.table;
    const int rows = std::min(preview_rows, static_cast<int>(table.rows.size()));
    preview_->clear();
    preview_->setColumnCount(static_cast<int>(field_.columns.size()));
    preview_->setRowCount(rows);
    for (std::size_t c = 0; c < field_.columns.size(); ++c) {
        const Unit unit = c < table.units.size() ? table.units[c] : field_.columns[c].unit;
        const QString title =
            to_qt(to_unicode(head_with_unit(title_text(core_words(field_.columns[c].title)), unit)));
        preview_->setHorizontalHeaderItem(static_cast<int>(c), new QTableWidgetItem(title));
        for (int r = 0; r < rows; ++r) {
            const auto& row = table.rows[static_cast<std::size_t>(r)];
            const QString text = c < row.size() ? cell_text(field_.columns[c], row[c], locale()) : QString();
            preview_->setItem(r, static_cast<int>(c), new QTableWidgetItem(text));
        }
    }
}

void CsvImportDialog::show_summary(const QString& failure) {
    QStringList lines;
    const auto& problems = imported_.problems.items();
    if (failure.isEmpty()) {
        lines << tr("%n row(s).", nullptr, static_cast<int>(imported_.table.rows.size()));
        for (const Problem& problem : problems) {
            if (lines.size() > shown_problems) break;
            lines << (problem.line > 0 ? tr("Line %1: %2").arg(problem.line).arg(to_qt(problem.message))
                                       : to_qt(problem.message));
        }
        if (problems.size() > shown_problems)
            lines << tr("%n more problem(s).", nullptr, static_cast<int>(problems.size()) - shown_problems);
    } else {
        lines << failure;
    }
    summary_->setText(lines.join('\n'));
    accept_->setEnabled(failure.isEmpty() && !imported_.problems.has_errors() &&
                        !imported_.table.rows.empty());
}

}  // namespace covaria::ui
