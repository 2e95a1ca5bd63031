// The certificate section: one declaration, and what follows from it.
#include "core/project/certificate.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/resource_path.h"
#include "core/project/set_values.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::certificate_test {
namespace {

using nlohmann::ordered_json;

/// Every text is there; dates are dates.
Certificate full_certificate() {
    Certificate certificate;
    for (const CertificateField& field : certificate_fields())
        certificate.*field.member = field.kind == CertificateText::date ? "2026-04-17"
                                    : field.kind == CertificateText::picture
                                        ? (data_directory() / "projects/chain.png").string()
                                    : field.kind == CertificateText::country  ? "DE"
                                    : field.kind == CertificateText::language ? "de"
                                    : field.kind == CertificateText::site     ? "customerBranch"
                                    : field.kind == CertificateText::dates    ? "2026-04-17/2026-04-18"
                                                                              : pointer_of(field) + "\nß";
    certificate.issued = "2026-04-20";
    return certificate;
}

std::string messages(const Problems& problems) {
    std::string all;
    for (const Problem& problem : problems.items())
        all += problem.path + ": " + problem.message.english() + "\n";
    return all;
}

std::string problems_with(std::string Certificate::*member, const std::string& text) {
    Certificate certificate = full_certificate();
    certificate.*member = text;
    Problems problems;
    check_certificate(certificate, problems);
    return messages(problems);
}

TEST(Certificate, EveryTextComesBackFromTheFile) {
    Project project = parse(whole_project).project;
    project.certificate = full_certificate();
    const std::string text = project_text(project);
    const LoadedProject loaded = parse(text);
    EXPECT_EQ(messages(loaded.problems), "");
    EXPECT_EQ(loaded.project.certificate, project.certificate);
    EXPECT_EQ(project_text(loaded.project), text);
    EXPECT_FALSE(loaded.project == parse(whole_project).project);
}

TEST(Certificate, WithoutOneNothingIsWrittenAndNumbersDoNotDependOnIt) {
    Project project = parse(whole_project).project;
    EXPECT_EQ(project_text(project).find("\"certificate\":"), std::string::npos);
    const std::string before = fingerprint(project);
    project.certificate = full_certificate();
    EXPECT_EQ(fingerprint(project), before);
    EXPECT_TRUE(same_numbers(project, parse(whole_project).project));
    EXPECT_EQ(parse(changed("\"assets\": [", "\"certificate\": {}, \"assets\": [")).project.certificate,
              Certificate{});
}

TEST(Certificate, PlacesAndMembersAreThereOnce) {
    std::set<std::string> places;
    for (const CertificateField& field : certificate_fields()) {
        EXPECT_TRUE(places.insert(pointer_of(field)).second) << pointer_of(field);
        EXPECT_EQ(&certificate_field(field.member), &field);
        EXPECT_TRUE(!field.required || *field.clause) << pointer_of(field);
    }
    EXPECT_EQ(places.size() * sizeof(std::string), sizeof(Certificate)) << "a member is not declared";
    EXPECT_TRUE(places.contains("/certificate/item/serialNumber"));
}

TEST(Certificate, UnknownKeysAndWrongKindsHaveTheirPlace) {
    const auto said = [](const std::string& section) {
        return messages(
            parse(changed("\"assets\": [", "\"certificate\": " + section + ", \"assets\": [")).problems);
    };
    EXPECT_NE(said(R"({"item": {"serialNumer": "7"}})").find("/certificate/item/serialNumer"),
              std::string::npos);
    EXPECT_NE(said(R"({"item": {"serialNumer": "7"}})").find("did you mean 'serialNumber'"),
              std::string::npos);
    EXPECT_NE(said(R"({"numbr": "7"})").find("'number'"), std::string::npos);
    EXPECT_NE(said(R"({"number": 7})").find("must be a text in quotes"), std::string::npos);
    EXPECT_NE(said(R"("x")").find("/certificate: "), std::string::npos);
    EXPECT_NE(said(R"({"dates": {"issued": "17.4.2026"}})").find("/certificate/dates/issued"),
              std::string::npos);
}

TEST(Certificate, DatesAreDates) {
    EXPECT_EQ(problems_with(&Certificate::issued, "2026-04-20"), "");
    EXPECT_EQ(problems_with(&Certificate::issued, ""), "");
    EXPECT_EQ(problems_with(&Certificate::issued, "2028-02-29"), "");
    for (const char* wrong : {"2026-02-29", "2026-13-01", "2026-4-20", "20260420", "2026-04-20/2026-04-21",
                              "+026-04-20", " 2026-04-20", "today"})
        EXPECT_NE(problems_with(&Certificate::issued, wrong)
                      .find("/certificate/dates/issued: 'Date of issue' must be a date"),
                  std::string::npos)
            << wrong;
    EXPECT_EQ(problems_with(&Certificate::calibrated, "2026-04-17"), "");
    for (const char* wrong : {"2026-04-18/2026-04-17", "2026-04-17/", "/2026-04-17", "2026-04-17/2026-04-31"})
        EXPECT_NE(problems_with(&Certificate::calibrated, wrong).find("interval"), std::string::npos)
            << wrong;
}

TEST(Certificate, NothingIsCalibratedBeforeItIsThere) {
    EXPECT_NE(problems_with(&Certificate::received, "2026-04-18").find("before it was received"),
              std::string::npos);
    EXPECT_NE(problems_with(&Certificate::issued, "2026-04-16").find("before the calibration"),
              std::string::npos);
}

TEST(Certificate, DatesInTheWrongOrderAreWarnedOf) {
    Certificate certificate = full_certificate();
    certificate.issued = "2026-04-16";
    certificate.replaced_issued = "2026-04-15";
    Problems problems;
    check_certificate(certificate, problems);
    EXPECT_FALSE(problems.has_errors()) << "such a project can be opened";
    EXPECT_EQ(problems.items().size(), 1U);
}

TEST(Certificate, AnAmendedOneHasItsOwnNumberAndComesLater) {
    EXPECT_EQ(problems_with(&Certificate::replaces, "K-1"), "");
    EXPECT_NE(problems_with(&Certificate::replaces, full_certificate().number).find("a number of its own"),
              std::string::npos);
    EXPECT_NE(
        problems_with(&Certificate::replaced_issued, "2026-04-21").find("before the one that it replaces"),
        std::string::npos);
}

TEST(Certificate, FormsGroupTheFieldsThatFilesHave) {
    std::vector<std::string> grouped, listed;
    for (const CertificateSection& section : certificate_sections()) {
        EXPECT_NE(std::string(section.title), "");
        for (const CertificateField& field : section.fields) grouped.push_back(pointer_of(field));
    }
    for (const CertificateField& field : certificate_fields()) listed.push_back(pointer_of(field));
    EXPECT_EQ(grouped, listed);
}

TEST(Certificate, WhatTheStandardRequiresIsMissed) {
    EXPECT_EQ(messages(missing_in(full_certificate())), "");
    const std::string all = messages(missing_in({}));
    for (const CertificateField& field : certificate_fields())
        EXPECT_EQ(all.find(pointer_of(field) + ": ") != std::string::npos, field.required)
            << pointer_of(field);
    EXPECT_NE(all.find("'Metrological traceability' must be stated (ISO/IEC 17025 7.8.4.1 c)"),
              std::string::npos)
        << all;
    Certificate marked = full_certificate();
    marked.serial_number = " \n";
    EXPECT_EQ(messages(missing_in(marked)), "") << "the identification does";
    marked.identification.clear();
    EXPECT_NE(messages(missing_in(marked))
                  .find("/certificate/item/serialNumber: 'Serial number' (or identification) must be stated"),
              std::string::npos);
}

TEST(Certificate, ASpecificationIsRequiredWhereConformityIsStated) {
    Certificate certificate = full_certificate();
    certificate.specification = " ";
    EXPECT_EQ(messages(missing_in(certificate)), "") << "nothing refers to it";
    EXPECT_EQ(messages(missing_in(certificate, Conformity::stated)),
              "/certificate/specification: 'Specification' must be stated (ISO/IEC 17025 7.8.6.2 b)\n");
    EXPECT_TRUE(missing_in_digital(certificate, Conformity::stated).has_errors());
    certificate.specification = "ISO 3650:1998, grade 1";
    EXPECT_EQ(messages(missing_in(certificate, Conformity::stated)), "");
}

TEST(Certificate, TheSiteIsChosenOrFollowsFromThePlace) {
    for (const CertificateSite& site : certificate_sites()) {
        EXPECT_EQ(problems_with(&Certificate::site, site.key), "");
        EXPECT_STREQ(site_of({.site = site.key, .place = "hall 3"}).key, site.key);
    }
    EXPECT_NE(
        problems_with(&Certificate::site, "hall").find("'Site of calibration' must be one of laboratory"),
        std::string::npos)
        << problems_with(&Certificate::site, "hall");
    EXPECT_STREQ(site_of({}).key, "laboratory");
    EXPECT_STREQ(site_of({.place = "hall 3"}).key, "other") << "whose it is, nobody said";
}

TEST(Certificate, ACountryIsTwoCapitalLettersAndADigitalOneNeedsIt) {
    EXPECT_EQ(problems_with(&Certificate::country, "DE"), "");
    EXPECT_EQ(problems_with(&Certificate::country, ""), "");
    for (const char* wrong : {"de", "D", "DEU", "Germany", "D1"})
        EXPECT_NE(problems_with(&Certificate::country, wrong).find("two capital letters"), std::string::npos)
            << wrong;
    Certificate certificate = full_certificate();
    EXPECT_EQ(messages(missing_in_digital(certificate)), "");
    certificate.country = "Germany";
    EXPECT_NE(messages(missing_in_digital(certificate)).find("two capital letters"), std::string::npos);
    certificate.country = " ";
    EXPECT_EQ(messages(missing_in(certificate)), "") << "paper does without";
    EXPECT_NE(messages(missing_in_digital(certificate))
                  .find("/certificate/laboratory/country: 'Country of the laboratory' must be stated"),
              std::string::npos);
}

TEST(Certificate, ValuesAreSetWhereNoneWere) {
    for (const std::string start :
         {R"({"title": "t"})", R"({"certificate": {"item": {"serialNumber": "1"}}})"}) {
        const auto text = with_values(start, {{"/certificate/item/serialNumber", "007"},
                                              {"/certificate/number", "12345"},
                                              {"/certificate/customer/address", R"("Road 1\nTown")"},
                                              {"/certificate/remarks", "true"}});
        ASSERT_TRUE(text.has_value());
        const auto json = ordered_json::parse(*text)["certificate"];
        EXPECT_EQ(json["item"]["serialNumber"], "007");
        EXPECT_EQ(json["number"], "12345") << "a text whatever it looks like";
        EXPECT_EQ(json["customer"]["address"], "Road 1\nTown");
        EXPECT_EQ(json["remarks"], "true");
    }
    EXPECT_FALSE(with_values("[]", {{"/certificate/number", "1"}}).has_value());
    EXPECT_FALSE(
        with_values(R"({"certificate": {"number": "1"}})", {{"/certificate/number/x", "1"}}).has_value());
    EXPECT_FALSE(with_values(R"({"certificate": {"item": {}}})", {{"/certificate/item", "1"}}).has_value());
}

ordered_json schema_entry(const CertificateField& field) {
    const std::string day = "[0-9]{4}-[0-9]{2}-[0-9]{2}";
    ordered_json made{{"description", field.help}, {"type", "string"}};
    if (field.kind == CertificateText::country) made["pattern"] = "^[A-Z]{2}$";
    if (field.kind == CertificateText::language)
        for (const CertificateLanguage& one : certificate_languages()) made["enum"].push_back(one.code);
    if (field.kind == CertificateText::site)
        for (const CertificateSite& one : certificate_sites()) made["enum"].push_back(one.key);
    if (field.kind == CertificateText::date) made["pattern"] = "^" + day + "$";
    if (field.kind == CertificateText::dates) made["pattern"] = "^" + day + "(/" + day + ")?$";
    return made;
}

TEST(JsonSchema, OfTheCertificateIsWhatItsDeclarationMakes) {
    std::ifstream in(data_directory() / "resources/schema/covaria-project.schema.json");
    ordered_json stated = ordered_json::parse(in)["$defs"]["certificate"]["properties"], made;
    for (const CertificateField& field : certificate_fields()) {
        const std::string group = field.group;
        (group.empty() ? made : made[group])[field.key] = schema_entry(field);
    }
    for (auto& [key, entry] : stated.items()) {
        if (!entry.contains("properties")) continue;
        EXPECT_EQ(entry["additionalProperties"], false) << key;
        EXPECT_TRUE(entry.contains("description")) << key;
        entry = ordered_json(entry["properties"]);
    }
    EXPECT_EQ(stated.dump(1), made.dump(1));
}

}  // namespace
}  // namespace covaria::test::certificate_test
