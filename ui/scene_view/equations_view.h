// The equations of a model whose quantities are nowhere in space, set as mathematics.
#pragma once

#include <QWidget>
#include <vector>

#include "core/model/measurement_model.h"

namespace covaria::ui {

class EquationsView : public QWidget {
    Q_OBJECT
public:
    explicit EquationsView(QWidget* parent = nullptr);

    /// `title`: over the equations, the name of the analysis.
    void show_equations(const QString& title, std::vector<ModelEquation> equations);
    /// Keeps a widget at its upper right.
    void put_tools(QWidget& tools);
    /// Height of the pane for the equations at their usual size, where `width` is enough for the widest.
    int height_wanted(int width) const;
    QSize sizeHint() const override { return {800, 500}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override { place_tools(); }
    bool eventFilter(QObject* tools, QEvent* event) override;

private:
    void place_tools();

    QWidget* tools_ = nullptr;
    QString title_;
    std::vector<ModelEquation> equations_;
};

}  // namespace covaria::ui
