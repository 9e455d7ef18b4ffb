// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_object.h"

#include "encoder/hex.h"

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
    const QByteArrayView before = QByteArrayView(m_json).first(where.getOffsetStart());
    report(static_cast<int>(std::ranges::count(before, '\n')) + 1, key, reason);
}

JsonObject::JsonObject(const Json::Value &value, QString path, std::initializer_list<const char *> allowed,
                       FaultKeeper &faults)
    : m_value(value.isObject() ? &value : &Json::Value::nullSingleton())
    , m_path(std::move(path))
    , m_faults(&faults)
{
    if (value.isObject())
        refuseUnknownKeys(allowed);
    else
        m_faults->report(value, m_path, tr("An object { } is expected here."));
}

void JsonObject::refuseUnknownKeys(std::initializer_list<const char *> allowed) const
{
    QStringList known;
    for (const char *key : allowed)
        known << QString::fromLatin1(key);
    for (auto it = m_value->begin(); it != m_value->end(); ++it) {
        const QString key = QString::fromStdString(it.name());
        if (!known.contains(key))
            m_faults->report(
                *it, pathOf(key),
                tr("This key is not known. Known are: %1.").arg(known.join(QStringLiteral(", "))));
    }
}

QString JsonObject::pathOf(const QString &key) const
{
    return m_path.isEmpty() ? key : m_path + u'.' + key;
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

bool JsonObject::has(const char *key) const
{
    return m_value->isObject() && m_value->isMember(key);
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
    if (!value.isObject()) {
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

bool JsonObject::flagOr(const char *key, bool otherwise) const
{
    return has(key) ? flag(key) : otherwise;
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

std::optional<std::int64_t> JsonObject::optionalNumber(const char *key, std::int64_t minimum,
                                                       std::int64_t maximum) const
{
    return has(key) ? std::optional(number(key, minimum, maximum)) : std::nullopt;
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
    return JsonObject(member(key), pathOf(QString::fromLatin1(key)), allowed, *m_faults);
}

std::vector<JsonObject> JsonObject::array(const char *key, std::initializer_list<const char *> allowed) const
{
    const Json::Value &value = member(key);
    if (!value.isArray()) {
        report(key, tr("A list [ ] is expected here."));
        return {};
    }
    std::vector<JsonObject> rows;
    for (const Json::Value &row : value) {
        const QString path = QStringLiteral("%1[%2]").arg(QLatin1String(key)).arg(rows.size());
        rows.emplace_back(row, pathOf(path), allowed, *m_faults);
    }
    return rows;
}

} // namespace codewheel
