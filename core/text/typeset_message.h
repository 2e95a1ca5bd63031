// A message about a symbol, said in a language with its symbol typeset.
#pragma once

#include <concepts>

#include "core/base/message.h"
#include "core/text/document_language.h"
#include "core/text/text.h"

namespace covaria {

class TypesetMessage {
public:
    TypesetMessage() = default;
    template <std::convertible_to<Message> Words>
    TypesetMessage(Words without_symbol) : words_(std::move(without_symbol)), pattern_(words_) {}

    /// of<"%1: estimate">(symbol)
    template <detail::Words words>
    static TypesetMessage of(const Text& symbol) {
        TypesetMessage made;
        made.words_ = tell<words>(to_unicode(symbol));
        made.pattern_ = tell<words>("%1");
        made.symbol_ = symbol;
        return made;
    }

    /// within<"%1, factor">(): this as the argument of more words
    template <detail::Words words>
    TypesetMessage within() const {
        TypesetMessage made = *this;
        made.words_ = tell<words>(words_);
        made.pattern_ = tell<words>(pattern_);
        return made;
    }

    /// The message with the symbol in Unicode.
    const Message& message() const { return words_; }
    Text in(const DocumentLanguage& language) const;
    bool empty() const { return words_.empty(); }

private:
    Message words_;
    Message pattern_;  ///< "%1" for the symbol, where there is one
    Text symbol_;
};

}  // namespace covaria
