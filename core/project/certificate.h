// What a calibration certificate says beside its results (ISO/IEC 17025 7.8.2, 7.8.4). Each text is declared
// once and bound to its member: project file, its JSON schema, `--set`, form, certificate and
// `covaria validate --certificate` follow.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// All texts as typed; a project whose texts are all empty has no certificate.
struct Certificate {
    std::string number = {}, language = {};
    std::string laboratory = {}, laboratory_address = {}, country = {}, accreditation = {}, logo = {};
    std::string site = {}, place = {};
    std::string customer = {}, customer_address = {};
    std::string item = {}, manufacturer = {}, type = {}, serial_number = {}, identification = {},
                condition = {};
    std::string received = {}, calibrated = {}, issued = {};
    std::string method = {}, deviations = {}, environment = {}, traceability = {}, adjustment = {},
                specification = {}, remarks = {};
    std::string authorised_by = {}, function = {};

    bool empty() const { return *this == Certificate{}; }
    bool operator==(const Certificate&) const = default;
};

enum class CertificateText {
    line,
    lines,     ///< may have several
    country,   ///< two capital letters: DE
    date,      ///< ISO 8601: 2026-04-17
    dates,     ///< a date, or an interval of two: 2026-04-17/2026-04-18
    language,  ///< one of certificate_languages(); empty: English
    site,      ///< one of certificate_sites(); empty: the laboratory, or elsewhere where a place is stated
    picture    ///< name of a PNG or JPEG file, relative to the project's folder
};

/// Whether the certificate says of its results that they lie within a tolerance.
enum class Conformity { not_stated, stated };

struct CertificateField {
    const char* group;  ///< key of the object that it is in; empty: of the certificate itself
    const char* key;
    const char* title;  ///< for people
    const char* help;
    std::string Certificate::*member;
    CertificateText kind = CertificateText::line;
    const char* clause = "";                      ///< of ISO/IEC 17025:2017, where one asks for it
    bool required = false;                        ///< by that clause, of every certificate
    std::string Certificate::*or_else = nullptr;  ///< what does instead of a required one
    bool required_for_conformity = false;         ///< by that clause, where conformity is stated
};

struct CertificateLanguage {
    const char* code;  ///< "zh_CN"
    const char* name;  ///< in the language itself
};
/// English first.
const std::vector<CertificateLanguage>& certificate_languages();

/// Whose place the calibration was performed at; the keys are those of Digital Calibration Certificates.
struct CertificateSite {
    const char* key;
    const char* words;  ///< "at the customer"
};
const std::vector<CertificateSite>& certificate_sites();
/// The one that was chosen; else the laboratory, or elsewhere where a place is stated.
const CertificateSite& site_of(const Certificate& certificate);

struct CertificateSection {
    const char* title;  ///< of a form
    std::vector<CertificateField> fields;
};

/// All fields, as forms group them.
const std::vector<CertificateSection>& certificate_sections();
/// In the order of files and forms; those of a group follow one another.
const std::vector<CertificateField>& certificate_fields();
const CertificateField& certificate_field(std::string Certificate::*member);
/// Place in the project file: "/certificate/item/serialNumber".
std::string pointer_of(const CertificateField& field);
/// Nothing but blanks.
bool is_blank(const std::string& text);
/// Required, and neither it nor what does instead is there.
bool is_missing(const CertificateField& field, const Certificate& certificate,
                Conformity conformity = Conformity::not_stated);

/// Why a text cannot stand in a field (a date or country that is none); empty where it can.
Message complaint_about(const CertificateField& field, const std::string& text);
/// An error for texts that cannot stand there, a warning for dates in the wrong order and for a country that
/// only a digital certificate needs; paths from the root of the project.
void check_certificate(const Certificate& certificate, Problems& problems);
/// An error for all texts that the clauses require and that are missing.
Problems missing_in(const Certificate& certificate, Conformity conformity = Conformity::not_stated);
/// Likewise, and what a Digital Calibration Certificate cannot be without.
Problems missing_in_digital(const Certificate& certificate, Conformity conformity = Conformity::not_stated);

}  // namespace covaria
