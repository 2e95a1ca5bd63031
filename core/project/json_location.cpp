#include "core/project/json_location.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/utf8.h"

namespace covaria {

namespace {

constexpr int deepest = 64;

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// The grammar of a number is RFC 8259 section 6: -? (0 | [1-9][0-9]*) (. [0-9]+)? ([eE] [+-]? [0-9]+)?
bool is_json_number(std::string_view word) {
    std::size_t i = 0;
    const auto digits = [&] {
        const std::size_t begin = i;
        while (i < word.size() && is_digit(word[i])) ++i;
        return i > begin;
    };
    if (i < word.size() && word[i] == '-') ++i;
    if (i < word.size() && word[i] == '0')
        ++i;
    else if (!digits())
        return false;
    if (i < word.size() && word[i] == '.') {
        ++i;
        if (!digits()) return false;
    }
    if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
        ++i;
        if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
        if (!digits()) return false;
    }
    return i == word.size();
}

bool is_not_finite(std::string word) {
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
    return word == "nan" || word == "inf" || word == "infinity";
}

}  // namespace

std::string pointer_token(const std::string& token) {
    std::string escaped;
    for (const char c : token) {
        if (c == '~')
            escaped += "~0";
        else if (c == '/')
            escaped += "~1";
        else
            escaped += c;
    }
    return escaped;
}

/// Scanner of a text by recursive descent; the first failure ends it.
class JsonScanner {
public:
    JsonScanner(std::string_view text, JsonLocations& found) : text_(text), found_(found) {
        if (text_.starts_with(byte_order_mark)) at_ = line_begin_ = byte_order_mark.size();
    }

    Result<void> run() {
        skip_space();
        if (at_end()) return fail(ErrorCode::bad_input, tell<"the file is empty">());
        if (!value("", 0)) return tl::unexpected<Error>(error_);
        skip_space();
        if (at_end()) return {};
        refuse(tell<"the project ends before this: nothing may follow its closing '}'">());
        return tl::unexpected<Error>(error_);
    }

private:
    bool at_end() const { return at_ >= text_.size(); }

    void skip_space() {
        while (!at_end() && is_space(text_[at_])) {
            if (text_[at_] == '\n') {
                ++line_;
                line_begin_ = at_ + 1;
            }
            ++at_;
        }
    }

    bool refuse(const Message& message) {
        const std::string_view before = text_.substr(line_begin_, at_ - line_begin_);
        const auto characters =
            std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) != 0x80; });
        error_ = {ErrorCode::bad_input, tell<"%1 (column %2)">(message, characters + 1), {}, {}, line_};
        return false;
    }

    bool refuse_end(const Message& inside) {
        error_ = {ErrorCode::bad_input,
                  tell<"the file is truncated: it ends %1; its rest is missing">(inside),
                  {},
                  {},
                  line_};
        return false;
    }

    bool value(const std::string& pointer, int depth) {
        if (depth > deepest) return refuse(tell<"lists and objects are nested too deeply">());
        skip_space();
        if (at_end()) return refuse_end(tell<"where a value is expected">());
        line_at_[static_cast<std::size_t>(depth)] = line_;
        // A value on the line of the one around it is found by that one: a row's cells by their row.
        if (depth <= 1 || line_at_[static_cast<std::size_t>(depth - 1)] != line_)
            found_.lines_[pointer] = line_;
        if (text_[at_] == '{') return object(pointer, depth);
        if (text_[at_] == '[') return list(pointer, depth);
        if (text_[at_] == '"') return string();
        return word();
    }

    bool word() {
        const std::size_t begin = at_;
        std::size_t end = text_.find_first_of(" \t\r\n,:{}[]\"", begin);
        if (end == std::string_view::npos) end = text_.size();
        return check_word(std::string(text_.substr(begin, end - begin)), end);
    }
    bool check_word(const std::string& word, std::size_t end);
    bool object(const std::string& pointer, int depth);
    bool member(const std::string& pointer, int depth, std::set<std::string>& keys);
    bool list(const std::string& pointer, int depth);
    bool string();
    enum class Next { another, closed, wrong };
    Next next(char close, const Message& inside);

    std::string_view text_;
    JsonLocations& found_;
    std::size_t at_ = 0;
    std::size_t line_begin_ = 0;
    int line_ = 1;
    std::array<int, deepest + 1> line_at_{};  // line of the value around, by depth
    Error error_;
};

bool JsonScanner::check_word(const std::string& word, std::size_t end) {
    const bool number = is_json_number(word);
    if (number && std::isinf(std::strtod(word.c_str(), nullptr)))
        return refuse(tell<"'%1' is too large a number">(word));
    if (number || word == "true" || word == "false" || word == "null") {
        at_ = end;
        return true;
    }
    if (end == text_.size() && !word.empty() && !is_not_finite(word))
        return refuse_end(tell<"in the middle of a value">());
    if (word.empty())
        return refuse(
            tell<"a value is expected here (a number, a text in quotes, a list or an object), not '%1'">(
                text_[at_]));
    if (is_not_finite(word))
        return refuse(tell<"'%1' is not a number that a project file can hold: give a finite number, or null "
                           "where infinity is meant">(word));
    return refuse(
        tell<"'%1' is not a value: texts stand in double quotes, numbers are written like -12.5e-3">(word));
}

bool JsonScanner::string() {
    ++at_;
    while (!at_end() && text_[at_] != '"') {
        if (static_cast<unsigned char>(text_[at_]) < 0x20)
            return refuse(tell<"the text that begins here is not closed by a double quote on its line">());
        at_ += text_[at_] == '\\' ? 2 : 1;
    }
    if (at_end()) return refuse_end(tell<"in the middle of a text">());
    ++at_;
    return true;
}

// After a value there is a comma, or the closing bracket.
JsonScanner::Next JsonScanner::next(char close, const Message& inside) {
    skip_space();
    if (at_end()) {
        refuse_end(tell<"inside %1">(inside));
        return Next::wrong;
    }
    const char c = text_[at_];
    if (c == close || c == ',') {
        ++at_;
        return c == close ? Next::closed : Next::another;
    }
    refuse(tell<"',' or '%1' is expected here, inside %2, not '%3'">(close, inside, c));
    return Next::wrong;
}

bool JsonScanner::object(const std::string& pointer, int depth) {
    ++at_;
    skip_space();
    if (!at_end() && text_[at_] == '}') {
        ++at_;
        return true;
    }
    std::set<std::string> keys;
    while (member(pointer, depth, keys)) {
        const Next after = next('}', tell<"an object">());
        if (after != Next::another) return after == Next::closed;
    }
    return false;
}

bool JsonScanner::member(const std::string& pointer, int depth, std::set<std::string>& keys) {
    skip_space();
    if (at_end()) return refuse_end(tell<"inside %1">(tell<"an object">()));
    if (text_[at_] != '"') return refuse(tell<"a key in double quotes is expected here">());
    const std::size_t begin = at_;
    const int key_line = line_;
    if (!string()) return false;
    const auto key = nlohmann::json::parse(text_.substr(begin, at_ - begin), nullptr, false);
    if (!key.is_string()) return refuse(tell<"the key before this is not a valid text">());
    const std::string place = pointer + "/" + pointer_token(key.get<std::string>());
    if (!keys.insert(key.get<std::string>()).second)
        found_.duplicate_keys_.add({Severity::error,
                                    place,
                                    tell<"'%1' is given twice in the same object">(key.get<std::string>()),
                                    {},
                                    key_line});
    skip_space();
    if (at_end()) return refuse_end(tell<"after the key '%1'">(key.get<std::string>()));
    if (text_[at_] != ':') return refuse(tell<"':' is expected after the key '%1'">(key.get<std::string>()));
    ++at_;
    return value(place, depth + 1);
}

bool JsonScanner::list(const std::string& pointer, int depth) {
    ++at_;
    skip_space();
    if (!at_end() && text_[at_] == ']') {
        ++at_;
        return true;
    }
    for (std::size_t i = 0; value(pointer + "/" + std::to_string(i), depth + 1); ++i) {
        const Next after = next(']', tell<"a list">());
        if (after != Next::another) return after == Next::closed;
    }
    return false;
}

Result<JsonLocations> JsonLocations::scan(std::string_view text) {
    JsonLocations found;
    if (auto scanned = JsonScanner(text, found).run(); !scanned) return fail(scanned.error());
    return found;
}

int JsonLocations::line(const std::string& pointer) const {
    for (std::string place = pointer; !place.empty(); place.erase(place.rfind('/'))) {
        const auto found = lines_.find(place);
        if (found != lines_.end()) return found->second;
        if (place.find('/') == std::string::npos) break;
    }
    return 0;
}

}  // namespace covaria
