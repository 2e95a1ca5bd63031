// A small picture of a distribution's density with its mean and standard uncertainty.
#pragma once

#include <QWidget>
#include <optional>

#include "core/quantity/distribution.h"

namespace covaria::ui {

class DensityPicture : public QWidget {
    Q_OBJECT
public:
    explicit DensityPicture(QWidget* parent = nullptr);
    /// Empty: nothing to draw (parameters that make no distribution).
    void set_distribution(std::optional<Distribution> distribution);
    QSize sizeHint() const override { return {180, 72}; }
    QSize minimumSizeHint() const override { return {90, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<Distribution> distribution_;
};

}  // namespace covaria::ui
