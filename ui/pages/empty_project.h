// The middle of the window while the project is empty: what can be evaluated, one click or key away.
#pragma once

#include <QWidget>

class QStandardItemModel;
class QTreeView;

namespace covaria::ui {

class EmptyProject : public QWidget {
    Q_OBJECT
public:
    explicit EmptyProject(QWidget* parent = nullptr);
    QTreeView& models() { return *models_; }

signals:
    /// An analysis by the model with this id is to be added.
    void analysis_wanted(const std::string& model);
    void library_wanted();

private:
    void fill();

    QTreeView* models_;
    QStandardItemModel* rows_;  ///< a model each: its title and its summary
};

}  // namespace covaria::ui
