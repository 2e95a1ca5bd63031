// Words of the pages of help beside their files and the registries, in English; internal to core/manual and
// to the list of texts.
#pragma once

#include "core/text/document_language.h"

namespace covaria::help_words {

inline const Phrase fields_of_set_up{"Fields of the set-up"};
inline const Phrase equations{"Equations as evaluated"};
inline const Phrase notes{"Notes"};
inline const Phrase references{"References"};
inline const Phrase covered{"Sources of error that are covered"};
inline const Phrase not_covered{"Not covered"};
inline const Phrase options{"Options of the evaluation"};
inline const Phrase certificate{"Certificate"};
inline const Phrase about_certificate{
    "What a calibration certificate says beside its results, with the clause of ISO/IEC 17025:2017 that asks "
    "for it."};

// Words about the values of a field
inline const Phrase optional{"optional"};
inline const Phrase default_value{"default %1"};
inline const Phrase choices{"Choices: "};
inline const Phrase required_by{"required by %1"};
inline const Phrase asked_for_by{"asked for by %1"};
inline const Phrase required_for_conformity{"required by %1 where conformity is stated"};

}  // namespace covaria::help_words
