#include "core/base/message.h"

#include <ostream>
#include <utility>

#include "core/base/placeholders.h"

namespace covaria {
namespace {

std::vector<const char*>& known() {
    static std::vector<const char*> known;
    return known;
}

}  // namespace

detail::KnownWords::KnownWords(const char* text) : english(text) {
    known().push_back(text);
}

const std::vector<const char*>& Message::all_words() {
    return known();
}

Message Message::of_words(const char* english, std::vector<Message> arguments) {
    Message message;
    message.known_ = english;
    message.arguments_ = std::move(arguments);
    return message;
}

Message Message::declared(std::string_view english) {
    Message message(english);
    message.kind_ = Kind::declared;
    return message;
}

Message Message::number(std::string plain) {
    Message message(std::move(plain));
    message.kind_ = Kind::number;
    return message;
}

std::string Message::english() const {
    return in([](const std::string& text) { return text; });
}

std::string Message::in(const Words& translate, const Numbers& write) const {
    if (kind_ == Kind::number) return write ? write(text_) : text_;
    std::string text = known_                                      ? translate(known_)
                       : kind_ == Kind::declared && !text_.empty() ? translate(text_)
                                                                   : text_;
    if (arguments_.empty()) return text;
    std::vector<std::string> arguments;
    for (const Message& argument : arguments_) arguments.push_back(argument.in(translate, write));
    return fill_placeholders<std::string>(text, arguments);
}

Message& Message::operator+=(Message more) {
    if (empty()) return *this = std::move(more);
    if (more.empty()) return *this;
    Message joined("%1%2");
    joined.arguments_ = {std::move(*this), std::move(more)};
    return *this = std::move(joined);
}

std::ostream& operator<<(std::ostream& out, const Message& message) {
    return out << message.english();
}

}  // namespace covaria
