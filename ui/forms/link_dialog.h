// The choice of a result of another analysis that an input quantity takes its value from.
#pragma once

#include <QDialog>
#include <optional>
#include <string>
#include <vector>

#include "core/project/project.h"

class QCheckBox;
class QComboBox;

namespace covaria::ui {

/// An analysis that something can be taken from, with its results of the right dimension.
struct LinkChoice {
    std::string analysis, name;
    std::vector<OutputReference> outputs;
    std::vector<Name> groups = {};  ///< the outputs' groups, for people; empty: as they are referred to
};

class LinkDialog : public QDialog {
    Q_OBJECT
public:
    LinkDialog(const std::string& symbol, std::vector<LinkChoice> choices,
               const std::optional<InputLink>& now, QWidget* parent = nullptr);

    /// The link chosen; empty where nothing can be.
    std::optional<InputLink> link() const;
    QComboBox& analyses() { return *analyses_; }
    QComboBox& outputs() { return *outputs_; }
    QCheckBox& linearised() { return *linearised_; }

private:
    void build();
    void list_outputs();

    std::string symbol_;
    std::vector<LinkChoice> choices_;
    QComboBox* analyses_;
    QComboBox* outputs_;
    QCheckBox* linearised_;
};

}  // namespace covaria::ui
