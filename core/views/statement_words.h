// The words that a result line says of its own, in English.
#pragma once

#include "core/text/document_language.h"

namespace covaria::statement_words {

inline const Phrase exact{"%1 (exact)"};
inline const Phrase not_finite{"%1 (U not finite)"};
inline const Phrase without_k{"without k, because u is not finite"};
inline const Phrase coverage_interval{"coverage interval %1"};

}  // namespace covaria::statement_words
