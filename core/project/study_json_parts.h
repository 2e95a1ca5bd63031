// What studies and designs have in common in project files.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/project/json_lists.h"
#include "core/project/study.h"
#include "core/setup/message_text.h"

namespace covaria {

/// A choice as it is called in files.
template <class T>
struct Word {
    T value;
    const char* key;
};

template <class T, std::size_t N>
const char* key_of(const std::array<Word<T>, N>& words, T value) {
    for (const Word<T>& word : words)
        if (word.value == value) return word.key;
    return "";
}

template <class T, std::size_t N>
void read_word(ObjectReader& reader, const std::string& key, const std::array<Word<T>, N>& words, T& out) {
    const std::string text = reader.text(key);
    if (text.empty()) return;
    std::vector<std::string> known;
    for (const Word<T>& word : words) {
        if (text == word.key) out = word.value;
        known.emplace_back(word.key);
    }
    if (std::find(known.begin(), known.end(), text) == known.end())
        reader.problems().error(reader.path_of(key), "'" + key + "' must be one of " + listed(known) +
                                                         "; it is '" + text + "'" +
                                                         did_you_mean(text, known));
}

/// A problem at `path` where the number is not a whole one, or negative.
template <class Count>
void take_count(double number, const std::string& key, const std::string& path, Problems& problems,
                Count& out) {
    if (number >= 0 && number <= 1e15 && number == static_cast<double>(static_cast<Count>(number)))
        out = static_cast<Count>(number);
    else
        problems.error(path, "'" + key + "' must be a whole number that is not negative; it is " +
                                 readable_number(number));
}

template <class Count>
void read_count(ObjectReader& reader, const std::string& key, Count& out) {
    if (const auto number = reader.number(key))
        take_count(*number, key, reader.path_of(key), reader.problems(), out);
}

/// Asset, target, change, ends and unit of an axis.
void read_varied_number(ObjectReader& reader, StudyAxis& axis);
/// Likewise, into an object that is open.
void write_varied_number(JsonWriter& out, const StudyAxis& axis);

StudyOutput read_study_output(const Json& value, const std::string& path, Problems& problems);
void write_study_output(JsonWriter& out, const StudyOutput& output);

}  // namespace covaria
