// Text with real subscripts and superscripts and italic symbols, in charts, tables and lists.
#pragma once

#include <QFont>
#include <QString>
#include <vector>

#include "core/text/text.h"

class QPainter;
class QPointF;

namespace covaria::ui {

/// Role of a model's item or head whose text has scripts: a covaria::Text. Others show their text as running
/// text.
constexpr int typeset_role = Qt::UserRole + 1000;

class LabelText {
public:
    LabelText(const Text& text, const QFont& font);
    double width() const { return width_; }
    double height() const;
    /// Draws with the painter's pen; `top_left` of a box of width() times height().
    void draw(QPainter& painter, QPointF top_left) const;

private:
    struct Run {
        QString text;
        Script script;
        bool italic;
        double width;
    };
    const QFont& font_of(const Run& run) const {
        return run.script != Script::line ? small_ : run.italic ? symbol_ : font_;
    }
    QFont font_, small_, symbol_;
    std::vector<Run> runs_;
    double width_ = 0.0, shift_ = 0.0;
};

double text_width(const Text& text, const QFont& font);
/// `text` cut in the middle, marked by an ellipsis, where it is wider than `width`.
Text shortened(const Text& text, const QFont& font, double width);
/// Labels beside each other, shortened likewise: those that would look alike are cut where they are alike.
std::vector<Text> shortened_apart(const std::vector<Text>& texts, const QFont& font, double width);
/// Lines no wider than `width` where words allow it.
std::vector<Text> wrapped(const Text& text, const QFont& font, double width);

}  // namespace covaria::ui
