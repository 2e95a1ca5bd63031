// A label that shortens what it has no room for.
#pragma once

#include <QLabel>

namespace covaria::ui {

/// Its text ends in "…" then, in the weight of its beginning; the owner gives the whole as a tooltip. Takes
/// any width.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const QString& text = {}, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace covaria::ui
