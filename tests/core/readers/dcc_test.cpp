// Digital Calibration Certificates: uncertainty, units, lists, covariances in every version, and the refused
// files.
#include "core/kinds/registries.h"
#include "core/readers/dsi_unit.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

namespace {

/// A certificate with these quantities; the first of them begins in line 2.
std::string certificate(const std::string& quantities) {
    return "<c:digitalCalibrationCertificate xmlns:c=\"https://ptb.de/dcc\" "
           "schemaVersion=\"2.3.0\"><c:measurementResults>"
           "<c:measurementResult><c:results><c:result><c:data>\n" +
           quantities +
           "</c:data></c:result></c:results></c:measurementResult></c:measurementResults>"
           "</c:digitalCalibrationCertificate>\n";
}

std::string quantity(const std::string& inside) {
    return "<c:quantity><c:name><c:content>q</c:content></c:name>" + inside + "</c:quantity>\n";
}

SetupCell stated(const Proposals& proposals, std::size_t row, const std::string& column) {
    const AnalysisEntry& analysis = proposals.analyses.at(0);
    return cell(find_model(analysis.model)->schema, analysis.setup, "quantities", row, column);
}

TEST(ReadCertificate, ALengthBecomesAQuantityAndAStandard) {
    const auto read = read_with("dcc", data("bar.xml"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(read->title, "Scale bar");
    ASSERT_EQ(read->assets.size(), 1u) << "the deviation is no length standard";
    EXPECT_EQ(read->assets[0].name, "Length: length at 20 °C");
    EXPECT_EQ(std::get<Quantity>(read->assets[0].setup.values.at("length")).value, 1.500012);
    EXPECT_EQ(
        cell(find_asset_kind(read->assets[0].kind)->schema, read->assets[0].setup, "components", 0, "u_cal"),
        SetupCell(0.000002));
    EXPECT_EQ(stated(*read, 0, "statement"), SetupCell(std::string("certificate-k")));
    EXPECT_EQ(stated(*read, 1, "a"), SetupCell(4.0));
    EXPECT_EQ(stated(*read, 1, "unit"), SetupCell(std::string("um")));
    EXPECT_EQ(errors_of(*read), "");
    for (const char* words :
         {"BAR-7, Laboratory A, 2026-03-01", "'marking': a value as <noQuantity>", "<comment>"})
        EXPECT_NE(all_found(*read).find(words), std::string::npos) << words << "\n" << all_found(*read);
    EXPECT_EQ((*reader_for(data("bar.xml"), "bar.xml"))->name, "dcc");
}

TEST(ReadCertificate, AListMayStateOneUncertaintyForAllItsValues) {
    const std::string values = "<s:real><s:value>1</s:value></s:real><s:real><s:value>2</s:value></s:real>";
    for (const char* element : {"listUnivariateUnc", "listMeasurementUncertaintyUnivariate"}) {
        const std::string name = element;
        const auto read = read_with(
            "dcc",
            certificate(quantity("<s:list><s:listUnit>\\newton</s:listUnit><s:" + name +
                                 "><s:expandedUnc><s:uncertainty>0.1</s:uncertainty><s:coverageFactor>2"
                                 "</s:coverageFactor></s:expandedUnc></s:" +
                                 name + ">" + values + "</s:list>")));
        ASSERT_TRUE(read) << read.error().message.english();
        for (std::size_t row = 0; row < 2; ++row) {
            EXPECT_EQ(stated(*read, row, "statement"), SetupCell(std::string("certificate-k"))) << element;
            EXPECT_EQ(stated(*read, row, "a"), SetupCell(0.1)) << element;
        }
        EXPECT_EQ(stated(*read, 1, "name"), SetupCell(std::string("q [2]"))) << "told apart without labels";
    }
}

TEST(ReadCertificate, EveryFormOfUncertainty) {
    const std::string value = "<s:value>5</s:value><s:unit>\\newton</s:unit>";
    const auto read = read_with(
        "dcc",
        certificate(
            quantity("<s:real>" + value +
                     "<s:coverageInterval><s:standardUnc>0.5</s:standardUnc></s:coverageInterval>"
                     "</s:real>") +
            quantity("<s:real>" + value +
                     "<s:measurementUncertaintyUnivaraite><s:standardMU><s:valueStandardMU>0.25"
                     "</s:valueStandardMU></s:standardMU></s:measurementUncertaintyUnivaraite></s:real>") +
            quantity("<s:real>" + value +
                     "<s:expandedUnc><s:uncertainty>1</s:uncertainty><s:coverageProbability>0.9"
                     "</s:coverageProbability></s:expandedUnc></s:real>") +
            quantity("<s:real>" + value +
                     "<s:expandedUnc><s:uncertainty>1</s:uncertainty><s:coverageFactor>1.65"
                     "</s:coverageFactor><s:distribution>uniform</s:distribution></s:expandedUnc></s:real>") +
            quantity("<s:real>" + value + "</s:real>") +
            quantity("<s:real>" + value +
                     "<s:expandedUnc><s:uncertainty>1</s:uncertainty></s:expandedUnc></s:real>")));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(stated(*read, 0, "a"), SetupCell(0.5));
    EXPECT_EQ(stated(*read, 1, "a"), SetupCell(0.25));
    EXPECT_EQ(stated(*read, 2, "statement"), SetupCell(std::string("certificate-p")));
    EXPECT_EQ(stated(*read, 2, "b"), SetupCell(90.0));
    EXPECT_EQ(stated(*read, 3, "statement"), SetupCell(std::string("rectangular")));
    EXPECT_NEAR(std::get<double>(stated(*read, 3, "a")), 1.7320508 / 1.65, 1e-6);
    EXPECT_EQ(stated(*read, 4, "statement"), SetupCell());
    EXPECT_EQ(stated(*read, 5, "statement"), SetupCell());
    EXPECT_NE(all_found(*read).find("neither k nor p"), std::string::npos) << all_found(*read);
    EXPECT_NE(all_found(*read).find("2 'q': its coverage interval"), std::string::npos) << all_found(*read);
    EXPECT_EQ(errors_of(*read), "");
}

TEST(ReadCertificate, ListsAndHybridsOfTemperatures) {
    const std::string u =
        "<s:expandedUncXMLList><s:uncertaintyXMLList>0.1 0.2</s:uncertaintyXMLList><s:coverageFactorXMLList>2"
        "</s:coverageFactorXMLList></s:expandedUncXMLList>";
    const auto read = read_with(
        "dcc", certificate(
                   quantity("<s:hybrid><s:realListXMLList><s:valueXMLList>1 2</s:valueXMLList><s:unitXMLList>"
                            "\\decibel</s:unitXMLList></s:realListXMLList><s:realListXMLList><s:valueXMLList>"
                            "20.5 30</s:valueXMLList><s:unitXMLList>\\degreecelsius</s:unitXMLList>" +
                            u + "</s:realListXMLList></s:hybrid>")));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(stated(*read, 0, "value"), SetupCell(20.5));
    EXPECT_EQ(stated(*read, 1, "a"), SetupCell(0.2));
    EXPECT_EQ(stated(*read, 1, "b"), SetupCell(2.0));
    EXPECT_EQ(stated(*read, 1, "name"), SetupCell(std::string("q [2]")));
    EXPECT_NE(all_found(*read).find("the same in other units"), std::string::npos) << all_found(*read);
    EXPECT_EQ(errors_of(*read), "");
    const auto unequal = read_with(
        "dcc",
        certificate(quantity("<s:realListXMLList><s:valueXMLList>1 2 3</s:valueXMLList><s:unitXMLList>\\one"
                             "</s:unitXMLList>" +
                             u + "</s:realListXMLList>")));
    ASSERT_FALSE(unequal);
    EXPECT_EQ(unequal.error().line, 2);
}

std::string vector_with(const std::string& covariance) {
    std::string matrix;
    for (int column = 0; column < 2; ++column) {
        matrix += "<s:column>";
        for (int row = 0; row < 2; ++row)
            matrix += "<s:covariance><s:value>" + (row == column ? "4" : covariance) +
                      "</s:value><s:unit>\\milli\\metre\\tothe{2}</s:unit></s:covariance>";
        matrix += "</s:column>";
    }
    return certificate(
        quantity("<s:list><s:realList><s:listUnit>\\milli\\metre</s:listUnit><s:real><s:label>x</s:label>"
                 "<s:value>1</s:value></s:real><s:real><s:value>2</s:value></s:real>"
                 "<s:ellipsoidalRegion><s:covarianceMatrix>" +
                 matrix + "</s:covarianceMatrix></s:ellipsoidalRegion></s:realList></s:list>"));
}

TEST(ReadCertificate, CovariancesBecomeCorrelations) {
    const auto read = read_with("dcc", vector_with("-1"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_NEAR(std::get<double>(stated(*read, 0, "a")), 2.0, 1e-12);
    EXPECT_EQ(stated(*read, 0, "name"), SetupCell(std::string("q [x]")));
    ASSERT_EQ(read->analyses[0].correlations.size(), 1u);
    EXPECT_NEAR(read->analyses[0].correlations[0].coefficient, -0.25, 1e-12);
    EXPECT_EQ(errors_of(*read), "");
    EXPECT_FALSE(read_with("dcc", vector_with("-5"))) << "no covariance matrix";
}

TEST(ReadCertificate, WhatIsWrongHasAPlace) {
    struct Case {
        std::string text;
        int line;
        const char* words;
    };
    const std::string entities =
        "<!DOCTYPE c [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>\n<c:digitalCalibrationCertificate/>";
    for (const Case& c :
         {Case{"<?xml version=\"1.0\"?>\n" + entities, 2, "document type declaration"},
          Case{"<a>\n<b></a>", 2, "not readable as XML"}, Case{"\n<html/>", 2, "its root is <html>"},
          Case{certificate(""), 1, "no results"},
          Case{certificate(quantity("<s:real><s:value>1,5</s:value><s:unit>\\one</s:unit></s:real>")), 2,
               "'1,5' is no number"},
          Case{certificate("\n" +
                           quantity("<s:real><s:value>1</s:value><s:unit>\\one</s:unit><s:expandedUnc>"
                                    "<s:uncertainty>1</s:uncertainty><s:coverageFactor>0</s:coverageFactor>"
                                    "</s:expandedUnc></s:real>")),
               3, "k must be greater than 0"}}) {
        const auto read = read_with("dcc", c.text);
        ASSERT_FALSE(read) << c.text;
        EXPECT_EQ(read.error().line, c.line) << c.text;
        EXPECT_NE(read.error().message.english().find("column "), std::string::npos)
            << read.error().message.english();
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

TEST(ReadCertificate, DeepNestingIsNoDepthOfTheStack) {
    std::string deep;
    for (int i = 0; i < 200'000; ++i) deep += "<c:list>";
    std::string closed = deep;
    for (int i = 0; i < 200'000; ++i) closed += "</c:list>";
    EXPECT_FALSE(read_with("dcc", certificate(deep)));
    EXPECT_FALSE(read_with("dcc", certificate(closed)));
}

TEST(ReadCertificate, UnitsOfDsi) {
    for (const auto& [dsi, unit] :
         {std::pair<const char*, const char*>{"\\milli\\metre", "mm"},
          {"\\metre\\tothe{2}", "m^2"},
          {"\\metre\\per\\second", "m/s"},
          {"\\newton\\metre", "N*m"},
          {"\\one", "1"},
          {"\\percent", "%"},
          {"\\kelvin\\tothe{-1}", "1/K"},
          {"\\degreecelsius", "degC"},
          {"\\kilogram\\metre\\tothe{-3}\\kilogram\\tothe{-1}\\metre\\tothe{3}", "1"},
          {"\\micro\\metre\\per\\metre\\per\\kelvin", "um/(m*K)"}}) {
        const auto read = unit_of_dsi(dsi);
        ASSERT_TRUE(read) << dsi << " " << read.error().message.english();
        EXPECT_EQ(read->text(), Unit::of(unit).text()) << dsi;
    }
    for (const char* wrong :
         {"", "mm", "\\milli", "\\furlong", "\\decibel", "\\metre\\tothe{2", "\\metre\\tothe{x}"})
        EXPECT_FALSE(unit_of_dsi(wrong)) << wrong;
}

}  // namespace

}  // namespace covaria::readers_test
