// A report document as a flow of printed items.
#include "ui/print/report_layout.h"

#include <QImage>
#include <algorithm>
#include <sstream>

#include "core/document/prose.h"
#include "core/text/symbol.h"
#include "ui/print/rich_text.h"
#include "ui/print/table_layout.h"
#include "ui/theme/formula_picture.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

QString escaped(const std::string& text) {
    return to_qt(escape_html(text));
}

QString rich(const std::string& words) {
    return to_qt(to_html(running_text(words)));
}

/// The logo stands in the corner, beside both.
void append_title(std::vector<FlowItem>& items, const ReportDocument& document, const PageStyle& style,
                  double width) {
    QImage logo;
    logo.loadFromData(QByteArray::fromStdString(document.logo.bytes));
    const QSizeF size = QSizeF(logo.size()).scaled(style.mm(50.0), style.mm(18.0), Qt::KeepAspectRatio);
    const double beside = logo.isNull() ? width : width - size.width() - style.mm(5.0);
    const QPointF corner(width - size.width(), 0.0);
    RichText over(style, TextRole::body, escaped(document.over));
    over.set_width(beside);
    const double above = over.height() + style.mm(1.0);
    items.push_back({above,
                     0.0,
                     true,
                     [over, logo, size, corner](QPainter& p, QPointF at) {
                         over.paint(p, at, PageStyle::quiet());
                         if (!logo.isNull()) p.drawImage(QRectF(at + corner, size), logo);
                     },
                     {}});
    RichText title(style, TextRole::title, escaped(document.title));
    title.set_width(beside);
    const double tall = logo.isNull() ? 0.0 : size.height() - above;
    const double rule = std::max(title.height(), tall) + style.mm(2.5), line = style.points(0.8);
    items.push_back({rule + style.mm(3.0),
                     0.0,
                     true,
                     [title, rule, line, width](QPainter& p, QPointF at) {
                         title.paint(p, at);
                         p.fillRect(QRectF(at.x(), at.y() + rule, width, line), PageStyle::ink());
                     },
                     {}});
}

void append_code(std::vector<FlowItem>& items, const CodeBlock& code, const PageStyle& style, double width) {
    std::istringstream lines(code.text);
    bool first = true;
    for (std::string line; std::getline(lines, line); first = false) {
        RichText text(style, TextRole::table,
                      QStringLiteral("<pre style='white-space: pre-wrap'>%1</pre>").arg(escaped(line)));
        text.set_width(width - style.mm(4.0));
        items.push_back({text.height(),
                         first ? style.mm(1.8) : 0.0,
                         false,
                         [text, indent = style.mm(4.0)](QPainter& p, QPointF at) {
                             text.paint(p, at + QPointF(indent, 0.0));
                         },
                         {}});
    }
}

void append_signature(std::vector<FlowItem>& items, const SignatureBlock& signature, const PageStyle& style,
                      double width) {
    RichText statement(style, TextRole::body, escaped(signature.statement));
    statement.set_width(width);
    const double x = 0.45 * width, room = statement.height() + style.mm(20.0), gap = style.mm(1.2);
    RichText date(style, TextRole::body, escaped(signature.date));
    date.set_width(x - style.mm(5.0));
    const QString function = signature.function.empty() ? "" : "<br>" + escaped(signature.function);
    RichText name(style, TextRole::body, escaped(signature.name) + function);
    name.set_width(width - x);
    RichText end(style, TextRole::note, escaped(signature.end_mark), Qt::AlignHCenter);
    end.set_width(width);
    const double end_y = room + gap + std::max(date.height(), name.height()) + style.mm(8.0);
    const double line = style.points(0.6);
    items.push_back({end_y + style.mm(2.0) + end.height(),
                     style.mm(1.8),
                     false,
                     [=](QPainter& p, QPointF at) {
                         statement.paint(p, at);
                         date.paint(p, at + QPointF(0.0, room + gap));
                         p.fillRect(QRectF(at.x() + x, at.y() + room, width - x, line), PageStyle::ink());
                         name.paint(p, at + QPointF(x, room + gap));
                         p.fillRect(QRectF(at.x(), at.y() + end_y, width, line), PageStyle::rule());
                         end.paint(p, at + QPointF(0.0, end_y + line + gap), PageStyle::quiet());
                     },
                     {}});
}

class ReportLayout {
public:
    ReportLayout(const ReportDocument& document, const PageStyle& style, const FigurePainters& figures,
                 HeadingPages pages)
        : document_(document),
          style_(style),
          figures_(figures),
          pages_(std::move(pages)),
          width_(style.text_area().width()) {}

    void operator()(const HeadingBlock& heading) {
        const bool first = heading.level == 1;
        const TextRole role = first                ? TextRole::heading_1
                              : heading.level == 2 ? TextRole::heading_2
                              : heading.level == 3 ? TextRole::heading_3
                                                   : TextRole::caption;
        RichText text(style_, role, escaped(heading.text));
        text.set_width(width_);
        const double rule = text.height() + style_.mm(0.8), line = style_.points(0.5);
        const double before = first ? 9.0 : heading.level == 2 ? 6.0 : 4.0;
        items.push_back({first ? rule + style_.mm(1.5) : text.height() + style_.mm(0.8),
                         style_.mm(before),
                         true,
                         [text, first, rule, line, width = width_](QPainter& p, QPointF at) {
                             text.paint(p, at);
                             if (first)
                                 p.fillRect(QRectF(at.x(), at.y() + rule, width, line), PageStyle::rule());
                         },
                         {}});
        items.back().heading = heading.text;
        items.back().heading_level = heading.level;
        items.back().begins_page = heading.begins_page;
    }

    void operator()(const ParagraphBlock& paragraph) {
        const TextRole role = paragraph.note ? TextRole::note : TextRole::body;
        add_text(role, rich(paragraph.text), 0.0, paragraph.note ? PageStyle::quiet() : PageStyle::ink());
    }

    void operator()(const ListBlock& list) {
        for (const std::string& item : list.items) add_item("–", rich(item));
    }

    void operator()(const ProseBlock& prose) {
        const QString html = to_qt(prose_html(prose.spans, Links::dropped));
        if (prose.mark.empty())
            add_text(TextRole::body, html, 0.0, PageStyle::ink());
        else
            add_item(to_qt(prose.mark), html);
    }

    void operator()(const CodeBlock& code) { append_code(items, code, style_, width_); }
    void operator()(const SignatureBlock& signature) { append_signature(items, signature, style_, width_); }
    void operator()(const PictureBlock& picture) {
        append_picture(items, QImage(from_path(picture.file)), picture.caption, style_);
    }

    void operator()(const ContentsBlock& contents) {
        std::size_t placed = 0;  // headings so far
        for (const ReportBlock& block : document_.blocks) {
            const auto* heading = std::get_if<HeadingBlock>(&block);
            if (!heading || heading->text.empty()) continue;
            if (heading->level <= contents.levels) add_contents_line(*heading, placed);
            ++placed;
        }
    }

    void operator()(const FactsBlock& facts) {
        bool first = true;
        for (const auto& fact : facts.facts) {
            const QString value = facts.literal ? escaped(fact.second) : rich(fact.second);
            add_fact(fact.first, value, first ? style_.mm(1.6) : style_.mm(0.9));
            first = false;
        }
    }

    void operator()(const EquationBlock& equation) {
        const double indent = style_.mm(6.0), gap = style_.mm(5.0);
        RichText source(style_, TextRole::note, rich(equation.source), Qt::AlignRight);
        const double source_width = std::min(source.natural_width(), 0.34 * width_);
        source.set_width(source_width);
        if (add_formula(equation, source, source_width)) return;
        RichText text(style_, TextRole::body, to_qt(to_html(equation_text(equation.text))));
        text.set_width(width_ - indent - gap - source_width);
        const double drop = text.first_baseline() - source.first_baseline();
        items.push_back({std::max(text.height(), source.height() + drop),
                         style_.mm(1.3),
                         false,
                         [text, source, indent, drop, x = width_ - source_width](QPainter& p, QPointF at) {
                             text.paint(p, at + QPointF(indent, 0.0));
                             source.paint(p, at + QPointF(x, drop), PageStyle::quiet());
                         },
                         {}});
    }

    void operator()(const TableBlock& block) { append_table(items, block, style_, width_); }
    void operator()(const SceneBlock& scene) { append_scene(items, scene, style_, figures_.render_scene); }
    void operator()(const PlotBlock&) {}  // laid out in runs by lay_out

    void plots(const std::vector<const PlotBlock*>& run) {
        append_plots(items, run, style_, figures_.paint_plot);
    }

    std::vector<FlowItem> items;

private:
    /// Adds the equation as mathematics, if there is such a form and it is not too wide.
    bool add_formula(const EquationBlock& equation, const RichText& source, double source_width) {
        if (equation.formula.empty()) return false;
        const double indent = style_.mm(6.0), room = width_ - indent - style_.mm(5.0) - source_width;
        const FormulaPicture formula(equation.formula, style_.font(TextRole::body), style_.device());
        if (formula.is_empty() || formula.width() > room) return false;
        const double drop = std::max(0.0, formula.baseline() - source.first_baseline());
        items.push_back({std::max(formula.height(), source.height() + drop),
                         style_.mm(1.8),
                         false,
                         [formula, source, drop, indent, x = width_ - source_width](QPainter& p, QPointF at) {
                             formula.paint(p, at + QPointF(indent, 0.0), PageStyle::ink());
                             source.paint(p, at + QPointF(x, drop), PageStyle::quiet());
                         },
                         {}});
        return true;
    }

    void add_item(const QString& sign, const QString& html) {
        const double indent = style_.mm(4.0);
        RichText mark(style_, TextRole::body, sign.toHtmlEscaped());
        RichText text(style_, TextRole::body, html);
        text.set_width(width_ - indent);
        items.push_back({text.height(),
                         style_.mm(1.0),
                         false,
                         [mark, text, indent](QPainter& p, QPointF at) {
                             mark.paint(p, at, PageStyle::quiet());
                             text.paint(p, at + QPointF(indent, 0.0));
                         },
                         {}});
    }

    void add_contents_line(const HeadingBlock& heading, std::size_t index) {
        const double indent = style_.mm(6.0) * (heading.level - 1), room = style_.mm(12.0);
        const QString words = escaped(heading.text);
        RichText text(style_, TextRole::body, heading.level == 1 ? "<b>" + words + "</b>" : words);
        text.set_width(width_ - indent - room);
        items.push_back({text.height(),
                         style_.mm(heading.level == 1 ? 2.0 : 0.6),
                         false,
                         [text, indent, room, index, width = width_, pages = pages_, style = style_](
                             QPainter& p, QPointF at) {
                             text.paint(p, at + QPointF(indent, 0.0));
                             const QString number = QString::number(pages->at(index) + 1);
                             RichText page(style, TextRole::body, number, Qt::AlignRight);
                             page.set_width(room);
                             page.paint(p, at + QPointF(width - room, 0.0));
                         },
                         {}});
        items.back().leads_to = index;
    }

    void add_text(TextRole role, const QString& html, double indent, const QColor& color) {
        RichText text(style_, role, html);
        text.set_width(width_ - indent);
        items.push_back({text.height(),
                         style_.mm(1.8),
                         false,
                         [text, indent, color](QPainter& p, QPointF at) {
                             text.paint(p, at + QPointF(indent, 0.0), color);
                         },
                         {}});
    }

    void add_fact(const std::string& name, const QString& value, double space_before) {
        const double key_width = 0.34 * width_;
        RichText key(style_, TextRole::body, rich(name));
        key.set_width(key_width);
        const double x = key_width + style_.mm(5.0);
        RichText text(style_, TextRole::body, value);
        text.set_width(width_ - x);
        items.push_back({std::max(key.height(), text.height()),
                         space_before,
                         false,
                         [key, text, x](QPainter& p, QPointF at) {
                             key.paint(p, at, PageStyle::quiet());
                             text.paint(p, at + QPointF(x, 0.0));
                         },
                         {}});
    }

    const ReportDocument& document_;
    const PageStyle& style_;
    const FigurePainters& figures_;
    HeadingPages pages_;
    double width_;
};

constexpr std::size_t most_leading = 4;  // paragraphs

bool is_words(const ReportBlock& block) {
    return std::holds_alternative<ParagraphBlock>(block);
}

/// Whether a paragraph stays with what follows: one that leads from a heading to a table or chart, and one
/// that stands before the signature, which is not alone on a page.
bool leads(const std::vector<ReportBlock>& blocks, std::size_t at) {
    if (!is_words(blocks[at])) return false;
    std::size_t first = at, next = at + 1;
    while (first > 0 && is_words(blocks[first - 1])) --first;
    while (next < blocks.size() && is_words(blocks[next])) ++next;
    if (next == blocks.size() || next - at > most_leading) return false;
    if (std::holds_alternative<SignatureBlock>(blocks[next])) return true;
    const bool shown =
        std::holds_alternative<TableBlock>(blocks[next]) || std::holds_alternative<PlotBlock>(blocks[next]);
    return shown && first > 0 && std::holds_alternative<HeadingBlock>(blocks[first - 1]);
}

}  // namespace

std::vector<FlowItem> lay_out(const ReportDocument& document, const PageStyle& style,
                              const FigurePainters& figures, const HeadingPages& pages) {
    ReportLayout layout(document, style, figures, pages);
    append_title(layout.items, document, style, style.text_area().width());
    for (std::size_t i = 0; i < document.blocks.size();) {
        std::vector<const PlotBlock*> run;
        while (i < document.blocks.size() && std::holds_alternative<PlotBlock>(document.blocks[i]))
            run.push_back(&std::get<PlotBlock>(document.blocks[i++]));
        layout.plots(run);
        if (i == document.blocks.size()) break;
        std::visit(layout, document.blocks[i]);
        if (leads(document.blocks, i)) layout.items.back().keep_with_next = true;
        ++i;
    }
    return std::move(layout.items);
}

}  // namespace covaria::ui
