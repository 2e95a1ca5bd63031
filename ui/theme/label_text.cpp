// Runs of text on the line, below and above it. Labels are set upright, symbols too.
#include "ui/theme/label_text.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr double small_size = 0.74, lowering = 0.16, raising = 0.36;  // of the font's size

}  // namespace

LabelText::LabelText(const Text& text, const QFont& font) : font_(font), small_(font) {
    const int size = font.pixelSize() > 0 ? font.pixelSize() : QFontInfo(font).pixelSize();
    small_.setPixelSize(std::max(1, qRound(small_size * size)));
    shift_ = size;
    for (const Text::Span& span : text.spans()) {
        // Letters on one line are one piece, for kerning and for who copies them out of a PDF.
        if (runs_.empty() || runs_.back().script != span.script) runs_.push_back({{}, span.script, 0.0});
        runs_.back().text += to_qt(span.letters);
    }
    for (Run& run : runs_) width_ += run.width = QFontMetricsF(font_of(run)).horizontalAdvance(run.text);
}

double LabelText::height() const {
    return QFontMetricsF(font_).height();
}

void LabelText::draw(QPainter& painter, QPointF top_left) const {
    QPointF baseline = top_left + QPointF(0.0, QFontMetricsF(font_).ascent());
    for (const Run& run : runs_) {
        const double down = run.script == Script::below   ? lowering
                            : run.script == Script::above ? -raising
                                                          : 0.0;
        painter.setFont(font_of(run));
        painter.drawText(baseline + QPointF(0.0, down * shift_), run.text);
        baseline.rx() += run.width;
    }
}

double text_width(const Text& text, const QFont& font) {
    return LabelText(text, font).width();
}

namespace {

/// Between digits, where the ones that remain would be another number.
bool is_in_number(const std::string& letters, std::size_t at) {
    static const std::string of_number = "0123456789.,\u202f";  // the bytes of the space between groups, too
    const auto belongs = [&](std::size_t i) { return of_number.find(letters[i]) != std::string::npos; };
    return at > 0 && at < letters.size() && belongs(at - 1) && belongs(at);
}

}  // namespace

Text shortened(const Text& text, const QFont& font, double width) {
    if (text.empty() || text_width(text, font) <= width) return text;
    const std::string letters = text.letters();
    std::vector<std::size_t> begins;  // of characters
    for (std::size_t at = 0; at < letters.size();
         at += character_length(std::string_view(letters).substr(at)))
        begins.push_back(at);
    const auto with = [&](std::size_t kept) {
        const std::size_t after = kept / 2, before = kept - after;
        std::size_t until = begins[before], from = after > 0 ? begins[begins.size() - after] : letters.size();
        while (is_in_number(letters, until)) --until;
        while (is_in_number(letters, from)) ++from;
        return text.part(0, until) + "…" + text.part(from);
    };
    std::size_t most = 0, too_many = begins.size();
    while (most + 1 < too_many) {
        const std::size_t middle = (most + too_many) / 2;
        (text_width(with(middle), font) <= width ? most : too_many) = middle;
    }
    return with(most);
}

std::vector<Text> shortened_apart(const std::vector<Text>& texts, const QFont& font, double width) {
    std::vector<Text> labels;
    for (const Text& text : texts) labels.push_back(shortened(text, font, width));
    const std::vector<Text> first = labels;
    for (std::size_t i = 0; i < texts.size(); ++i)
        for (std::size_t k = 0; k < texts.size(); ++k) {
            if (first[i] != first[k] || texts[i] == texts[k]) continue;
            const std::string own = texts[i].letters(), other = texts[k].letters();
            std::size_t same = 0;  // up to the word with which they part
            for (std::size_t at = 0; at < std::min(own.size(), other.size()) && own[at] == other[at]; ++at)
                if (own[at] == ' ') same = at + 1;
            if (same > 0) labels[i] = shortened("…" + texts[i].part(same), font, width);
        }
    return labels;
}

std::vector<Text> wrapped(const Text& text, const QFont& font, double width) {
    std::vector<Text> lines;
    const std::string letters = text.letters();
    for (std::size_t begin = 0; begin <= letters.size();) {
        const std::size_t end = std::min(letters.find(' ', begin), letters.size());
        const Text word = text.part(begin, end);
        const Text longer = lines.empty() ? word : lines.back() + " " + word;
        if (!lines.empty() && text_width(longer, font) <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
        begin = end + 1;
    }
    return lines;
}

}  // namespace covaria::ui
