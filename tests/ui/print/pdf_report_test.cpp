// The PDF read back as text: title, numbers, page numbers, repeated heads of long tables, both paper sizes.
#include "ui/print/pdf_report.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <iterator>
#include <sstream>

#include "core/text/text.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"

namespace covaria::ui::pdf_report_test {
namespace {

class PdfReport : public testing::Test {
protected:
    static PdfOptions options(PaperSize paper = PaperSize::a4) {
        PdfOptions made;
        made.paper = paper;
        made.paint_plot = [](QPainter& painter, const QRectF& rect, const PlotSpecification& plot) {
            painter.drawRect(rect);
            painter.drawText(rect, Qt::AlignCenter, QString::fromStdString(plot.id));
        };
        made.render_scene = [](const SceneBlock&, QSize size) {
            QImage image(size, QImage::Format_RGB32);
            image.fill(Qt::lightGray);
            return image;
        };
        return made;
    }

    /// Output of a tool of poppler-utils; a missing tool is a failure.
    std::string output_of(const QString& tool, QStringList arguments, const ReportDocument& document,
                          const PdfOptions& chosen) {
        const std::string file = folder_.filePath("report.pdf").toStdString();
        const auto written = write_pdf(document, chosen, file);
        EXPECT_TRUE(written) << written.error().message.english();
        QProcess process;
        arguments.replaceInStrings("FILE", QString::fromStdString(file));
        process.start(tool, arguments);
        EXPECT_TRUE(process.waitForStarted())
            << tool.toStdString() << " (package poppler-utils) is not installed";
        EXPECT_TRUE(process.waitForFinished(60'000));
        EXPECT_EQ(process.exitCode(), 0);
        return process.readAllStandardOutput().toStdString();
    }

    std::string text_of(const ReportDocument& document, const PdfOptions& chosen) {
        return output_of("pdftotext", {"-layout", "FILE", "-"}, document, chosen);
    }

    QTemporaryDir folder_;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::vector<std::string> pages_of(const std::string& text) {
    std::vector<std::string> pages;
    std::istringstream stream(text);
    for (std::string page; std::getline(stream, page, '\f');) pages.push_back(page);
    return pages;
}

TEST_F(PdfReport, TitleTextAndNumbersReadBack) {
    const ReportDocument document = test::sample_report();
    const std::string text = text_of(document, options());
    for (const char* part :
         {"Stewart platform <test & trial>", "Table 1. Expanded uncertainty U", "−119.00",
          "18446744073709551615", "0123456789abcdef", "1.1 Pose from points", "Figure 1. ", "within 1 %"})
        EXPECT_TRUE(contains(text, part)) << part;
}

/// The tool reads the narrow spaces between groups of digits as some space or as none.
std::string without_spaces(std::string text) {
    for (const std::string space : {" ", "\u2002", "\u202f", "\u2009", "\u00a0"})
        for (std::size_t at = 0; (at = text.find(space, at)) != std::string::npos;)
            text.erase(at, space.size());
    return text;
}

TEST_F(PdfReport, EveryNumberOfEveryTableIsPrinted) {
    const ReportDocument document = test::sample_report({1, 3, 3, true, "pose"});
    const std::string text = without_spaces(text_of(document, options()));
    for (const ReportBlock& block : document.blocks) {
        const auto* table = std::get_if<TableBlock>(&block);
        if (!table) continue;
        for (std::size_t r = 0; r < table->table.rows; ++r)
            for (std::size_t c = 0; c < table->table.shown_columns(); ++c)
                if (test::is_number(*table, r, c)) {
                    const std::string cell = to_html(test::typeset_cell(*table, r, c));
                    ASSERT_TRUE(contains(text, without_spaces(cell)))
                        << table->table.title << " row " << r << ": " << cell;
                }
    }
}

TEST_F(PdfReport, WordsStayWithTheTableTheyLeadTo) {
    for (int before = 20; before < 70; ++before) {
        ReportDocument document;
        document.title = "Breaks";
        for (int i = 0; i < before; ++i) document.blocks.push_back(ListBlock{{"filling"}});
        document.blocks.push_back(HeadingBlock{2, "Heading"});
        document.blocks.push_back(ParagraphBlock{"This leads to the table."});
        TableBlock table;
        table.table.title = "Caption of the table";
        table.table.add("value").title = "value";
        for (const std::string word : {"first", "second"}) table.table.row({word});
        document.blocks.push_back(table);
        document.blocks.push_back(ParagraphBlock{"Before the signature."});
        document.blocks.push_back(SignatureBlock{"statement", "date", "name", "function", "The end."});
        for (const std::string& page : pages_of(text_of(document, options()))) {
            EXPECT_EQ(contains(page, "This leads"), contains(page, "Caption of the table")) << before;
            EXPECT_EQ(contains(page, "Before the signature"), contains(page, "The end.")) << before;
        }
        before += 4;
    }
}

/// A table of so many columns of numbers behind two of text.
ReportDocument with_wide_table(int columns) {
    TableBlock block;
    const auto add = [&block](const std::string& head) -> Column& {
        Column& column = block.table.add(head);
        column.title = head;
        return column;
    };
    add("Quantity");
    add("Unit");
    std::vector<Cell> row{std::string("x"), std::string("mm")};
    for (int c = 0; c < columns; ++c) {
        add("uncertainty measurements" + std::to_string(c)).fixed(4);
        row.emplace_back(100.0 + c);
    }
    add("Verdict");
    row.emplace_back(std::string("normal as far as so few trials can tell"));
    for (int i = 0; i < 2; ++i) block.table.row(row);
    ReportDocument document;
    document.title = "Wide";
    document.blocks = {block};
    return document;
}

TEST_F(PdfReport, NeitherNumbersTouchNorWordsBreakHoweverManyColumns) {
    for (const int columns : {3, 8, 12, 30}) {
        std::istringstream words(text_of(with_wide_table(columns), options()));
        const std::vector<std::string> found{std::istream_iterator<std::string>(words), {}};
        const auto times = [&](const std::string& word) {
            return std::count(found.begin(), found.end(), word);
        };
        for (int c = 0; c < columns; ++c) {
            EXPECT_EQ(times(std::to_string(100 + c) + ".0000"), 2) << columns << " columns";
            EXPECT_EQ(times("measurements" + std::to_string(c)), 1) << columns << " columns";
        }
        EXPECT_EQ(times("Quantity"), times("Unit"));
        EXPECT_EQ(times("Quantity") > 1, columns > 3) << "keys are repeated where there are several parts";
    }
}

TEST_F(PdfReport, EveryPageSaysWhichOfHowManyItIs) {
    const std::vector<std::string> pages = pages_of(text_of(test::sample_report(), options()));
    ASSERT_GT(pages.size(), 5U);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const std::string words = "Page " + std::to_string(i + 1) + " of " + std::to_string(pages.size());
        EXPECT_TRUE(contains(pages[i], words)) << words;
        EXPECT_TRUE(contains(pages[i], "Stewart platform")) << "running head of page " << i + 1;
    }
}

TEST_F(PdfReport, ACertificateHasItsNumberOnEveryPageAndAnEnd) {
    Project project = test::sample_project();
    project.certificate.number = "2026-0417";
    project.certificate.serial_number = "A_7";
    project.certificate.authorised_by = "E. Muster";
    const auto result = test::sample_result({40, 3, 3, false, "pose"});
    const ReportDocument document =
        build_certificate(*MadeProject::make(project), {test::sample_analysis(result)});
    const std::vector<std::string> pages = pages_of(text_of(document, options()));
    ASSERT_EQ(pages.size(), 3U) << "240 results";
    for (std::size_t i = 0; i < pages.size(); ++i) {
        EXPECT_TRUE(contains(pages[i], "Calibration certificate 2026-0417")) << i;
        EXPECT_TRUE(contains(pages[i], "Page " + std::to_string(i + 1) + " of 3")) << i;
    }
    EXPECT_TRUE(contains(pages.front(), "A_7")) << "as it was typed";
    EXPECT_TRUE(contains(pages.front(), "not stated"));
    EXPECT_TRUE(contains(pages.back(), "E. Muster"));
    EXPECT_TRUE(contains(pages.back(), "End of certificate 2026-0417"));
}

/// Boxes instead of letters would be no document.
TEST_F(PdfReport, ALanguageWithoutAFontIsRefused) {
    ReportDocument document = test::sample_report();
    const auto file = folder_.filePath("report.pdf").toStdString();
    document.language = "de";
    EXPECT_TRUE(write_pdf(document, options(), file));
    document.language = "ko";
    const auto written = write_pdf(document, options(), file);
    EXPECT_EQ(written.has_value(), !QFontDatabase::families(QFontDatabase::Korean).isEmpty());
    if (!written) {
        EXPECT_TRUE(contains(written.error().message.english(), "fonts-noto-cjk"))
            << written.error().message.english();
    }
}

TEST_F(PdfReport, TheLogoIsAPictureOfTheFirstPage) {
    ReportDocument document = test::sample_report();
    const auto pictures_on_page_1 = [&] {
        const std::string list =
            output_of("pdfimages", {"-list", "-f", "1", "-l", "1", "FILE"}, document, options());
        return std::count(list.begin(), list.end(), '\n') - 2;  // under its head
    };
    const auto without = pictures_on_page_1();
    QImage logo(40, 12, QImage::Format_RGB32);
    logo.fill(Qt::blue);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    ASSERT_TRUE(logo.save(&buffer, "PNG"));
    document.logo = {bytes.toStdString(), "image/png"};
    EXPECT_EQ(pictures_on_page_1(), without + 1);
    document.logo.bytes.resize(20);
    EXPECT_EQ(pictures_on_page_1(), without) << "a damaged one is left out";
}

TEST_F(PdfReport, LongTablesRepeatTheirHeadsOnEveryPage) {
    ReportDocument document;
    document.title = document.running_head = "Long table";
    TableBlock block;
    block.table.title = "Table 1. Many rows";
    block.continued = "Table 1, continued";
    block.table.add("name").title = "Name of the row";
    block.table.add("value").figure(3).title = "Value";
    for (int i = 0; i < 200; ++i) block.table.row({"row " + std::to_string(i), 0.001 * i});
    document.blocks = {block};
    const std::vector<std::string> pages = pages_of(text_of(document, options()));
    ASSERT_GE(pages.size(), 3U);
    for (const std::string& page : pages) EXPECT_TRUE(contains(page, "Name of the row"));
    EXPECT_TRUE(contains(pages.front(), "Table 1. Many rows"));
    EXPECT_FALSE(contains(pages[1], "Table 1. Many rows"));
    EXPECT_FALSE(contains(pages.front(), "continued"));
    for (std::size_t i = 1; i < pages.size(); ++i) EXPECT_TRUE(contains(pages[i], "Table 1, continued")) << i;
    EXPECT_TRUE(contains(pages.back(), "row 199"));
}

TEST_F(PdfReport, IsAnArchiveThatCarriesItsFilesAndIsMadeTwiceWithEqualBytes) {
    const ReportDocument document = test::sample_report({1, 3, 3, true, "pose"});
    PdfOptions chosen = options();
    chosen.attached = {{"data.csv", "a,b", "text/csv", "A table"}};
    const auto bytes = pdf_bytes(document, chosen);
    ASSERT_TRUE(bytes) << bytes.error().message.english();
    EXPECT_EQ(*bytes, *pdf_bytes(document, chosen));
    for (const char* part : {"%PDF-1.7", "<pdfaid:part>3<", "<pdfaid:conformance>B<", "/AFRelationship /Data",
                             "/GTS_PDFA1", "/OutputIntents", "Stewart platform &lt;test &amp; trial&gt;"})
        EXPECT_TRUE(contains(*bytes, part)) << part;
    for (const char* part : {"/JavaScript", "/Encrypt", "/CIDSet", "/Interpolate true", "/CreationDate"})
        EXPECT_FALSE(contains(*bytes, part)) << part;
    EXPECT_EQ(files_in_pdf(*bytes)->at(0).bytes, "a,b");
    std::istringstream fonts(output_of("pdffonts", {"FILE"}, document, chosen));
    std::string line;
    std::getline(fonts, line);
    const std::size_t embedded = line.find("emb");
    ASSERT_NE(embedded, std::string::npos);
    std::getline(fonts, line);
    int count = 0;
    for (; std::getline(fonts, line); ++count) EXPECT_EQ(line.substr(embedded, 3), "yes") << line;
    EXPECT_GT(count, 0);
}

TEST_F(PdfReport, BookmarksLeadToTheHeadings) {
    const ReportDocument document = test::sample_report();
    const std::string outline =
        output_of("pdftohtml", {"-xml", "-i", "-stdout", "FILE"}, document, options());
    const std::vector<std::string> pages = pages_of(text_of(document, options()));
    std::size_t at = outline.find("<outline>"), count = 0;
    ASSERT_NE(at, std::string::npos) << outline.substr(0, 2000);
    for (const ReportBlock& block : document.blocks) {
        const auto* heading = std::get_if<HeadingBlock>(&block);
        if (!heading || heading->level > 2) continue;
        const std::string title = heading->text.substr(heading->text.find("\u2002") + 3);
        const std::string words = title.substr(0, title.find(' '));
        at = outline.find("<item page=\"", at);
        ASSERT_NE(at, std::string::npos) << title;
        at += std::string("<item page=\"").size();
        const std::size_t page = std::stoul(outline.substr(at, 6));
        EXPECT_TRUE(contains(outline.substr(at, outline.find('\n', at) - at), words)) << title;
        ASSERT_LE(page, pages.size());
        EXPECT_TRUE(contains(pages[page - 1], words)) << title << " on page " << page;
        ++count;
    }
    EXPECT_GT(count, 10U);
    EXPECT_EQ(outline.find("<item page=", at), std::string::npos) << "no others";
}

TEST_F(PdfReport, ADocumentWithoutHeadingsHasNoBookmarks) {
    const auto plain = pdf_bytes(ReportDocument{}, options());
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->find("/Outlines"), std::string::npos);
}

/// The links of a page as pdftohtml writes them: the page they lead to and their words.
std::vector<std::pair<std::size_t, std::string>> links_in(const std::string& xml) {
    std::vector<std::pair<std::size_t, std::string>> links;
    for (std::size_t at = xml.find("<a href=\""); at != std::string::npos;
         at = xml.find("<a href=\"", at + 1)) {
        const std::size_t hash = xml.find('#', at), begin = xml.find('>', at) + 1,
                          end = xml.find("</a>", begin);
        std::string words = xml.substr(begin, end - begin);
        for (const std::string tag : {"<b>", "</b>"})
            if (const std::size_t bold = words.find(tag); bold != std::string::npos)
                words.erase(bold, tag.size());
        links.emplace_back(std::stoul(xml.substr(hash + 1, 8)), words);
    }
    return links;
}

TEST_F(PdfReport, LinesOfTheContentsLeadToTheirHeadings) {
    const ReportDocument document = test::sample_report();
    const std::string xml = output_of("pdftohtml", {"-xml", "-i", "-stdout", "FILE"}, document, options());
    const std::vector<std::string> pages = pages_of(text_of(document, options()));
    const auto links = links_in(xml);
    std::size_t headings = 0, numbers = 0;
    for (const ReportBlock& block : document.blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && heading->level <= 2)
            ++headings;
    ASSERT_GE(links.size(), headings) << "its words, its page number";
    for (const auto& [page, words] : links) {
        ASSERT_LE(page, pages.size());
        ASSERT_GE(page, 1u);
        if (words.find_first_not_of("0123456789") == std::string::npos) {
            EXPECT_EQ(std::stoul(words), page) << "the number beside the line";
            ++numbers;
        } else {
            const std::string on_page = escape_html(without_spaces(pages[page - 1]));  // in the words of XML
            EXPECT_TRUE(contains(on_page, without_spaces(words))) << words << " on page " << page;
        }
    }
    EXPECT_EQ(numbers, headings) << "every line has one";
}

TEST_F(PdfReport, SaysItsLanguageAndItsAuthor) {
    ReportDocument document = test::sample_report({1, 3, 3, false, "pose"});
    document.author = "E. Muster & Söhne";
    document.language = "de";
    const auto bytes = pdf_bytes(document, options());
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(contains(*bytes, "/Lang (de)"));
    EXPECT_TRUE(contains(*bytes, "E. Muster &amp; Söhne</rdf:li></rdf:Seq></dc:creator>"));
    EXPECT_TRUE(contains(output_of("pdfinfo", {"FILE"}, document, options()), "E. Muster & Söhne"));
}

/// Who copies an equation, or has it read aloud, needs every sign of it.
TEST_F(PdfReport, TallParenthesesOfAnEquationAreText) {
    using K = Formula::Kind;
    const auto symbol = [](const char* base) { return Formula::of_symbol({base, "", ""}); };
    const auto of = [](K kind, std::vector<Formula> parts) {
        Formula f = Formula::row(std::move(parts));
        f.kind = kind;
        return f;
    };
    Formula fence =
        of(K::fence, {of(K::fraction, {symbol("a"), of(K::fraction, {symbol("b"), symbol("c")})})});
    for (const char* mark : {"(", "|"}) {
        fence.text = mark;
        ReportDocument document;
        document.title = "Equation";
        document.blocks = {EquationBlock{
            "text", "", of(K::row, {symbol("y"), Formula::leaf(K::sign, "="), fence, symbol("d")})}};
        const std::string text = text_of(document, options());
        const std::string closing = *mark == '(' ? ")" : "|";
        EXPECT_TRUE(contains(text, mark)) << text;
        EXPECT_NE(text.find(closing, text.find(mark) + 1), std::string::npos) << text;
        const std::string in_order =
            without_spaces(output_of("pdftotext", {"-raw", "FILE", "-"}, document, options()));
        const std::size_t open = in_order.find(mark);
        ASSERT_NE(open, std::string::npos);
        EXPECT_LT(in_order.find("y"), open) << in_order;
        EXPECT_LT(in_order.find("c", open), in_order.find(closing, open + 1)) << in_order;
        EXPECT_NE(in_order.find("d", in_order.find(closing, open + 1)), std::string::npos) << in_order;
    }
}

TEST_F(PdfReport, BothPaperSizes) {
    ReportDocument document;
    document.title = "Paper";
    EXPECT_TRUE(contains(output_of("pdfinfo", {"FILE"}, document, options(PaperSize::a4)), "A4"));
    EXPECT_TRUE(contains(output_of("pdfinfo", {"FILE"}, document, options(PaperSize::letter)), "612 x 792"));
}

TEST_F(PdfReport, PictureThatCouldNotBeDrawnIsAdmitted) {
    PdfOptions chosen = options();
    chosen.render_scene = [](const SceneBlock&, QSize) { return QImage(); };
    ReportDocument document;
    document.title = "No picture";
    document.blocks = {SceneBlock{"scene", "typed", "pose 1", "iso", "Figure 1. The platform."}};
    EXPECT_TRUE(contains(text_of(document, chosen), "The picture could not be drawn."));
}

TEST_F(PdfReport, MissingPaintersAndUnwritableFoldersAreErrors) {
    ReportDocument document;
    document.blocks = {PlotBlock{}};
    const auto without = pdf_bytes(document, PdfOptions{});
    ASSERT_FALSE(without);
    EXPECT_EQ(without.error().code, ErrorCode::usage);
    const auto written = write_pdf(ReportDocument{}, options(), "/nonexistent/folder/report.pdf");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::io);
}

}  // namespace
}  // namespace covaria::ui::pdf_report_test
