// The project as a tree: assets by category, analyses with their state.
#pragma once

#include <QAbstractItemModel>
#include <array>
#include <string>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/setup_address.h"
#include "ui/run/analysis_runner.h"

namespace covaria::ui {

class ProjectTreeModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// Top-level rows, always there: the project itself, the asset categories in their order, the analyses.
    enum Category { project_row, artefacts, instruments, robots, points, context, laboratory, analyses };
    static constexpr int category_count = analyses + 1;
    enum Column { name_column, state_column, column_count };

    ProjectTreeModel(Document& document, AnalysisRunner& runner, QObject* parent = nullptr);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Renames the entry of the row.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    bool is_category(const QModelIndex& index) const { return index.isValid() && index.internalId() == 0; }
    /// Empty id for a category and for the project.
    SetupAddress address(const QModelIndex& index) const;
    QModelIndex index_of(const SetupAddress& address) const;
    QModelIndex index_of(Category category) const { return index(category, 0); }

    /// "up to date", "out of date" ...
    static QString words(RunState state);
    /// Verdict on the requirements as they are now; empty where all of them are met, or nothing is known.
    static QString verdict_words(const AnalysisEntry& analysis, const AnalysisStatus& status);

private:
    using Ids = std::vector<std::string>;
    void refresh();
    void refresh_category(int category, const Ids& next);
    void refresh_state(const QString& id);
    std::array<Ids, category_count> read() const;
    QVariant category_data(int category, int column, int role) const;
    QVariant project_data(int column, int role) const;
    QVariant asset_data(const AssetEntry& asset, int column, int role) const;
    QVariant analysis_data(const AnalysisEntry& analysis, int column, int role) const;
    std::vector<Problem> found_in(const SetupAddress& address) const;
    QString problems_of(const SetupAddress& address) const;
    Severity worst_of(const SetupAddress& address) const;
    bool is_incomplete(const SetupAddress& address) const;

    Document& document_;
    AnalysisRunner& runner_;
    std::array<Ids, category_count> ids_;
    bool refreshing_ = false, changed_again_ = false;
};

}  // namespace covaria::ui
