// The problems of the project, one a row.
#pragma once

#include <QAbstractTableModel>

#include "ui/document/document.h"

namespace covaria::ui {

class ProblemsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    /// The ways out of a problem stand side by side from `remedy_column` on.
    enum Column {
        severity_column,
        place_column,
        message_column,
        remedy_column,
        column_count = remedy_column + 3
    };
    explicit ProblemsModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    /// Shows these (of a file that could not be opened) until the document's problems change.
    void show(const Problems& problems);
    int errors() const;
    /// The largest number of remedies that a problem has.
    int remedies() const;
    /// Takes the way out that stands in this cell; as one step that can be undone. False: there is none.
    bool take_remedy(const QModelIndex& index);

    /// Words for the place that the path points to: "Pose analysis: Base points, row 3".
    static QString place_words(const Project& project, const std::string& path);
    /// Words for what must be given next in an incomplete analysis ("Quantities, row 3 (l_S), value"), with
    /// the entry where it is that of another; empty: nothing.
    static QString missing_words(const Document& document, const std::string& analysis);

signals:
    /// Why a way out cannot be taken.
    void remedy_refused(const QString& why);

private:
    bool is_to_give(const Problem& problem) const;
    const Remedy* remedy_at(const QModelIndex& index) const;

    Document& document_;
    std::vector<Problem> problems_;
};

}  // namespace covaria::ui
