// The form of an analysis' evaluation options.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "core/propagation/options.h"
#include "ui/document/document.h"
#include "ui/forms/quantity_edit.h"

namespace covaria::ui {

class OptionsForm : public QWidget {
    Q_OBJECT
public:
    OptionsForm(Document& document, std::string analysis, QWidget* parent = nullptr);
    /// "/analyses/0/options/trials", or relative: "/trials".
    bool focus_field(const std::string& path);
    /// How many trials the adaptive procedure needs, in words; empty: not known.
    void set_forecast(const QString& words);

private:
    using Get = std::function<std::optional<double>(const EvaluationOptions&)>;
    using Set = std::function<void(EvaluationOptions&, std::optional<double>)>;
    using GetQuantity = std::function<std::optional<Quantity>(const EvaluationOptions&)>;
    using SetQuantity = std::function<void(EvaluationOptions&, std::optional<Quantity>)>;
    struct Row {
        QString key;  ///< of the field in the options
        QuantityEdit* edit;
        GetQuantity get;
        std::vector<Method> methods;  ///< shown for these
    };
    struct Field {
        const char* key;
        QString title;
        QString help;
        bool integer = false;
        Range range = {};
        bool optional = false;
    };
    void build_method();
    void build_common();
    void build_monte_carlo();
    void build_variance_reduction();
    void build_adaptive();
    void add(const Field& field, std::vector<Method> methods, Get get, Set set);
    void add_quantity(const Field& field, std::vector<Method> methods, GetQuantity get, SetQuantity set);
    void add_count(const Field& field, std::vector<Method> methods, std::uint64_t EvaluationOptions::*member);
    void change(const QString& key, const std::function<void(EvaluationOptions&)>& edit);
    const EvaluationOptions* options() const;
    void refresh();
    void refresh_problems();

    Document& document_;
    std::string analysis_;
    QFormLayout* layout_;
    QComboBox* method_;
    QComboBox* variance_reduction_;
    QCheckBox* second_order_;
    QLabel* forecast_ = nullptr;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
