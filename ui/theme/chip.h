// A verdict or a state in a word with its sign, on a ground of its own.
#pragma once

#include <QWidget>

#include "core/text/text.h"

namespace covaria::ui {

class Chip : public QWidget {
    Q_OBJECT
public:
    enum class Kind { met, not_met, neutral };
    explicit Chip(QWidget* parent = nullptr);

    /// Shows the words; hidden without any. `sign`: an icon of the set; empty: that of the kind.
    void show_words(Kind kind, const Text& words, const QString& sign = {});
    Kind kind() const { return kind_; }
    const Text& words() const { return words_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont letters() const;

    Kind kind_ = Kind::neutral;
    Text words_;
    QString sign_;
};

}  // namespace covaria::ui
