// Shows what a CSV file would become before it replaces a table; which column is which can be chosen.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "core/project/csv_table.h"

namespace covaria::ui {

class CsvImportDialog : public QDialog {
    Q_OBJECT
public:
    /// Columns without a unit of their own are taken to be in `units`, those of the table now.
    CsvImportDialog(const FieldSpec& field, std::vector<Unit> units, const QString& file,
                    QWidget* parent = nullptr);

    const SetupTable& table() const { return imported_.table; }
    const Problems& problems() const { return imported_.problems; }

private:
    void make_columns_table();
    void offer_columns(const std::vector<std::string>& headers);
    CsvColumns renamed() const;
    void read();
    void show_preview();
    void show_summary(const QString& failure);

    FieldSpec field_;
    std::vector<Unit> units_;
    QByteArray text_;
    QString read_failure_;
    CsvTable imported_;
    QComboBox* separator_;
    QTableWidget* columns_;  ///< headers of the file and what they stand for
    std::vector<std::string> headers_;
    QTableWidget* preview_;
    QLabel* summary_;
    QPushButton* accept_;
};

}  // namespace covaria::ui
