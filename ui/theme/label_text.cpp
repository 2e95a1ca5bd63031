// Runs of text on the line, below and above it; symbols are italic.
#include "ui/theme/label_text.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <set>

#include "core/text/wrapped.h"
#include "ui/theme/fonts.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr double small_size = 0.72, lowering = 0.16, raising = 0.36;  // parts of the font's size

}  // namespace

LabelText::LabelText(const Text& text, const QFont& font)
    : font_(font), small_(font), symbol_(symbol_font(font)) {
    const int size = font.pixelSize() > 0 ? font.pixelSize() : QFontInfo(font).pixelSize();
    small_.setPixelSize(std::max(1, qRound(small_size * size)));
    shift_ = size;
    for (const Text::Span& span : text.spans()) {
        // Letters on one line are one piece, for kerning and for who copies them out of a PDF.
        const bool goes_on =
            !runs_.empty() && runs_.back().script == span.script && runs_.back().italic == span.italic;
        if (!goes_on) runs_.push_back({{}, span.script, span.italic, 0.0});
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

Text shortened(const Text& text, const QFont& font, double width) {
    if (text.empty() || text_width(text, font) <= width) return text;
    const std::string letters = text.letters();
    std::vector<std::size_t> begins;  // first byte of each character
    for (std::size_t at = 0; at < letters.size();
         at += character_length(std::string_view(letters).substr(at)))
        begins.push_back(at);
    begins.push_back(letters.size());
    // The digits that remain of a number would be another one.
    const auto is_of_number = [&](std::size_t character) {
        static const std::set<std::string, std::less<>> known{
            "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", ".", ",", "\u202f",
            "−", "×", "⁻", "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
        const std::size_t begin = begins[character];
        return known.contains(std::string_view(letters).substr(begin, begins[character + 1] - begin));
    };
    const std::size_t count = begins.size() - 1;
    const auto is_in_number = [&](std::size_t character) {
        return character > 0 && character < count && is_of_number(character - 1) && is_of_number(character);
    };
    const auto with = [&](std::size_t kept) {
        std::size_t until = kept - kept / 2, from = count - kept / 2;
        while (is_in_number(until)) --until;
        while (is_in_number(from)) ++from;
        return text.part(0, begins[until]) + "…" + text.part(begins[from]);
    };
    std::size_t most = 0, too_many = count;
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
    return covaria::wrapped(text, [&](const Text& line) { return text_width(line, font) <= width; });
}

}  // namespace covaria::ui
