// PDF/A-3b made of a small PDF: what the standard asks for is there, equal bytes, files come back; hostile
// files end in a sentence.
#include "core/pdf/pdf_archive.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace covaria::pdf_archive_test {

namespace {

/// One empty page, with a table of references that is right.
std::string small_pdf() {
    std::string pdf = "%PDF-1.4\n";
    std::vector<std::size_t> places;
    for (const char* object :
         {"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
          "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 10 10] >>",
          "<< /Producer (Maker) /CreationDate (D:20261122120000) >>",
          "<< /Type /FontDescriptor /FontName /F /CIDSet 6 0 R >>", "<< /Length 0 >>\nstream\n\nendstream"}) {
        places.push_back(pdf.size());
        pdf += std::to_string(places.size()) + " 0 obj\n" + object + "\nendobj\n";
    }
    const std::size_t table = pdf.size();
    pdf += "xref\n0 " + std::to_string(places.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t place : places) {
        std::string digits = std::to_string(place);
        digits.insert(0, 10 - digits.size(), '0');
        pdf += digits + " 00000 n \n";
    }
    return pdf + "trailer << /Size " + std::to_string(places.size() + 1) +
           " /ID [<01> <02>] /Root 1 0 R /Info 4 0 R /Extra 5 0 R >>\nstartxref\n" + std::to_string(table) +
           "\n%%EOF\n";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::vector<AttachedFile> some_files() {
    return {{"project.covaria", std::string("{\"x\": 1}\n\0\xff", 11), "application/json", "The <project>",
             AttachedAs::source},
            {"data/points ä.csv", std::string(100'000, '7'), "text/csv", "", AttachedAs::data},
            {"certificate.xml", "", "application/xml",
             "a\x01"
             "b",
             AttachedAs::alternative}};
}

TEST(PdfArchive, SaysWhatItIsAndIsMadeTwiceWithEqualBytes) {
    const PdfProperties properties{"Title <&> Ä\x02", "Covaria 1"};
    const auto made = archived_pdf(small_pdf(), properties, some_files());
    ASSERT_TRUE(made) << made.error().message.english();
    EXPECT_EQ(*made, *archived_pdf(small_pdf(), properties, some_files()));
    EXPECT_NE(*made, *archived_pdf(small_pdf(), {"Other", "Covaria 1"}, some_files()));
    EXPECT_TRUE(made->starts_with("%PDF-1.7\n%"));
    for (const char* part :
         {"<pdfaid:part>3</pdfaid:part>", "<pdfaid:conformance>B</pdfaid:conformance>",
          "/AFRelationship /Source", "/AFRelationship /Data", "/AFRelationship /Alternative", "/AF [", "/UF ",
          "/EmbeddedFiles", "/Subtype /text#2fcsv", "/ModDate (D:20000101000000Z)", "/ID [<",
          "Title &lt;&amp;&gt; Ä ", "<xmp:CreatorTool>Covaria 1</xmp:CreatorTool>",
          "<pdf:Producer>Maker</pdf:Producer>", "/Producer (Maker)", "/Creator (Covaria 1)"})
        EXPECT_TRUE(has(*made, part)) << part;
    for (const char* part : {"/CreationDate", "20261122", "/CIDSet", "/Encrypt", "/JavaScript", "<01>"})
        EXPECT_FALSE(has(*made, part)) << part;
}

TEST(PdfArchive, NamesItsAuthorAndItsLanguageTwiceAndAlike) {
    const std::string named = archived_pdf(small_pdf(), {"t", "c", "E. Muster <&>\x03", "zh_CN"}, {}).value();
    for (const char* part :
         {"/Author (E. Muster <&> )", "E. Muster &lt;&amp;&gt; </rdf:li></rdf:Seq></dc:creator>",
          "/Lang (zh-CN)", "<rdf:li>zh-CN</rdf:li></rdf:Bag></dc:language>", "/DisplayDocTitle true"})
        EXPECT_TRUE(has(named, part)) << part;
    const std::string nobody = archived_pdf(small_pdf(), {"t", "c"}, {}).value();
    for (const char* part : {"/Author", "dc:creator", "/Lang", "dc:language", "/MarkInfo", "/StructTreeRoot"})
        EXPECT_FALSE(has(nobody, part)) << part;
}

TEST(PdfArchive, WaysLeadToPagesThatAreThere) {
    const PdfNavigation ways{{{"Änderung", 1, {0, 9.5}}, {"below", 2, {0, 5.0}}, {"next", 1, {0, 1.0}}},
                             {{0, 1.0, 2.0, 3.5, 4.0, {0, 9.5}}}};
    const std::string made = archived_pdf(small_pdf(), {"t", "c"}, {}, ways).value();
    EXPECT_EQ(made, archived_pdf(small_pdf(), {"t", "c"}, {}, ways).value());
    for (const char* part :
         {"/PageMode /UseOutlines", "/Type /Outlines", "/Count 2", "/Count -1", "/Title (below)",
          "/Subtype /Link", "/Rect [ 1 2 3.5 4 ]", "/F 4", "/XYZ 0 9.5 0"})
        EXPECT_TRUE(has(made, part)) << part;
    EXPECT_FALSE(has(archived_pdf(small_pdf(), {"t", "c"}, {}).value(), "/Outlines"));
    for (const int page : {-1, 1}) {
        EXPECT_FALSE(archived_pdf(small_pdf(), {"t", "c"}, {}, {{{"a", 1, {page, 0.0}}}, {}}));
        EXPECT_FALSE(archived_pdf(small_pdf(), {"t", "c"}, {}, {{}, {{page, 0, 0, 1, 1, {0, 0.0}}}}));
        EXPECT_FALSE(archived_pdf(small_pdf(), {"t", "c"}, {}, {{}, {{0, 0, 0, 1, 1, {page, 0.0}}}}));
    }
}

TEST(PdfArchive, FilesComeBackAsTheyWere) {
    const std::vector<AttachedFile> files = some_files();
    const auto back = files_in_pdf(archived_pdf(small_pdf(), {"t", "c"}, files).value());
    ASSERT_TRUE(back) << back.error().message.english();
    ASSERT_EQ(back->size(), files.size());
    for (const AttachedFile& file : files) {
        const auto found = std::find_if(back->begin(), back->end(),
                                        [&](const AttachedFile& other) { return other.name == file.name; });
        ASSERT_NE(found, back->end()) << file.name;
        EXPECT_EQ(found->bytes, file.bytes) << file.name;
        EXPECT_EQ(found->mime, file.mime) << file.name;
    }
    EXPECT_TRUE(files_in_pdf(small_pdf())->empty());
    EXPECT_TRUE(files_in_pdf(archived_pdf(small_pdf(), {"t", "c"}, {}).value())->empty());
}

TEST(PdfArchive, WhatIsNoPdfIsRefused) {
    const std::string good = archived_pdf(small_pdf(), {"t", "c"}, some_files()).value();
    for (const std::string& bad : {std::string(), std::string("%PDF-1.7\n"), std::string("x"),
                                   good.substr(0, 500), good.substr(0, good.size() / 2)}) {
        EXPECT_FALSE(files_in_pdf(bad));
        EXPECT_FALSE(archived_pdf(bad, {"t", "c"}, {}));
    }
}

TEST(PdfArchive, CompressedTablesAreRefusedBeforeTheyAreInflated) {
    const std::string good = archived_pdf(small_pdf(), {"t", "c"}, {}).value();
    for (const char* name : {"/XRef ", "/XR#65f\n", "/#58#52#45#66/", "/XRef"}) {
        const auto files = files_in_pdf(good + name);
        const bool is_it = std::string(name).find("#45") == std::string::npos;  // #45 is E
        EXPECT_EQ(!files && files.error().message.english().find("is compressed") != std::string::npos, is_it)
            << name;
    }
    EXPECT_TRUE(files_in_pdf(good)) << files_in_pdf(good).error().message.english();
}

TEST(PdfArchive, FilesThatInflateTooFarAreRefused) {
    std::vector<AttachedFile> files{{"a", std::string(120'000'000, '0'), "text/plain"},
                                    {"b", std::string(120'000'000, '0'), "text/plain"}};
    const std::string bomb = archived_pdf(small_pdf(), {"t", "c"}, files).value();
    EXPECT_LT(bomb.size(), 1'000'000u);
    EXPECT_FALSE(files_in_pdf(bomb));
}

TEST(PdfArchive, ChangedBytesEndInFilesOrInASentence) {
    const std::string good = archived_pdf(small_pdf(), {"t", "c"}, some_files()).value();
    std::uint64_t state = 1;
    std::size_t refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string bad = good;
        for (int n = 0; n < 1 + i % 4; ++n) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            bad[(state >> 33) % bad.size()] = static_cast<char>(state >> 56);
        }
        const auto files = files_in_pdf(bad);
        if (!files) {
            ++refused;
            EXPECT_FALSE(files.error().message.english().empty());
        }
    }
    EXPECT_GT(refused, 100u);
}

}  // namespace

}  // namespace covaria::pdf_archive_test
