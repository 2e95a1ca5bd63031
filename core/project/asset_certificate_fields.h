// Certificates of assets as project files and forms have them: each text declared once.
#pragma once

#include <string>
#include <vector>

#include "core/project/asset_certificate.h"
#include "core/project/json_fields.h"

namespace covaria {

struct AssetCertificateText {
    enum class Kind { line, date, dates };
    const char* key;
    const char* title;  ///< the title for people
    const char* help;
    std::string AssetCertificate::*member;
    Kind kind = Kind::line;
};
/// The texts of a certificate in the order of files and forms.
const std::vector<AssetCertificateText>& asset_certificate_texts();

struct FiguresFromWord {
    FiguresFrom value;
    const char* key;    ///< the key in files: "dataSheet"
    const char* title;  ///< the title for people: "data sheet"
};
const std::vector<FiguresFromWord>& figures_from_words();

const JsonFields<AssetCertificate>& asset_certificate_fields();

}  // namespace covaria
