// Symbols in tables, heads and lists have real subscripts, while models and clipboard keep plain text.
#include "ui/theme/typeset_views.h"

#include <gtest/gtest.h>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTableView>

#include "core/text/symbol.h"
#include "tests/ui/qt_application.h"
#include "ui/theme/fonts.h"
#include "ui/theme/label_text.h"
#include "ui/theme/quiet_table.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui::typeset_test {
namespace {

QImage picture_of(QWidget& widget, const QSize& size = {160, 60}) {
    widget.resize(size);
    widget.ensurePolished();
    return widget.grab().toImage();
}

/// The lowest row with ink of the text's colour, counted from the top.
int lowest_ink(const QImage& image) {
    for (int y = image.height() - 1; y >= 0; --y)
        for (int x = 0; x < image.width(); ++x)
            if (qGray(image.pixel(x, y)) < 110) return y;
    return -1;
}

QImage cell(const QString& text, QAbstractItemDelegate* delegate) {
    QStandardItemModel model(1, 1);
    model.setData(model.index(0, 0), text);
    QTableView view;
    view.setShowGrid(false);
    view.setFrameShape(QFrame::NoFrame);
    view.horizontalHeader()->hide();
    view.verticalHeader()->hide();
    if (delegate) view.setItemDelegate(delegate);
    view.setModel(&model);
    return picture_of(view);
}

class Typeset : public testing::Test {
protected:
    Typeset() { apply_theme(*qApp, Theme::light()); }
};

TEST_F(Typeset, WhatAModelGivesAsTextIsDrawnAsSuch) {
    QStandardItemModel model(2, 1);
    model.setData(model.index(0, 0), QStringLiteral("b₁"));
    model.setData(model.index(0, 0), QVariant::fromValue(symbol_text("b_1")), typeset_role);
    model.setData(model.index(1, 0), QStringLiteral("b_1"));
    QTableView view;
    view.setShowGrid(false);
    TypesetDelegate delegate;
    view.setItemDelegate(&delegate);
    view.setModel(&model);
    const QImage image = picture_of(view, {240, 160});
    const auto row = [&](int r) {
        return image.copy(view.visualRect(model.index(r, 0)).translated(view.viewport()->pos()));
    };
    EXPECT_EQ(row(0), row(1));
}

TEST_F(Typeset, ATextWithoutScriptsTakesThePlaceOfTheCellsToo) {
    QStandardItemModel model(1, 1);
    model.setData(model.index(0, 0), QStringLiteral("theta"));
    model.setData(model.index(0, 0), QVariant::fromValue(symbol_text("theta")), typeset_role);
    QTableView view;
    TypesetDelegate delegate;
    view.setItemDelegate(&delegate);
    view.setModel(&model);
    QStandardItemModel letter(1, 1);
    letter.setData(letter.index(0, 0), QStringLiteral("anything"));
    letter.setData(letter.index(0, 0), QVariant::fromValue(symbol_text("theta")), typeset_role);
    QTableView plain;
    plain.setItemDelegate(&delegate);
    plain.setModel(&letter);
    EXPECT_EQ(picture_of(view, {240, 160}), picture_of(plain, {240, 160}));
}

TEST_F(Typeset, CellsAreDrawnWithLoweredLetters) {
    TypesetDelegate delegate;
    const QImage plain = cell(QStringLiteral("b_1z"), nullptr);
    const QImage typeset = cell(QStringLiteral("b_1z"), &delegate);
    EXPECT_NE(plain, typeset);
    const int line = lowest_ink(cell(QStringLiteral("b"), &delegate));
    EXPECT_GT(lowest_ink(typeset), line) << "the subscript hangs below the line";
    EXPECT_EQ(cell(QStringLiteral("length"), nullptr), cell(QStringLiteral("length"), &delegate))
        << "other text looks as ever";
}

TEST_F(Typeset, HeadsAreDrawnWithLoweredLetters) {
    const auto head = [](const QString& text, bool typeset) {
        QStandardItemModel model(0, 1);
        model.setHorizontalHeaderItem(0, new QStandardItem(text));
        QTableView view;
        if (typeset) view.setHorizontalHeader(new TypesetHeader(Qt::Horizontal, &view));
        view.setModel(&model);
        view.horizontalHeader()->setHighlightSections(false);
        view.resize(200, 80);
        return view.horizontalHeader()->grab().toImage();
    };
    EXPECT_NE(head(QStringLiteral("u_y / mm"), true), head(QStringLiteral("u_y / mm"), false));
    EXPECT_EQ(head(QStringLiteral("Unit"), true).isNull(), false);
}

TEST_F(Typeset, HeadsLeaveRoomForTheText) {
    QStandardItemModel model(0, 2);
    model.setHorizontalHeaderItem(0, new QStandardItem(QStringLiteral("u_one,two,three,four")));
    TypesetHeader header(Qt::Horizontal);
    header.setModel(&model);
    header.ensurePolished();  // heads have letters of their own size
    const double width = text_width(running_text("u_one,two,three,four"), header.font());
    EXPECT_GE(header.sectionSizeHint(0), width);
    EXPECT_LE(header.sectionSizeHint(0), width + 40);
}

TEST_F(Typeset, ComboBoxesAreDrawnWithLoweredLetters) {
    TypesetComboBox typeset;
    QComboBox plain;
    for (QComboBox* box : {static_cast<QComboBox*>(&typeset), &plain}) {
        box->addItem(QStringLiteral("p_1x,1"));
        box->addItem(QStringLiteral("mean"));
    }
    EXPECT_NE(picture_of(typeset), picture_of(plain));
    EXPECT_EQ(typeset.currentText(), QStringLiteral("p_1x,1"));
    typeset.setCurrentIndex(1);
    plain.setCurrentIndex(1);
    EXPECT_EQ(picture_of(typeset), picture_of(plain));
}

/// A view of one column of that width with its head, of which 160 pixels are seen.
QImage cut_column(const QString& text, Qt::Alignment alignment, int width, const QString& head) {
    QStandardItemModel model(1, 1);
    model.setHorizontalHeaderLabels({head});
    model.setData(model.index(0, 0), text);
    model.setData(model.index(0, 0), int(alignment | Qt::AlignVCenter), Qt::TextAlignmentRole);
    QTableView view;
    view.setShowGrid(false);
    view.setFrameShape(QFrame::NoFrame);
    view.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view.verticalHeader()->hide();
    view.setHorizontalHeader(new TypesetHeader(Qt::Horizontal, &view));
    view.setItemDelegate(new TypesetDelegate(&view, Qt::ElideRight));
    view.setModel(&model);
    view.setColumnWidth(0, width);
    return picture_of(view);
}

TEST_F(Typeset, WhatTheEdgeOfAViewCutsIsDrawnAsIfItEndedThere) {
    const QString number = QStringLiteral("12.5"),
                  words = QStringLiteral("in the middle of a long text, really");
    for (const auto& [text, alignment] : {std::pair(number, Qt::AlignRight), std::pair(words, Qt::AlignLeft)})
        EXPECT_EQ(cut_column(text, alignment, 400, {}), cut_column(text, alignment, 160, {})) << to_std(text);
    const int margin = qApp->style()->pixelMetric(QStyle::PM_HeaderMargin);
    const Text fits =
        shortened(running_text(to_std(words)), QApplication::font("QHeaderView"), 160 - 2 * margin);
    EXPECT_TRUE(fits.letters().find("…") != std::string::npos);
    EXPECT_EQ(cut_column({}, Qt::AlignLeft, 400, words),
              cut_column({}, Qt::AlignLeft, 400, to_qt(to_unicode(fits))));
    const QString digits = QStringLiteral("123456789012345678901234567890");
    EXPECT_EQ(cut_column(digits, Qt::AlignRight, 400, {}),
              cut_column(QStringLiteral("…"), Qt::AlignRight, 400, {}))
        << "a part of a number is another number";
}

/// Scrolled, or under a column that stays: the digits that remain of a number would be another one.
TEST_F(Typeset, WhatIsCutAtTheLeftIsNoPartOfANumber) {
    const auto scrolled = [](const QString& number, int by, int covered) {
        QStandardItemModel model(1, 2);
        auto* item = new QStandardItem(number);
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        model.setItem(0, 0, item);
        QTableView view;
        view.setItemDelegate(new TypesetDelegate(&view));
        view.setHorizontalScrollMode(QTableView::ScrollPerPixel);
        view.setModel(&model);
        view.setColumnWidth(0, 160);
        view.setColumnWidth(1, 400);
        view.setProperty(covered_width, covered);
        view.verticalHeader()->hide();
        picture_of(view);  // laid out
        view.horizontalScrollBar()->setValue(by);
        return picture_of(view);
    };
    const QString digits = QStringLiteral("123456789012"), none = QStringLiteral("…");
    EXPECT_NE(scrolled(digits, 0, 0), scrolled(none, 0, 0)) << "there is room for it";
    EXPECT_EQ(scrolled(digits, 110, 0), scrolled(none, 110, 0));
    EXPECT_EQ(scrolled(digits, 10, 100), scrolled(none, 10, 100));
    EXPECT_NE(scrolled(digits, 10, 0), scrolled(none, 10, 0)) << "what is left has room for it";
}

// Quiet tables have no grid: the line below a row is the style's.
TEST_F(Typeset, LinesBelowRowsAreSeenInBothThemes) {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
        apply_theme(*qApp, theme);
        QStandardItemModel model(2, 1);
        QTableView view;
        make_quiet(view);
        view.horizontalHeader()->hide();
        view.verticalHeader()->hide();
        view.setModel(&model);
        const QImage image = picture_of(view, {240, 160});
        const QColor line = image.pixelColor(20, view.rowHeight(0) - 1);
        EXPECT_EQ(line, theme.tokens().line);
        EXPECT_EQ(image.pixelColor(20, view.rowHeight(0) / 2), theme.tokens().stage);
        EXPECT_GT(contrast(line, theme.tokens().stage), 1.25);
        EXPECT_LT(contrast(line, theme.tokens().stage), 2.0) << "quieter than the figures";
        EXPECT_GE(view.rowHeight(0), view.fontMetrics().height() + 12);
    }
    apply_theme(*qApp, Theme::light());
}

// Symbols are in the serif of formulae, where l, I and 1 differ.
TEST_F(Typeset, SymbolsAreSetInTheFontOfFormulae) {
    const QFont text = QApplication::font(), symbol = symbol_font(text);
    EXPECT_TRUE(symbol.italic());
    EXPECT_NE(symbol.families().value(0), text.families().value(0));
    EXPECT_NEAR(symbol.pointSizeF(), 1.14 * text.pointSizeF(), 0.02 * text.pointSizeF());
    EXPECT_EQ(formula_font(symbol).pointSizeF(), symbol.pointSizeF()) << "it grows once";
    EXPECT_DOUBLE_EQ(text_width(symbol_text("l"), text), QFontMetricsF(symbol).horizontalAdvance(u'l'));
    EXPECT_DOUBLE_EQ(text_width(Text("l"), text), QFontMetricsF(text).horizontalAdvance(u'l'));
}

TEST(Shortened, TextFitsAndKeepsItsSubscripts) {
    const QFont font = QApplication::font();
    const Text whole = symbol_text("d_Fx") + ", repeatability of channel Fx";
    for (const double part : {0.9, 0.6, 0.4}) {
        const Text shown = shortened(whole, font, part * text_width(whole, font));
        EXPECT_LE(text_width(shown, font), part * text_width(whole, font));
        EXPECT_GT(text_width(shown, font), 0.8 * part * text_width(whole, font));
        EXPECT_TRUE(shown.has_scripts()) << to_unicode(shown);
        EXPECT_TRUE(shown.letters().starts_with("dFx, ")) << shown.letters();
        EXPECT_TRUE(shown.letters().ends_with("Fx")) << shown.letters();
    }
    EXPECT_EQ(shortened(whole, font, text_width(whole, font)), whole);
    EXPECT_EQ(shortened(Text(), font, -1.0), Text());
    EXPECT_EQ(shortened("ü", font, 0.0), Text("…"));
}

TEST(Shortened, ANumberIsWholeOrNotThere) {
    const QFont font = QApplication::font();
    const Text whole = "a₁, Table 12\u202f345.6 (normal, 0.1789 mm)";
    for (double part = 0.1; part < 1.0; part += 0.02) {
        const std::string shown = shortened(whole, font, part * text_width(whole, font)).letters();
        const std::size_t cut = shown.find("…");
        ASSERT_NE(cut, std::string::npos);
        const std::string before = shown.substr(0, cut), after = shown.substr(cut + std::string("…").size());
        const auto has_digits = [](const std::string& text) {
            return text.find_first_of("0123456789") != std::string::npos;
        };
        EXPECT_EQ(has_digits(before), before.find("12\u202f345.6") != std::string::npos) << shown;
        EXPECT_EQ(has_digits(after), after.find("0.1789") != std::string::npos) << shown;
    }
}

TEST(Shortened, CharactersStayWhole) {
    const QFont font = QApplication::font();
    const Text whole = "a 5–10 mm, 6.1×10⁻⁵, −5 一12";
    for (double part = 0.05; part < 1.0; part += 0.01) {
        const std::string shown = shortened(whole, font, part * text_width(whole, font)).letters();
        EXPECT_FALSE(QString::fromStdString(shown).contains(QChar(QChar::ReplacementCharacter))) << shown;
        EXPECT_EQ(shown.find("10⁻") != std::string::npos || shown.find("⁵") != std::string::npos,
                  shown.find("6.1×10⁻⁵") != std::string::npos)
            << shown;
    }
}

TEST(Shortened, LabelsThatWouldLookAlikeAreCutWhereTheyAreAlike) {
    const QFont font = QApplication::font();
    const std::vector<Text> names{"d, comparator, random effects", "d, comparator, systematic effects",
                                  "theta"};
    const double room = text_width("d, compar…c effects", font);
    ASSERT_EQ(shortened(names[0], font, 0.6 * room), shortened(names[1], font, 0.6 * room)) << "middle cut";
    const std::vector<Text> apart = shortened_apart(names, font, 0.6 * room);
    EXPECT_NE(apart[0], apart[1]);
    EXPECT_EQ(apart[2], names[2]);
    for (const Text& label : apart) EXPECT_LE(text_width(label, font), 0.6 * room);
    EXPECT_EQ(shortened_apart({"alike", "alike"}, font, 0.0).front(), Text("…")) << "the same name twice";
}

TEST(TypesetLabels, HaveTheRoomOfTheirLettersInEveryRank) {
    QWidget strip;
    auto* row = new QHBoxLayout(&strip);
    auto* label = new TypesetLabel(TextSize::answer);
    row->addWidget(label);
    row->addStretch(1);
    label->show_text(Text("(49.999 926 ± 0.000 066) mm"));
    label->set_rank(3);
    strip.resize(900, 60);
    strip.show();
    QApplication::processEvents();
    const int faint = label->width();
    label->set_rank(1);
    QApplication::processEvents();
    EXPECT_GT(label->width(), faint) << "its letters are wider";
    EXPECT_GE(label->width(), label->sizeHint().width());
}

}  // namespace
}  // namespace covaria::ui::typeset_test
