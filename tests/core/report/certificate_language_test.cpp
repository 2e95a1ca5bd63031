// A certificate in another language: every word goes through it, and so do the numbers.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "core/document/document_writers.h"
#include "core/report/certificate_words.h"
#include "core/report/report.h"
#include "core/views/result_statement.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"

namespace covaria::certificate_language_test {
namespace {

/// Puts every text in brackets and remembers it.
struct Brackets {
    std::set<std::string> asked;
    DocumentLanguage language{"xx", {",", "."}, [this](const std::string& english) {
                                  asked.insert(english);
                                  return "[" + english + "]";
                              }};
};

struct Sample {
    int poses = 1, analyses = 1;
    bool monte_carlo = true, fixed_k = false, failed = false, tolerance = true;
};

ReportDocument certificate_of(const Sample& sample, const DocumentLanguage& in) {
    Project project = test::sample_project();
    project.certificate.number = "A.7";
    project.certificate.calibrated = "2026-04-17/2026-04-18";
    if (sample.tolerance)
        project.analyses[0].requirements = {
            {"pose 1", "x", {}, Quantity{-121.0, test::mm()}, Quantity{-117.0, test::mm()}, 0.83}};
    std::vector<EvaluatedAnalysis> analyses;
    for (int i = 0; i < sample.analyses; ++i) {
        UncertaintyResult changed = test::sample_result({sample.poses, 3, 3, false, "pose"});
        if (!sample.monte_carlo) changed.trials = 0;
        if (sample.fixed_k) changed.fixed_coverage_factor = 2.0;
        if (sample.failed) changed.failed_trials = changed.trials;
        analyses.push_back(test::sample_analysis(std::move(changed)));
    }
    return build_certificate(*MadeProject::make(project), analyses, {{"f", "failed one", {}, "why"}},
                             CertifiedResults::that_fit, in);
}

const std::vector<Sample>& samples() {
    static const std::vector<Sample> all{{},
                                         {40},
                                         {2},
                                         {1, 2},
                                         {1, 1, false},
                                         {1, 1, true, true},
                                         {1, 1, true, false, true},
                                         {1, 1, true, false, false, false}};
    return all;
}

bool is_said(const std::string& text) {
    return text.find('[') != std::string::npos;
}

/// Checks every block with words; names that people gave ("failed one", analyses) stand alone as heads only.
struct AllSaid {
    const ReportDocument& document;
    void operator()(const HeadingBlock& block) const {
        EXPECT_TRUE(is_said(block.text) || block.level == 3) << block.text;
    }
    void operator()(const ParagraphBlock& block) const { EXPECT_TRUE(is_said(block.text)) << block.text; }
    void operator()(const FactsBlock& block) const {
        for (const auto& [name, value] : block.facts) EXPECT_TRUE(is_said(name)) << name;
    }
    void operator()(const TableBlock& block) const {
        for (const Message& message : block.table.notes) {
            const std::string note = message.english();
            EXPECT_TRUE(is_said(note) || note.starts_with("k") || note.starts_with("p")) << note;
        }
    }
    void operator()(const SignatureBlock& block) const {
        EXPECT_TRUE(is_said(block.statement) && is_said(block.date) && is_said(block.end_mark));
        EXPECT_NE(block.end_mark.find("A.7"), std::string::npos) << "what was typed is put in";
    }
    template <class Other>
    void operator()(const Other&) const {
        ADD_FAILURE() << "a certificate has no such block";
    }
};

TEST(CertificateLanguage, EveryTextGoesThroughIt) {
    Brackets brackets;
    for (const Sample& sample : samples()) {
        const ReportDocument document = certificate_of(sample, brackets.language);
        EXPECT_EQ(document.language, "xx");
        EXPECT_TRUE(is_said(document.title));
        EXPECT_EQ(document.page_words, "[Page %1 of %2]") << "the printer puts numbers in";
        for (const ReportBlock& block : document.blocks) std::visit(AllSaid{document}, block);
    }
    std::set<std::string> known;
    for (const char* phrase : Phrase::all()) known.insert(phrase);
    for (const CertificateField& field : certificate_fields()) known.insert(field.title);
    for (const char* words : Message::all_words()) known.insert(words);
    for (const std::string& text : brackets.asked)
        EXPECT_TRUE(known.contains(text)) << "the catalogues have no " << text;
}

TEST(CertificateLanguage, PhrasesHaveTheirArgumentsAndStandOnce) {
    std::set<std::string> seen;
    for (const std::string phrase : Phrase::all()) {
        EXPECT_TRUE(seen.insert(phrase).second) << phrase;
        for (int i = 9; i > 1; --i)
            if (phrase.find("%" + std::to_string(i)) != std::string::npos) {
                EXPECT_NE(phrase.find("%" + std::to_string(i - 1)), std::string::npos) << phrase;
            }
    }
}

TEST(CertificateLanguage, NumbersHaveItsDecimalSign) {
    Brackets brackets;
    const std::regex with_point(R"([0-9]\.[0-9]+( |\s|%|\)|$))");
    for (const Sample& sample : samples())
        for (const ReportBlock& block : certificate_of(sample, brackets.language).blocks) {
            if (const auto* table = std::get_if<TableBlock>(&block)) {
                for (std::size_t r = 0; r < table->table.rows; ++r)
                    for (std::size_t c = 0; c < table->table.shown_columns(); ++c) {
                        const std::string cell = to_html(test::typeset_cell(*table, r, c));
                        EXPECT_FALSE(std::regex_search(cell, with_point)) << cell;
                    }
            }
            if (const auto* facts = std::get_if<FactsBlock>(&block)) {
                for (const auto& [name, value] : facts->facts)
                    EXPECT_FALSE(std::regex_search(value, with_point)) << value;
            }
        }
}

TEST(DocumentLanguage, PutsArgumentsInOnceAndAnyWhere) {
    const Phrase phrase{"test only: %1 of %2, %1"};
    const DocumentLanguage turned{"xx", {}, [](const std::string&) { return std::string("%2 / %1, 5 %"); }};
    EXPECT_EQ(DocumentLanguage().say(phrase, {"a", "b"}), "test only: a of b, a");
    EXPECT_EQ(turned.say(phrase, {"%2", "b"}), "b / %2, 5 %") << "an argument is not read again";
    EXPECT_EQ(turned.say(phrase, {"a"}), "%2 / a, 5 %") << "what is not given stays";
    EXPECT_EQ(DocumentLanguage().say_declared("x %1"), "x %1");
}

}  // namespace
}  // namespace covaria::certificate_language_test
