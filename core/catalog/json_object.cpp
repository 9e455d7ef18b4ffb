// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_object.h"

#include "vocabulary/hex.h"

#include <algorithm>

namespace codewheel {

FaultKeeper::FaultKeeper(const QByteArray &json, QString file)
    : m_json(json)
    , m_file(std::move(file))
{}

void FaultKeeper::report(int line, const QString &key, const QString &reason)
{
    if (!m_first)
        m_first = Catalog::Fault{m_file, line, key, reason};
}

void FaultKeeper::report(const Json::Value &where, const QString &key, const QString &reason)
{
    if (m_first) // counting the lines of a large file takes its time
        return;
    const QByteArrayView before = QByteArrayView(m_json).first(where.getOffsetStart());
    report(static_cast<int>(std::ranges::count(before, '\n')) + 1, key, reason);
}

JsonObject::JsonObject(const Json::Value &value, QString path, FaultKeeper &faults)
    : m_value(value.isObject() ? &value : &Json::Value::nullSingleton())
    , m_path(std::move(path))
    , m_faults(&faults)
{
    if (!value.isObject())
        m_faults->report(value, m_path, tr("An object { } is expected here."));
}

JsonObject::JsonObject(const Json::Value &value, QString path, std::initializer_list<const char *> allowed,
                       FaultKeeper &faults)
    : JsonObject(value, std::move(path), faults)
{
    allowOnly(allowed);
}

void JsonObject::allowOnly(std::initializer_list<const char *> allowed) const
{
    for (auto it = m_value->begin(); it != m_value->end(); ++it) {
        const std::string key = it.name();
        if (std::ranges::find(allowed, key) != allowed.end())
            continue;
        QStringList known;
        for (const char *name : allowed)
            known << QString::fromLatin1(name);
        m_faults->report(*it, pathOf(QString::fromStdString(key)),
                         tr("This key is not known. Known are: %1.").arg(known.join(QStringLiteral(", "))));
        return;
    }
}

void JsonObject::report(const char *key, const QString &reason) const
{
    const Json::Value &where = has(key) ? (*m_value)[key] : *m_value;
    m_faults->report(where, pathOf(QString::fromLatin1(key)), reason);
}

void JsonObject::reportUnknownName(const char *key, const QString &name, const QStringList &known) const
{
    report(key, tr("\"%1\" is not known here. Known are: %2.").arg(name, known.join(QStringLiteral(", "))));
}

const Json::Value &JsonObject::member(const char *key) const
{
    if (!has(key)) {
        report(key, tr("This key is missing."));
        return Json::Value::nullSingleton();
    }
    return (*m_value)[key];
}

QString JsonObject::text(const char *key) const
{
    const Json::Value &value = member(key);
    QString result = value.isString() ? QString::fromStdString(value.asString()) : QString();
    if (result.trimmed().isEmpty())
        report(key, tr("A text in quotation marks is expected here."));
    return result;
}

QString JsonObject::textOr(const char *key, const QString &otherwise) const
{
    return has(key) ? text(key) : otherwise;
}

QString JsonObject::freeText(const char *key) const
{
    if (!has(key))
        return {};
    const Json::Value &value = member(key);
    if (!value.isString()) {
        report(key, tr("A text in quotation marks is expected here."));
        return {};
    }
    return QString::fromStdString(value.asString());
}

std::map<QString, QString> JsonObject::textsByKey(const char *key) const
{
    std::map<QString, QString> result;
    if (!has(key))
        return result;
    const Json::Value &value = member(key);
    bool sound = value.isObject();
    for (auto it = value.begin(); sound && it != value.end(); ++it) {
        sound = it->isString();
        result[QString::fromStdString(it.name())] = QString::fromStdString(sound ? it->asString() : "");
    }
    if (!sound)
        report(key, tr("An object of texts {\"...\": \"...\"} is expected here."));
    return result;
}

QStringList JsonObject::texts(const char *key) const
{
    const Json::Value &value = member(key);
    QStringList result;
    bool sound = value.isArray();
    if (sound)
        for (const Json::Value &each : value) {
            sound = sound && each.isString();
            result << (each.isString() ? QString::fromStdString(each.asString()) : QString());
        }
    if (!sound)
        report(key, tr("A list of texts [\"...\"] is expected here."));
    return result;
}

LocalText JsonObject::localText(const char *key) const
{
    const Json::Value &value = member(key);
    if (value.isString())
        return {{{QString(), text(key)}}};
    if (!hasObject(key)) {
        report(key,
               tr("A text in quotation marks or an object {\"en\": \"...\", \"de\": \"...\"} is expected "
                  "here."));
        return {};
    }
    const JsonObject languages = object(key, {"en", "de"});
    LocalText result{{{QStringLiteral("en"), languages.text("en")}}};
    if (languages.has("de"))
        result.byLanguage.insert(QStringLiteral("de"), languages.text("de"));
    return result;
}

LocalText JsonObject::localTextOr(const char *key, const LocalText &otherwise) const
{
    return has(key) ? localText(key) : otherwise;
}

bool JsonObject::flag(const char *key) const
{
    const Json::Value &value = member(key);
    if (!value.isBool())
        report(key, tr("true or false is expected here."));
    return value.isBool() && value.asBool();
}

std::int64_t JsonObject::number(const char *key, std::int64_t minimum, std::int64_t maximum) const
{
    const Json::Value &value = member(key);
    const bool whole = value.type() == Json::intValue || value.type() == Json::uintValue;
    if (!whole || !value.isInt64()) {
        report(key, tr("A whole number is expected here."));
        return minimum;
    }
    const std::int64_t result = value.asInt64();
    if (result < minimum || result > maximum)
        report(key, tr("%1 is not between %2 and %3.").arg(result).arg(minimum).arg(maximum));
    return std::clamp(result, minimum, maximum);
}

Value JsonObject::value(const char *key) const
{
    if (member(key).isString())
        return Value(freeText(key));
    return number(key);
}

std::optional<std::int64_t> JsonObject::optionalNumber(const char *key, std::int64_t minimum,
                                                       std::int64_t maximum) const
{
    return has(key) ? std::optional(number(key, minimum, maximum)) : std::nullopt;
}

int JsonObject::numberOr(const char *key, int otherwise, int minimum, int maximum) const
{
    return static_cast<int>(optionalNumber(key, minimum, maximum).value_or(otherwise));
}

double JsonObject::decimalOr(const char *key, double otherwise, double minimum, double maximum) const
{
    if (!has(key))
        return otherwise;
    const Json::Value &value = member(key);
    if (!value.isNumeric()) {
        report(key, tr("A number is expected here."));
        return otherwise;
    }
    const double result = value.asDouble();
    if (result < minimum || result > maximum)
        report(key, tr("%1 is not between %2 and %3.").arg(result).arg(minimum).arg(maximum));
    return std::clamp(result, minimum, maximum);
}

unsigned JsonObject::hexNumber(const char *key) const
{
    const QString written = text(key);
    const auto parsed = written.endsWith(u'h') ? parseHexWord(written) : std::nullopt;
    if (!parsed)
        report(key, tr("A hexadecimal number such as \"37h\" is expected here."));
    return parsed.value_or(0);
}

JsonObject JsonObject::object(const char *key, std::initializer_list<const char *> allowed) const
{
    JsonObject object = objectOfAny(key);
    object.allowOnly(allowed);
    return object;
}

JsonObject JsonObject::objectOfAny(const char *key) const
{
    return JsonObject(member(key), pathOf(QString::fromLatin1(key)), *m_faults);
}

bool JsonObject::isListOfAtMost(const char *key, std::size_t most) const
{
    const Json::Value &value = member(key);
    if (!value.isArray())
        report(key, tr("A list [ ] is expected here."));
    else if (value.size() > most)
        report(key, tr("The list has %1 entries; at most %2 are allowed.").arg(value.size()).arg(most));
    return value.isArray() && value.size() <= most;
}

std::vector<Word> JsonObject::words(const char *key, std::size_t most) const
{
    std::vector<Word> result;
    if (!isListOfAtMost(key, most))
        return result;
    for (const Json::Value &value : member(key)) {
        const auto word =
            value.isString() ? parseHexWord(QString::fromStdString(value.asString())) : std::nullopt;
        if (!word)
            m_faults->report(value,
                             pathOf(QStringLiteral("%1[%2]").arg(QLatin1String(key)).arg(result.size())),
                             tr("A word is a text of up to 8 hexadecimal digits, such as \"020000FF\"."));
        result.push_back(word.value_or(0));
    }
    return result;
}

std::vector<JsonObject> JsonObject::array(const char *key, std::initializer_list<const char *> allowed,
                                          std::size_t most) const
{
    std::vector<JsonObject> rows = arrayOfAny(key, most);
    for (const JsonObject &row : rows)
        row.allowOnly(allowed);
    return rows;
}

std::vector<JsonObject> JsonObject::arrayOfAny(const char *key, std::size_t most) const
{
    std::vector<JsonObject> rows;
    if (!isListOfAtMost(key, most))
        return rows;
    for (const Json::Value &row : member(key)) {
        const QString path = QStringLiteral("%1[%2]").arg(QLatin1String(key)).arg(rows.size());
        rows.emplace_back(row, pathOf(path), *m_faults);
    }
    return rows;
}

} // namespace codewheel
