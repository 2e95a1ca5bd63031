// What a certificate says in place of a text that is not given.
#pragma once

#include <string>

#include "core/project/certificate.h"
#include "core/text/document_language.h"

namespace covaria {

/// "in the laboratory"; empty: nothing, or that it is not stated.
std::string said_in_place_of(std::string Certificate::*text, const DocumentLanguage& in);

}  // namespace covaria
