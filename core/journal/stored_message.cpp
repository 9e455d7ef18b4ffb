// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/stored_message.h"

#include "journal/argument_json.h"
#include "journal/journal_texts.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/texts_of_kinds.h"

#include <QHash>
#include <QJsonDocument>
#include <QJsonObject>

namespace codewheel {
namespace {

constexpr QLatin1String kindKey("kind");
constexpr QLatin1String codeKey("code");
constexpr QLatin1String argumentsKey("arguments");

constexpr std::array refusalKinds{
    std::pair{RefusalKind::badInput, "badInput"}, std::pair{RefusalKind::notSupported, "notSupported"},
    std::pair{RefusalKind::busy, "busy"},         std::pair{RefusalKind::device, "device"},
    std::pair{RefusalKind::link, "link"},         std::pair{RefusalKind::stopped, "stopped"},
};

template <typename Said>
using CodesByKey = QHash<QString, SentenceCode<Said>>;

template <typename Said>
CodesByKey<Said> codesByKey(std::span<const SentenceFamily<Said> *const> families)
{
    CodesByKey<Said> codes;
    for (const SentenceCode<Said> &code : codesOf(families))
        codes.insert(QString::fromLatin1(code.row().key), code);
    return codes;
}

template <typename Said>
std::optional<SentenceCode<Said>> codeOfKey(const CodesByKey<Said> &codes, const QString &key)
{
    const auto found = codes.find(key);
    return found == codes.end() ? std::nullopt : std::optional(found.value());
}

std::optional<MessageCode> messageCode(const QString &key)
{
    static const CodesByKey<Message> codes = codesByKey(messageFamilies());
    return codeOfKey<Message>(codes, key);
}

std::optional<RefusalCode> refusalCode(const QString &key)
{
    static const CodesByKey<Refusal> codes = codesByKey(refusalFamilies());
    return codeOfKey<Refusal>(codes, key);
}

QJsonObject parsed(const QString &json)
{
    return QJsonDocument::fromJson(json.toUtf8()).object();
}

std::vector<RefusalArgument> parsedArguments(const QString &json)
{
    return argumentsFromJson(QJsonDocument::fromJson(json.toUtf8()).array());
}

QString refusalJson(const Refusal &refusal)
{
    QString kind;
    for (const auto &[id, key] : refusalKinds)
        if (id == refusal.kind)
            kind = QString::fromLatin1(key);
    return jsonLine(QJsonObject{{kindKey, kind},
                                {codeKey, refusalKey(refusal.id)},
                                {argumentsKey, argumentsToJson(refusal.arguments)}});
}

std::optional<Refusal> refusalOf(const QJsonObject &json)
{
    const auto id = refusalCode(json.value(codeKey).toString());
    if (!id)
        return std::nullopt;
    Refusal refusal{.id = *id, .arguments = argumentsFromJson(json.value(argumentsKey).toArray())};
    for (const auto &[kind, key] : refusalKinds)
        if (json.value(kindKey).toString() == QLatin1String(key))
            refusal.kind = kind;
    return refusal;
}

QString unknownText(const QString &code, const std::vector<RefusalArgument> &arguments)
{
    const QString all = argumentTexts(arguments).join(QStringLiteral(", "));
    return all.isEmpty() ? Journal::tr("Message \"%1\" of another version of Codewheel.").arg(code)
                         : Journal::tr("Message \"%1\" of another version of Codewheel: %2").arg(code, all);
}

} // namespace

StoredMessage storedMessage(const Message &message, const QDateTime &at)
{
    return {.at = at.toMSecsSinceEpoch(),
            .severity = message.severity,
            .place = message.place,
            .code = messageKey(message.id),
            .arguments = jsonLine(argumentsToJson(message.arguments)),
            .refusal = message.refusal ? refusalJson(*message.refusal) : QString()};
}

std::optional<Message> messageOf(const StoredMessage &stored)
{
    const auto id = messageCode(stored.code);
    if (!id)
        return std::nullopt;
    Message message{.place = stored.place,
                    .severity = stored.severity,
                    .id = *id,
                    .arguments = parsedArguments(stored.arguments)};
    if (stored.refusal.isEmpty())
        return message;
    message.refusal = refusalOf(parsed(stored.refusal));
    return message.refusal ? std::optional(message) : std::nullopt;
}

QString messageText(const StoredMessage &stored)
{
    if (const auto message = messageOf(stored))
        return messageText(*message);
    if (stored.refusal.isEmpty())
        return unknownText(stored.code, parsedArguments(stored.arguments));
    return unknownText(codeOf(stored),
                       argumentsFromJson(parsed(stored.refusal).value(argumentsKey).toArray()));
}

QString codeOf(const StoredMessage &stored)
{
    const QString refused =
        stored.refusal.isEmpty() ? QString() : parsed(stored.refusal).value(codeKey).toString();
    return refused.isEmpty() ? stored.code : refused;
}

} // namespace codewheel
