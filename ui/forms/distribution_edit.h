// Chooses a distribution and its parameters, with a picture of the density and the resulting u.
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <vector>

#include "core/project/project.h"
#include "ui/forms/density_picture.h"
#include "ui/forms/quantity_edit.h"

namespace covaria::ui {

/// Edits kind, parameters and unit of a component; the rest of it is passed through.
class DistributionEdit : public QWidget {
    Q_OBJECT
public:
    explicit DistributionEdit(QWidget* parent = nullptr);
    /// Sets the place of the component in the project.
    void set_place(UnreadTexts& unread, const TextPlace& place);
    /// `normal_draws`: whether Monte Carlo draws the component normally (core/quantity).
    void set_component(const ComponentEdit& component, bool normal_draws = false);
    const ComponentEdit& component() const { return component_; }
    /// Standard uncertainty in words ("u = 0.58 µm"), and what Monte Carlo draws where that is another
    /// distribution; or why there is none.
    QString summary() const { return summary_->text(); }

signals:
    void component_edited(const covaria::ComponentEdit& component);

private:
    void choose_kind(const QString& kind);
    void choose_unit(int index);
    void rebuild_parameters();
    void add_parameter(std::size_t index, const DistributionParameterInfo& info);
    void add_list(const QString& title, std::size_t part);
    void set_parameter(std::size_t index, const std::optional<Quantity>& quantity);
    void set_list(std::size_t part, const QString& text);
    void show_values();
    void show_summary();
    bool is_list() const;
    bool is_histogram() const;
    TextPlace place_of(const std::string& part) const { return {place_.entry, place_.part + "/" + part}; }
    void complain(std::size_t list, const QString& complaint);
    QString list_text(std::size_t part) const;

    ComponentEdit component_;
    bool normal_draws_ = false;
    std::string shown_kind_;
    UnreadTexts* unread_ = nullptr;
    TextPlace place_;
    QComboBox* kind_;
    QComboBox* unit_;
    QFormLayout* parameters_;
    std::vector<QuantityEdit*> edits_;
    std::vector<QLineEdit*> lists_;
    DensityPicture* picture_;
    QLabel* summary_;
};

}  // namespace covaria::ui
