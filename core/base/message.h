// A message to the user as a value: words of the program with what stands in them. It is worded at the edge,
// in English or through a catalogue.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace covaria {

/// A message to the user. Nothing of it is parsed back: what depends on a failure reads its code and path.
class Message {
public:
    /// The translation of an English text; the text itself where there is none.
    using Words = std::function<std::string(const std::string& english)>;
    /// The written form of a plain number: "−2,3×10⁻⁵".
    using Numbers = std::function<std::string(const std::string& plain)>;

    Message() = default;
    /// Makes a message that is the same in every language: names that people gave, numbers, words of other
    /// programs.
    Message(std::string as_it_is) : text_(std::move(as_it_is)) {}
    Message(const char* as_it_is) : text_(as_it_is) {}
    Message(std::string_view as_it_is) : text_(as_it_is) {}
    template <std::integral Count>
    requires(!std::same_as<Count, bool>) Message(Count count) {
        if constexpr (std::same_as<Count, char>)
            text_ = count;
        else
            text_ = std::to_string(count);
    }

    /// "%1" to "%9" stand for the arguments; the words live as long as the program.
    static Message of_words(const char* english, std::vector<Message> arguments);
    /// Makes a message of what a registry declares: the title of a field.
    static Message declared(std::string_view english);
    /// A plain number ("-2.3e-05"), which is written as its reader writes numbers.
    static Message number(std::string plain);

    std::string english() const;  ///< numbers plain
    std::string in(const Words& translate, const Numbers& write = {}) const;
    bool empty() const { return !known_ && text_.empty(); }

    Message& operator+=(Message more);
    friend Message operator+(Message first, Message second) { return first += std::move(second); }
    friend bool operator==(const Message& a, const Message& b) { return a.english() == b.english(); }
    friend std::ostream& operator<<(std::ostream& out, const Message& message);

    /// All texts that `tell` is called with, in the program that asks.
    static const std::vector<const char*>& all_words();

private:
    const char* known_ = nullptr;  ///< words given to `tell`; null: the text counts
    std::string text_;
    std::vector<Message> arguments_;
    enum class Kind { as_it_is, declared, number } kind_ = Kind::as_it_is;  ///< kind of the text
};

namespace detail {

/// A text as a parameter of a template.
template <std::size_t size>
struct Words {
    char letters[size] = {};

    consteval Words(const char (&text)[size]) { std::copy_n(text, size, letters); }

    constexpr std::size_t placeholders() const {
        std::size_t highest = 0;
        for (std::size_t i = 0; i + 1 < size; ++i)
            if (letters[i] == '%' && letters[i + 1] >= '1' && letters[i + 1] <= '9')
                highest = std::max(highest, std::size_t(letters[i + 1] - '0'));
        return highest;
    }
};

/// Being named in the program puts a text in the list that catalogues are filled from.
struct KnownWords {
    explicit KnownWords(const char* english);
    const char* english;
};

template <Words words>
inline const KnownWords known_words{words.letters};

}  // namespace detail

/// tell<"'%1' has %2 rows">(name, count); an argument can be a message.
template <detail::Words words, class... Arguments>
Message tell(Arguments&&... arguments) {
    static_assert(words.placeholders() == sizeof...(Arguments), "each of %1, %2, ... needs its argument");
    return Message::of_words(detail::known_words<words>.english,
                             {Message(std::forward<Arguments>(arguments))...});
}

/// A text that is kept as one (the head of a table, a name in a legend) and translated where it is shown:
/// known_text<"present series">() is in the list for catalogues also where no example shows it.
template <detail::Words words>
std::string known_text() {
    static_assert(words.placeholders() == 0);
    return detail::known_words<words>.english;
}

}  // namespace covaria
