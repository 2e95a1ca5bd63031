// Correlation coefficients between components of uncertainty, as an editable symmetric matrix with a live
// check.
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/made/prepared_analysis.h"
#include "ui/document/document.h"

namespace covaria::ui {

/// Rows and columns are the components that are correlated already and those added to be edited.
class InputCorrelationModel : public QAbstractTableModel {
    Q_OBJECT
public:
    explicit InputCorrelationModel(Document& document, QObject* parent = nullptr);

    /// The analysis as it was last prepared; null empties the table.
    void set_analysis(std::shared_ptr<const PreparedAnalysis> analysis);
    const std::shared_ptr<const PreparedAnalysis>& analysis() const { return analysis_; }
    /// Puts a component into the matrix; nothing is written until a coefficient is.
    void add_component(const std::string& id);
    /// Removes all coefficients of the component and takes it out.
    void remove_component(int row);
    /// Ids of components that are not in the matrix.
    std::vector<std::string> other_components() const;

    /// Cell of two components in the matrix; invalid: one is not in it.
    QModelIndex index_of(const std::string& a, const std::string& b) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override { return rowCount(parent); }
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    /// Why the matrix is not a correlation matrix (not positive semi-definite ...), in words; empty: it is.
    const QString& complaint() const { return complaint_; }

signals:
    void complaint_changed();

private:
    /// Name of a component in the words of an undo step.
    QString said(const std::string& id) const;
    void refresh();
    void check();
    const std::vector<covaria::CorrelationEdit>& edits() const;
    TextPlace place(const QModelIndex& index) const;
    /// Text typed in a cell that is no coefficient; null: the cell has one.
    const UnreadText* unread(const QModelIndex& index) const;
    void forget_unread(const std::function<bool(const TextPlace&, const UnreadText&)>& which);
    double coefficient(const std::string& a, const std::string& b) const;
    std::vector<std::string> shown_components() const;

    Document& document_;
    std::shared_ptr<const PreparedAnalysis> analysis_;
    std::vector<std::string> added_;
    std::vector<std::string> ids_;
    QString complaint_;
};

}  // namespace covaria::ui
