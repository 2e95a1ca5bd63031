#include "core/project/certificate.h"

#include <algorithm>
#include <optional>

#include "core/base/dates.h"

namespace covaria {

namespace {

using C = Certificate;

constexpr auto lines = CertificateText::lines;
constexpr auto line_of_text = CertificateText::line;

std::vector<CertificateField> fields_of_laboratory() {
    return {{"", "number", "Certificate number", "Unique; it stands on every page.", &C::number, line_of_text,
             "7.8.2.1 d", true},
            {"", "language", "Language", "Of the certificate and the report; what was typed stays as it is.",
             &C::language, CertificateText::language},
            {"laboratory", "name", "Laboratory", "That issues the certificate.", &C::laboratory, line_of_text,
             "7.8.2.1 b", true},
            {"laboratory", "address", "Address of the laboratory", "Street, town, country.",
             &C::laboratory_address, lines, "7.8.2.1 b", true},
            {"laboratory", "country", "Country of the laboratory",
             "Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.", &C::country,
             CertificateText::country},
            {"laboratory", "accreditation", "Accreditation number", "Absent: not accredited for this.",
             &C::accreditation},
            {"laboratory", "logo", "Logo",
             "A PNG or JPEG file beside the project, up to 2 MB: at the head of the first page.", &C::logo,
             CertificateText::picture},
            {"", "site", "Site of calibration",
             "Whose place it was done at; empty: in the laboratory, or elsewhere where a place is stated.",
             &C::site, CertificateText::site, "7.8.2.1 c"},
            {"", "place", "Place of calibration",
             "Where it was done if not in the laboratory: the customer's hall, the field.", &C::place, lines,
             "7.8.2.1 c"}};
}

std::vector<CertificateField> fields_of_customer() {
    return {{"customer", "name", "Customer", "For whom it was done.", &C::customer, line_of_text, "7.8.2.1 e",
             true},
            {"customer", "address", "Address of the customer", "Street, town, country.", &C::customer_address,
             lines, "7.8.2.1 e", true}};
}

std::vector<CertificateField> fields_of_item() {
    return {
        {"item", "description", "Item", "What was calibrated.", &C::item, line_of_text, "7.8.2.1 g", true},
        {"item", "manufacturer", "Manufacturer", "Of the item.", &C::manufacturer},
        {"item", "type", "Type", "The manufacturer's name for it: model, size, class.", &C::type},
        {"item", "serialNumber", "Serial number",
         "By which the item is recognised, unless it has an identification.", &C::serial_number, line_of_text,
         "7.8.2.1 g", true, &C::identification},
        {"item", "identification", "Identification", "The customer's mark, an inventory number.",
         &C::identification, line_of_text, "7.8.2.1 g"},
        {"item", "condition", "Condition of the item", "As it was received, where that matters.",
         &C::condition, lines, "7.8.2.1 g"}};
}

std::vector<CertificateField> fields_of_dates() {
    return {{"dates", "received", "Date of receipt", "ISO 8601: 2026-04-17.", &C::received,
             CertificateText::date, "7.8.2.1 h"},
            {"dates", "calibrated", "Date of calibration",
             "A date, or two of an interval: 2026-04-17/2026-04-18.", &C::calibrated, CertificateText::dates,
             "7.8.2.1 i", true},
            {"dates", "issued", "Date of issue", "ISO 8601: 2026-04-20.", &C::issued, CertificateText::date,
             "7.8.2.1 j", true}};
}

std::vector<CertificateField> fields_of_calibration() {
    return {{"", "method", "Method", "Procedure by which it was calibrated, with its edition.", &C::method,
             lines, "7.8.2.1 f", true},
            {"", "deviations", "Deviations from the method", "Additions, exclusions.", &C::deviations, lines,
             "7.8.2.1 n"},
            {"", "environment", "Environmental conditions", "Those that influence the results.",
             &C::environment, lines, "7.8.4.1 b", true},
            {"", "traceability", "Metrological traceability",
             "To which references, by which certificates the results are traceable.", &C::traceability, lines,
             "7.8.4.1 c", true},
            {"", "adjustment", "Adjustment or repair", "Results before and after it.", &C::adjustment, lines,
             "7.8.4.1 d"},
            {"", "specification", "Specification",
             "To which a statement of conformity refers: the standard or drawing, with its edition.",
             &C::specification, lines, "7.8.6.2 b", false, nullptr, true},
            {"", "remarks", "Remarks", "Opinions and interpretations are marked as such (7.8.7).",
             &C::remarks, lines}};
}

std::vector<CertificateField> fields_of_authorisation() {
    return {{"authorised", "name", "Authorised by", "The person who authorises the certificate.",
             &C::authorised_by, line_of_text, "7.8.2.1 o", true},
            {"authorised", "function", "Function", "Of that person in the laboratory.", &C::function}};
}

std::vector<CertificateField> fields_of_amendment() {
    return {{"replaces", "number", "Replaces certificate",
             "Number of the certificate that this one replaces; empty: it is no amended one.", &C::replaces,
             line_of_text, "7.8.8.2"},
            {"replaces", "issued", "Its date of issue", "ISO 8601: 2026-04-20.", &C::replaced_issued,
             CertificateText::date, "7.8.8.2"},
            {"replaces", "reasons", "Reasons of the amendment", "What was wrong or has changed, and why.",
             &C::reasons, lines, "7.8.8.1"}};
}

bool is_language(const std::string& code) {
    const auto& all = certificate_languages();
    return std::any_of(all.begin(), all.end(),
                       [&](const CertificateLanguage& one) { return code == one.code; });
}

std::string codes_of_languages() {
    std::string codes;
    for (const CertificateLanguage& one : certificate_languages())
        codes += (codes.empty() ? "" : ", ") + std::string(one.code);
    return codes;
}

const CertificateSite* find_site(const std::string& key) {
    for (const CertificateSite& one : certificate_sites())
        if (key == one.key) return &one;
    return nullptr;
}

std::string keys_of_sites() {
    std::string keys;
    for (const CertificateSite& one : certificate_sites())
        keys += (keys.empty() ? "" : ", ") + std::string(one.key);
    return keys;
}

/// The period that a text of that kind states; empty where it states none.
std::optional<Period> period_in(const std::string& text, CertificateText kind) {
    if (kind == CertificateText::dates) return period_of(text);
    const auto day = date_of(text);
    return day ? std::optional(Period{*day, *day}) : std::nullopt;
}

/// The period that a member of the certificate states; empty where none is given, or the text is none.
std::optional<Period> period_in(const Certificate& certificate, std::string Certificate::*member) {
    return period_in(certificate.*member, certificate_field(member).kind);
}

bool is_country(const std::string& text) {
    return text.size() == 2 &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

void check_order(const Certificate& certificate, std::string Certificate::*before,
                 std::string Certificate::*after, const Message& message, Problems& problems) {
    const auto first = period_in(certificate, before), then = period_in(certificate, after);
    if (first && then && then->first < first->first)
        problems.warning(pointer_of(certificate_field(after)), message);
}

}  // namespace

const std::vector<CertificateSection>& certificate_sections() {
    static const std::vector<CertificateSection> sections{
        {"Certificate and laboratory", fields_of_laboratory()},
        {"Customer", fields_of_customer()},
        {"Item", fields_of_item()},
        {"Dates", fields_of_dates()},
        {"Calibration", fields_of_calibration()},
        {"Authorisation", fields_of_authorisation()},
        {"Amended certificate", fields_of_amendment()}};
    return sections;
}

const std::vector<CertificateLanguage>& certificate_languages() {
    static const std::vector<CertificateLanguage> all{{"en", "English"},     {"de", "Deutsch"},
                                                      {"es", "Español"},     {"pt", "Português"},
                                                      {"zh_CN", "简体中文"}, {"ko", "한국어"}};
    return all;
}

const std::vector<CertificateSite>& certificate_sites() {
    static const std::vector<CertificateSite> all{{"laboratory", "in the laboratory"},
                                                  {"customer", "at the customer"},
                                                  {"laboratoryBranch", "in a branch of the laboratory"},
                                                  {"customerBranch", "in a branch of the customer"},
                                                  {"other", "elsewhere"}};
    return all;
}

const CertificateSite& site_of(const Certificate& certificate) {
    if (const CertificateSite* chosen = find_site(certificate.site)) return *chosen;
    return is_blank(certificate.place) ? certificate_sites().front() : certificate_sites().back();
}

const std::vector<CertificateField>& certificate_fields() {
    static const std::vector<CertificateField> fields = [] {
        std::vector<CertificateField> all;
        for (const CertificateSection& section : certificate_sections())
            all.insert(all.end(), section.fields.begin(), section.fields.end());
        return all;
    }();
    return fields;
}

const CertificateField& certificate_field(std::string Certificate::*member) {
    const auto& all = certificate_fields();
    return *std::find_if(all.begin(), all.end(),
                         [&](const CertificateField& field) { return field.member == member; });
}

std::string pointer_of(const CertificateField& field) {
    const std::string group = field.group;
    return "/certificate/" + (group.empty() ? "" : group + "/") + field.key;
}

bool is_blank(const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

bool is_missing(const CertificateField& field, const Certificate& certificate, Conformity conformity) {
    const bool required =
        field.required || (field.required_for_conformity && conformity == Conformity::stated);
    return required && is_blank(certificate.*field.member) &&
           (!field.or_else || is_blank(certificate.*field.or_else));
}

Message complaint_about(const CertificateField& field, const std::string& text) {
    const Message title = Message::declared(field.title);
    if (field.kind == CertificateText::country && !text.empty() && !is_country(text))
        return tell<"'%1' must be two capital letters, such as DE; it is '%2'">(title, text);
    if (field.kind == CertificateText::language && !text.empty() && !is_language(text))
        return tell<"'%1' must be one of %2; it is '%3'">(title, codes_of_languages(), text);
    if (field.kind == CertificateText::site && !text.empty() && !find_site(text))
        return tell<"'%1' must be one of %2; it is '%3'">(title, keys_of_sites(), text);
    const bool interval = field.kind == CertificateText::dates;
    const bool dated = interval || field.kind == CertificateText::date;
    if (!dated || text.empty() || period_in(text, field.kind)) return Message{};
    return interval ? tell<
                          "'%1' must be a date of the form 2026-04-17 or an interval 2026-04-17/2026-04-18; "
                          "it is '%2'">(title, text)
                    : tell<"'%1' must be a date of the form 2026-04-17; it is '%2'">(title, text);
}

void check_certificate(const Certificate& certificate, Problems& problems) {
    for (const CertificateField& field : certificate_fields())
        if (const Message complaint = complaint_about(field, certificate.*field.member); !complaint.empty())
            problems.add({field.kind == CertificateText::country ? Severity::warning : Severity::error,
                          pointer_of(field), complaint});
    check_order(certificate, &C::received, &C::calibrated,
                tell<"the item cannot have been calibrated before it was received">(), problems);
    check_order(certificate, &C::calibrated, &C::issued,
                tell<"the certificate cannot have been issued before the calibration">(), problems);
    check_order(certificate, &C::replaced_issued, &C::issued,
                tell<"the certificate cannot have been issued before the one that it replaces">(), problems);
    if (!is_blank(certificate.replaces) && certificate.replaces == certificate.number)
        problems.error(pointer_of(certificate_field(&C::replaces)),
                       tell<"an amended certificate has a number of its own, not that of the one that it "
                            "replaces">());
}

Problems missing_in(const Certificate& certificate, Conformity conformity) {
    Problems missing;
    for (const CertificateField& field : certificate_fields()) {
        if (!is_missing(field, certificate, conformity)) continue;
        const Message other =
            field.or_else ? tell<" (or %1)">(certificate_field(field.or_else).key) : Message();
        missing.error(pointer_of(field), tell<"'%1'%2 must be stated (ISO/IEC 17025 %3)">(
                                             Message::declared(field.title), other, field.clause));
    }
    return missing;
}

Problems missing_in_digital(const Certificate& certificate, Conformity conformity) {
    Problems missing = missing_in(certificate, conformity);
    const CertificateField& country = certificate_field(&Certificate::country);
    if (is_blank(certificate.country))
        missing.error(pointer_of(country), tell<"'%1' must be stated (Digital Calibration Certificate)">(
                                               Message::declared(country.title)));
    else if (const Message complaint = complaint_about(country, certificate.country); !complaint.empty())
        missing.error(pointer_of(country), complaint);
    return missing;
}

}  // namespace covaria
