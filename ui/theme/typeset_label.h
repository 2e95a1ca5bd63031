// A line of text with symbols and scripts in it, shortened where it has no room.
#pragma once

#include <QWidget>

#include "core/text/text.h"
#include "ui/theme/fonts.h"

namespace covaria::ui {

class TypesetLabel : public QWidget {
    Q_OBJECT
public:
    explicit TypesetLabel(TextSize size = TextSize::text, QWidget* parent = nullptr);

    void show_text(const Text& text);
    const Text& text() const { return text_; }
    /// Chooses the ink of texts that are read second, or last.
    void set_rank(int rank);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont letters() const;

    TextSize size_;
    Text text_;
    int rank_ = 1;
};

}  // namespace covaria::ui
