// The components of uncertainty of one input quantity, to be edited one by one.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <memory>

#include "core/made/prepared_analysis.h"
#include "ui/document/document.h"
#include "ui/forms/distribution_edit.h"

namespace covaria::ui {

/// The quantity's own components; those it shares with other quantities belong to what they come from (an
/// instrument, an artefact) and are edited there.
class ComponentsEdit : public QWidget {
    Q_OBJECT
public:
    explicit ComponentsEdit(Document& document, QWidget* parent = nullptr);
    /// `analysis` as it was last prepared.
    void set_quantity(std::shared_ptr<const PreparedAnalysis> analysis, const std::string& symbol);

    void add_component();
    void remove_component();
    /// Gives the quantity back the components of the model.
    void reset();

private:
    void build();
    std::vector<ComponentEdit> components() const;
    std::vector<const UncertaintyComponent*> own_components() const;
    std::vector<ComponentEdit> model_components() const;
    bool draws_normal(int row) const;
    void write(const QString& text, std::vector<ComponentEdit> components, const QString& merge_key = {});
    void change(const QString& what, const std::function<void(ComponentEdit&)>& edit);
    void refresh();
    std::string components_part() const;
    void forget_unread();
    void show_component();
    /// Reason why the list lacks components, or has none; empty: it has all.
    QString note() const;
    QString shared_names(std::size_t quantity) const;

    Document& document_;
    std::shared_ptr<const PreparedAnalysis> analysis_;
    std::string symbol_;
    QListWidget* list_;
    QLabel* note_;
    QPushButton* add_;
    QPushButton* remove_;
    QPushButton* reset_;
    QWidget* details_;
    QLineEdit* name_;
    QComboBox* type_;
    QuantityEdit* degrees_;
    QLineEdit* origin_;
    DistributionEdit* distribution_;
};

}  // namespace covaria::ui
