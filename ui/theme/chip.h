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

    /// Shows the words; hidden without any. `sign`: an icon of the set; empty: that of the kind. `detail`
    /// stands behind the words unless the chip is brief.
    void show_words(Kind kind, const Text& words, const QString& sign = {}, const Text& detail = {});
    void set_brief(bool brief);
    Kind kind() const { return kind_; }
    /// Words as they are shown.
    Text words() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Text whole_words() const;
    QFont letters() const;

    Kind kind_ = Kind::neutral;
    Text words_, detail_;
    bool brief_ = false;
    QString sign_;
};

}  // namespace covaria::ui
