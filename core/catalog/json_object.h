// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "vocabulary/local_text.h"
#include "vocabulary/word.h"

#include <QCoreApplication>

#include <initializer_list>
#include <json/value.h>
#include <limits>
#include <map>

namespace codewheel {

// Keeps the first fault found in a description file. Reading goes on with harmless values, so that the
// readers need no error paths of their own.
class FaultKeeper
{
public:
    FaultKeeper(const QByteArray &json, QString file);

    void report(int line, const QString &key, const QString &reason);
    void report(const Json::Value &where, const QString &key, const QString &reason);
    const std::optional<Catalog::Fault> &first() const { return m_first; }

private:
    const QByteArray &m_json;
    QString m_file;
    std::optional<Catalog::Fault> m_first;
};

// A name in a description file and what it stands for.
template <typename Enum>
struct NamedValue
{
    const char *name;
    Enum value;
};

// One object of a description file: returns its members with the type asked for and reports what is missing,
// of the wrong type, out of range or unknown.
class JsonObject
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::JsonObject)

public:
    // `allowed` are all the keys the object may have; `path` names its place: "parameters[2]".
    JsonObject(const Json::Value &value, QString path, std::initializer_list<const char *> allowed,
               FaultKeeper &faults);
    // With any keys: allowOnly() restricts them once it is known what the object is.
    JsonObject(const Json::Value &value, QString path, FaultKeeper &faults);
    void allowOnly(std::initializer_list<const char *> allowed) const;

    bool has(const char *key) const { return m_value->isObject() && m_value->isMember(key); }
    // Where other types are accepted too.
    bool hasObject(const char *key) const { return has(key) && (*m_value)[key].isObject(); }
    QString text(const char *key) const; // not empty
    QString textOr(const char *key, const QString &otherwise) const;
    QString freeText(const char *key) const;  // any text; empty if the key is missing
    QStringList texts(const char *key) const; // a list of texts
    // "DO1", the same in every language, or {"en": "...", "de": "..."}, where English is required.
    LocalText localText(const char *key) const;
    LocalText localTextOr(const char *key, const LocalText &otherwise) const;
    bool flag(const char *key) const;
    bool flagOr(const char *key, bool otherwise) const { return has(key) ? flag(key) : otherwise; }
    std::int64_t number(const char *key, std::int64_t minimum = std::numeric_limits<std::int64_t>::min(),
                        std::int64_t maximum = std::numeric_limits<std::int64_t>::max()) const;
    Value value(const char *key) const; // a whole number or a text
    // Empty if the key is missing.
    std::optional<std::int64_t>
    optionalNumber(const char *key, std::int64_t minimum = std::numeric_limits<std::int64_t>::min(),
                   std::int64_t maximum = std::numeric_limits<std::int64_t>::max()) const;
    // A small whole number; `otherwise` if the key is missing.
    int numberOr(const char *key, int otherwise, int minimum, int maximum) const;
    // Any number; `otherwise` if the key is missing.
    double decimalOr(const char *key, double otherwise, double minimum, double maximum) const;
    // Text as used in the field: "37h".
    unsigned hexNumber(const char *key) const;
    // A list of process-data words: "020000FF".
    std::vector<Word> words(const char *key, std::size_t most) const;
    // An object with any keys, each with a text; empty if the key is missing.
    std::map<QString, QString> textsByKey(const char *key) const;

    template <typename Enum, std::size_t size>
    Enum oneOf(const char *key, const NamedValue<Enum> (&names)[size]) const
    {
        QStringList known;
        const QString wanted = text(key);
        for (const NamedValue<Enum> &name : names) {
            known << QString::fromLatin1(name.name);
            if (wanted == known.last())
                return name.value;
        }
        reportUnknownName(key, wanted, known);
        return names[0].value;
    }

    JsonObject object(const char *key, std::initializer_list<const char *> allowed) const;
    JsonObject objectOfAny(const char *key) const;
    std::vector<JsonObject> array(const char *key, std::initializer_list<const char *> allowed,
                                  std::size_t most = std::numeric_limits<std::size_t>::max()) const;

    std::vector<JsonObject> arrayOfAny(const char *key,
                                       std::size_t most = std::numeric_limits<std::size_t>::max()) const;

    // Reports a fault of the member `key`, for rules that go beyond one value.
    void report(const char *key, const QString &reason) const;
    void reportUnknownName(const char *key, const QString &name, const QStringList &known) const;

private:
    const Json::Value &member(const char *key) const; // reports it if missing
    bool isListOfAtMost(const char *key, std::size_t most) const;
    QString pathOf(const QString &key) const { return m_path.isEmpty() ? key : m_path + u'.' + key; }

    const Json::Value *m_value;
    QString m_path;
    FaultKeeper *m_faults;
};

} // namespace codewheel
