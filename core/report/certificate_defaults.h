// Texts that a certificate has in place of those that are not given.
#pragma once

#include <string>

#include "core/project/certificate.h"
#include "core/text/document_language.h"

namespace covaria {

/// The text in place of one that is not given: "in the laboratory"; empty where there is none, or the
/// certificate says that it is not stated.
std::string said_in_place_of(std::string Certificate::*text, const DocumentLanguage& in);

}  // namespace covaria
