// The manual is whole: every page, field and picture is in it, and every link goes somewhere.
#include "core/manual/manual.h"
#include "core/document/document_writers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "core/base/resource_path.h"
#include "core/document/prose.h"
#include "core/kinds/registries.h"
#include "core/manual/help_page.h"
#include "core/manual/markdown.h"

namespace covaria::manual_test {

const ReportDocument& manual() {
    static const auto made =
        build_manual({{"run", "Evaluate a project", {{"--out DIR", "folder for the results"}}}});
    EXPECT_TRUE(made) << (made ? "" : made.error().message.english());
    return *made;
}

std::multiset<std::string> found(const std::string& html, const char* pattern) {
    const std::regex wanted(pattern);
    std::multiset<std::string> all;
    for (auto it = std::sregex_iterator(html.begin(), html.end(), wanted); it != std::sregex_iterator(); ++it)
        all.insert((*it)[1]);
    return all;
}

TEST(Manual, HasEveryFieldOfEveryModelAndAsset) {
    const std::multiset<std::string> ids = found(to_html(manual()), " id=\"([^\"]+)\"");
    std::size_t fields = 0;
    const auto check = [&](const std::string& page, const SetupSchema& schema) {
        EXPECT_EQ(ids.count(page), 1u) << page;
        for (const FieldSpec& field : schema.fields()) {
            EXPECT_EQ(ids.count(field_anchor(page, field.key)), 1u) << page << ": " << field.key;
            for (const ColumnSpec& column : field.columns)
                EXPECT_EQ(ids.count(field_anchor(page, field.key, column.key)), 1u)
                    << page << ": " << field.key << ", " << column.key;
            ++fields;
        }
    };
    for (const ModelDescriptor& model : model_registry()) check("model-" + model.id, model.schema);
    for (const AssetDescriptor& asset : asset_registry()) check("asset-" + asset.kind, asset.schema);
    EXPECT_GT(fields, 100u);
}

TEST(Manual, EveryLinkGoesSomewhereAndNoAnchorIsThereTwice) {
    const std::string html = to_html(manual());
    const std::multiset<std::string> ids = found(html, " id=\"([^\"]+)\"");
    for (const std::string& id : ids) EXPECT_EQ(ids.count(id), 1u) << id;
    const std::multiset<std::string> links = found(html, "href=\"#([^\"]+)\"");
    EXPECT_GT(links.size(), 100u);
    for (const std::string& link : links) EXPECT_EQ(ids.count(link), 1u) << link;
    EXPECT_TRUE(found(html, "href=\"([^#h][^\"]*)\"").empty()) << "a link to a file beside the manual";
}

TEST(Manual, HasAPictureOfEveryExampleInItself) {
    std::size_t examples = 0;
    const std::filesystem::path projects = data_directory() / "projects";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(projects))
        examples += entry.path().extension() == ".covaria";
    std::set<std::string> pictures;
    for (const ReportBlock& block : manual().blocks)
        if (const auto* picture = std::get_if<PictureBlock>(&block);
            picture && picture->file.generic_string().find("/projects/") != std::string::npos)
            pictures.insert(picture->file.filename().string());
    EXPECT_EQ(pictures.size(), examples);
    EXPECT_EQ(found(to_html(manual()), "<img src=\"(?!data:image/png;base64,iVBOR)([^\"]*)").size(), 0u);
}

TEST(Manual, TheCommandLineIsInIt) {
    const std::string html = to_html(manual());
    EXPECT_NE(html.find("covaria run</h3>"), std::string::npos);
    EXPECT_NE(html.find("<code>--out DIR</code>: folder for the results"), std::string::npos);
}

TEST(Glossary, EveryTermIsInOrderAndSaysWhatItIs) {
    const auto page = shipped_page("glossary");
    ASSERT_TRUE(page);
    std::vector<std::string> terms;
    for (std::size_t i = 0; i < page->blocks.size(); ++i) {
        const auto* heading = std::get_if<HeadingBlock>(&page->blocks[i]);
        if (!heading || heading->level != 2) continue;
        ASSERT_LT(i + 1, page->blocks.size());
        const auto* words = std::get_if<ProseBlock>(&page->blocks[i + 1]);
        ASSERT_TRUE(words) << heading->text;
        EXPECT_GT(prose_words(words->spans).size(), 40u) << heading->text;
        terms.push_back(anchor_words(heading->text));
    }
    EXPECT_GE(terms.size(), 40u);
    EXPECT_TRUE(std::is_sorted(terms.begin(), terms.end()));
    for (const char* term : {"measurand", "standard-uncertainty", "coverage-factor",
                             "effective-degrees-of-freedom", "sensitivity-coefficient", "index",
                             "combined-standard-uncertainty", "probability-density-function"})
        EXPECT_NE(std::find(terms.begin(), terms.end(), term), terms.end()) << term;
}

/// The parts that a translation shares with its page: kinds of blocks, places, sizes of tables, code words.
std::vector<std::string> frame_of(const std::vector<ReportBlock>& blocks) {
    std::vector<std::string> frame;
    std::multiset<std::string> code;
    const auto take_code = [&](const std::vector<ProseSpan>& spans) {
        for (const ProseSpan& span : spans)
            if (span.code) code.insert(span.text);
    };
    for (const ReportBlock& block : blocks) {
        std::string words = std::to_string(block.index());
        if (const auto* heading = std::get_if<HeadingBlock>(&block))
            words += " " + std::to_string(heading->level) + " " + heading->anchor;
        if (const auto* prose = std::get_if<ProseBlock>(&block)) {
            words += " " + prose->mark;
            take_code(prose->spans);
        }
        if (const auto* table = std::get_if<TableBlock>(&block))
            words +=
                " " + std::to_string(table->table.columns.size()) + "x" + std::to_string(table->table.rows);
        frame.push_back(words);
    }
    frame.insert(frame.end(), code.begin(), code.end());
    return frame;
}

TEST(HelpPages, TranslationsHaveTheBlocksAndPlacesOfTheirPages) {
    std::size_t translations = 0;
    const std::filesystem::path folder = data_directory() / "resources" / "help";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (!entry.is_directory()) continue;
        const std::string code = entry.path().filename().string();
        const DocumentLanguage language(code, {}, [](const std::string& text) { return text; });
        for (const auto& file : std::filesystem::directory_iterator(entry.path())) {
            const std::string page = file.path().stem().string();
            const auto english = shipped_page(page), translated = shipped_page(page, language);
            ASSERT_TRUE(english && translated) << file.path();
            EXPECT_EQ(frame_of(translated->blocks), frame_of(english->blocks)) << file.path();
            EXPECT_NE(translated->title, "");
            ++translations;
        }
    }
    EXPECT_GE(translations, 16u);
}

TEST(HelpPages, FieldsAreInTheLanguage) {
    const DocumentLanguage brackets("xx", {}, [](const std::string& text) { return "[" + text + "]"; });
    const auto pages = help_pages(brackets);
    ASSERT_TRUE(pages);
    for (const HelpPage& page : *pages)
        for (const ReportBlock& block : page.blocks)
            if (const auto* prose = std::get_if<ProseBlock>(&block);
                prose && prose->anchor.find("-field-") != std::string::npos) {
                EXPECT_TRUE(prose->spans.front().text.starts_with("[")) << prose_words(prose->spans);
                EXPECT_TRUE(prose->spans.back().text.empty() || prose->spans.back().text.starts_with(": ["))
                    << prose_words(prose->spans);
            }
}

TEST(Markdown, ReadsWhatHelpPagesHave) {
    const auto blocks = blocks_of_markdown(
        "# A page\n\nWords **strong** and *less*,\n`a_1*b` and [there](results.md#b).\n\n* first\n  goes "
        "on\n* second\n\n"
        "| a | b |\n|---|---|\n| 1 | `x\\|y` |\n\n    code  = 1\n\n## A *page* again\n",
        "p");
    ASSERT_EQ(blocks.size(), 7u);
    EXPECT_EQ(std::get<HeadingBlock>(blocks[0]).anchor, "p");
    EXPECT_EQ(
        prose_html(std::get<ProseBlock>(blocks[1]).spans, Links::shown),
        "Words <b>strong</b> and <i>less</i>, <code>a_1*b</code> and <a href=\"results.md#b\">there</a>.");
    EXPECT_EQ(prose_words(std::get<ProseBlock>(blocks[2]).spans), "first goes on");
    EXPECT_EQ(std::get<ProseBlock>(blocks[3]).mark, "–");
    const Table& table = std::get<TableBlock>(blocks[4]).table;
    ASSERT_EQ(table.columns.size(), 2u);
    EXPECT_EQ(table.columns[1].key, "b");
    EXPECT_EQ(std::get<std::string>(table.columns[1].cell(0)), "x|y");
    EXPECT_EQ(std::get<CodeBlock>(blocks[5]).text, "code  = 1");
    EXPECT_EQ(std::get<HeadingBlock>(blocks[6]).anchor, "p-a-page-again");
}

TEST(Markdown, MarksThatMarkNothingAreLetters) {
    EXPECT_EQ(prose_words(spans_of_markdown("a * b, [0, 1), 2*3 ` and [x]")), "a * b, [0, 1), 2*3 ` and [x]");
}

}  // namespace covaria::manual_test
