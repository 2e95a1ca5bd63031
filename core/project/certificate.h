// The texts of a calibration certificate beside its results (ISO/IEC 17025 7.8.2, 7.8.4). Each text is
// declared once and bound to its member: project file, its JSON schema, `--set`, form, certificate and
// `covaria validate --certificate` follow.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// The texts of a certificate, all as they were typed; a project whose texts are all empty has no
/// certificate.
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
    /// Number and date of the certificate that this one replaces, and why it does.
    std::string replaces = {}, replaced_issued = {}, reasons = {};

    bool empty() const { return *this == Certificate{}; }
    bool operator==(const Certificate&) const = default;
};

enum class CertificateText {
    line,
    lines,     ///< a text that may have several lines
    country,   ///< a country by two capital letters: DE
    date,      ///< a date by ISO 8601: 2026-04-17
    dates,     ///< a date, or an interval of two: 2026-04-17/2026-04-18
    language,  ///< one of certificate_languages(); an empty text means English
    site,      ///< one of certificate_sites(); empty: the laboratory, or elsewhere where a place is stated
    picture    ///< name of a PNG or JPEG file, relative to the project's folder
};

/// Whether the certificate says of its results that they lie within a tolerance.
enum class Conformity { not_stated, stated };

struct CertificateField {
    /// Key of the object that the field is in; empty where it is in the certificate itself.
    const char* group;
    const char* key;
    const char* title;  ///< the title for people
    const char* help;
    std::string Certificate::*member;
    CertificateText kind = CertificateText::line;
    /// The clause of ISO/IEC 17025:2017 that asks for the field, if one does.
    const char* clause = "";
    bool required = false;                        ///< whether that clause requires it of every certificate
    std::string Certificate::*or_else = nullptr;  ///< the field that may stand in for a required one
    /// Whether that clause requires it where conformity is stated.
    bool required_for_conformity = false;
};

struct CertificateLanguage {
    const char* code;  ///< the code of the language: "zh_CN"
    const char* name;  ///< the name in the language itself
};
/// The languages of certificates, English first.
const std::vector<CertificateLanguage>& certificate_languages();

/// A site that a calibration was performed at, by whose it is; the keys are those of Digital Calibration
/// Certificates.
struct CertificateSite {
    const char* key;
    const char* words;  ///< the site in words: "at the customer"
};
const std::vector<CertificateSite>& certificate_sites();
/// The site that was chosen; else the laboratory, or elsewhere where a place is stated.
const CertificateSite& site_of(const Certificate& certificate);

struct CertificateSection {
    const char* title;  ///< the title of the section in a form
    std::vector<CertificateField> fields;
};

/// All fields, as forms group them.
const std::vector<CertificateSection>& certificate_sections();
/// All fields in the order of files and forms; the fields of a group follow one another.
const std::vector<CertificateField>& certificate_fields();
const CertificateField& certificate_field(std::string Certificate::*member);
/// The place of a field in the project file: "/certificate/item/serialNumber".
std::string pointer_of(const CertificateField& field);
/// Whether a text is nothing but blanks.
bool is_blank(const std::string& text);
/// Whether a field is required, and neither it nor the field that may stand in for it is filled in.
bool is_missing(const CertificateField& field, const Certificate& certificate,
                Conformity conformity = Conformity::not_stated);

/// The reason why a text cannot stand in a field (a date or country that is none); empty where it can.
Message complaint_about(const CertificateField& field, const std::string& text);
/// Reports an error for texts that cannot stand in their fields, and for an amended certificate that has the
/// number of the one that it replaces; a warning for dates in the wrong order and for a country that only a
/// digital certificate needs; paths are from the root of the project.
void check_certificate(const Certificate& certificate, Problems& problems);
/// The gaps of a certificate: an error for each text that the clauses require and that is missing.
Problems missing_in(const Certificate& certificate, Conformity conformity = Conformity::not_stated);
/// The gaps of a digital certificate: those of `missing_in`, and the texts that a Digital Calibration
/// Certificate cannot be without.
Problems missing_in_digital(const Certificate& certificate, Conformity conformity = Conformity::not_stated);

}  // namespace covaria
