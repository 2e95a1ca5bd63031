// Texts that were typed and cannot be read ("12 kg" for a length). The project has no place for them; they
// are kept here, count as problems and hold the runs they would have changed, until they are mended.
#pragma once

#include <QObject>
#include <map>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {

/// A field or cell, by the id of its entry, so that it stays right when entries come and go.
struct TextPlace {
    SetupAddress entry = {};
    std::string part = {};  ///< JSON pointer relative to the entry: "/setup/poses/rows/3/1"
    bool operator==(const TextPlace&) const = default;
    bool operator<(const TextPlace& other) const {
        return std::tie(entry.owner, entry.id, part) <
               std::tie(other.entry.owner, other.entry.id, other.part);
    }
};

struct UnreadText {
    QString text;
    QString reason;
    std::string instead_of = {};  ///< the project's value there; the text is forgotten when that changes
    int step = 0;                 ///< set by UnreadTexts::begin_step
    bool operator==(const UnreadText& other) const {
        return text == other.text && reason == other.reason && instead_of == other.instead_of;
    }
};

class UnreadTexts : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    using Texts = std::map<TextPlace, UnreadText>;

    /// The text at this place; null when it was read.
    const UnreadText* find(const TextPlace& place) const;
    void set(const TextPlace& place, UnreadText text);
    void remove(const TextPlace& place);
    void clear();
    /// Texts at places of the entry that begin with `part`.
    Texts under(const SetupAddress& entry, const std::string& part) const;
    void replace_under(const SetupAddress& entry, const std::string& part, Texts texts);
    const Texts& all() const { return texts_; }

    /// Texts typed from now on belong to this step; steps grow.
    void begin_step(int step) { step_ = step; }
    /// Forgets the texts of this step and of later ones; returns whether there were any.
    bool take_back(int step);
    bool has_since(int step) const;

    /// Number of texts, without those of entries that are gone.
    int count(const Project& project) const;
    /// The texts as problems of the project; those of entries that are gone are left out.
    Problems problems(const Project& project) const;
    /// The analyses that must not run, by id, with the reason; those whose studies and designs must not.
    struct Held {
        std::map<std::string, QString> analyses, inquiries;
    };
    Held held(const Project& project) const;

signals:
    void changed();

private:
    UnreadText stamped(UnreadText text, const UnreadText* before) const;

    int step_ = 0;
    Texts texts_;
};

}  // namespace covaria::ui
