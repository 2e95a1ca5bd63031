// Names that the program gives where people give theirs too: groups of quantities, contributors. Files and
// addresses have them in English; people read them in their language.
#pragma once

#include <string>

#include "core/base/message.h"

namespace covaria {

namespace detail {

struct OwnName {
    explicit OwnName(const KnownWords& words);
    const char* english;
};

template <Words name>
inline const OwnName own_name{known_words<name>};

}  // namespace detail

/// own_name<"distances">(): the text as it is in files, known to `said_name`.
template <detail::Words name>
std::string own_name() {
    return detail::own_name<name>.english;
}

/// own_name<"joint %1">(3) or of a name that somebody gave: likewise.
template <detail::Words name>
std::string own_name(const Message& part) {
    static_assert(name.placeholders() == 1);
    return Message::of_words(detail::own_name<name>.english, {part}).english();
}

/// A name for people: the program's own are said in the reader's language, all others as they are.
Message said_name(const std::string& name);

}  // namespace covaria
