// The problems of the project, one a row.
#pragma once

#include <QAbstractTableModel>

#include "ui/document/document.h"

namespace covaria::ui {

class ProblemsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { severity_column, place_column, message_column, column_count };
    explicit ProblemsModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    /// Shows these (of a file that could not be opened) until the document's problems change.
    void show(const Problems& problems);
    int errors() const;

    /// Where the path points, in words: "Pose analysis: Base points, row 3".
    static QString place_words(const Project& project, const std::string& path);
    /// What must be given next for an analysis that is not complete ("Quantities, row 3 (l_S), value"), with
    /// the entry where it is that of another; empty: nothing.
    static QString missing_words(const Document& document, const std::string& analysis);

private:
    bool is_to_give(const Problem& problem) const;

    Document& document_;
    std::vector<Problem> problems_;
};

}  // namespace covaria::ui
