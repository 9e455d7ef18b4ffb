// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/server_address.h"

#include "recording/server_texts.h"

#include <QRegularExpression>
#include <QUrl>

namespace codewheel {
namespace {

constexpr int highestPort = 65'535;
constexpr qsizetype longestHost = 253;
constexpr qsizetype longestName = 63; // bytes, of a database

// The parts of an address are not repeated in what is said of it: a password may be in any of them.
tl::unexpected<Refusal> wrongAddress(const QString &reason)
{
    return refuse(RefusalKind::badInput, RefusalId::serverAddressWrong, {reason});
}

tl::unexpected<Refusal> hasPassword()
{
    return refuse(RefusalKind::badInput, RefusalId::passwordInAddress);
}

QString percentDecoded(QStringView part)
{
    return QUrl::fromPercentEncoding(part.toUtf8());
}

QString percentEncoded(const QString &part)
{
    return QString::fromLatin1(QUrl::toPercentEncoding(part));
}

bool isName(const QString &text)
{
    static const QRegularExpression names(QStringLiteral("\\A[a-z0-9_]{1,63}\\z"));
    return names.match(text).hasMatch();
}

// Of a computer, as RFC 1123 has it, with letters of all languages and the underline that some use; an
// address; or the folder of a socket. None: the usual socket of this computer.
bool isHost(const QString &text)
{
    static const QRegularExpression labels(
        QStringLiteral("\\A[\\pL\\pN_](?:[\\pL\\pM\\pN_-]{0,61}[\\pL\\pM\\pN_])?"
                       "(?:\\.[\\pL\\pN_](?:[\\pL\\pM\\pN_-]{0,61}[\\pL\\pM\\pN_])?)*\\.?\\z"),
        QRegularExpression::UseUnicodePropertiesOption);
    const bool isNoName = text.isEmpty() || text.startsWith(u'/') || text.contains(u':');
    return isNoName || (text.size() <= longestHost && labels.match(text).hasMatch());
}

// They are put beside others that PostgreSQL's library gets, so they must not look like several.
bool isOption(const QString &text)
{
    static const QRegularExpression values(QStringLiteral("\\A[A-Za-z0-9_./+-]+\\z"));
    return values.match(text).hasMatch();
}

QStringView partAfter(QStringView text, QChar sign)
{
    const qsizetype at = text.indexOf(sign);
    return at < 0 ? QStringView() : text.sliced(at + 1);
}

QStringView partUntil(QStringView text, QChar sign)
{
    const qsizetype at = text.indexOf(sign);
    return at < 0 ? text : text.first(at);
}

Result<void> takeHost(ServerAddress &address, QStringView host)
{
    QStringView port;
    if (host.startsWith(u'[')) { // of IPv6
        port = partAfter(partAfter(host, u']'), u':');
        host = partUntil(host.sliced(1), u']');
    } else {
        port = partAfter(host, u':');
        host = partUntil(host, u':');
    }
    address.host = percentDecoded(host);
    if (!isHost(address.host))
        return wrongAddress(
            Server::tr("No computer can have this name: letters, digits and hyphens, with dots "
                       "between its parts."));
    address.port = port.toInt();
    if (!port.isEmpty() && (address.port < 1 || address.port > highestPort))
        return wrongAddress(Server::tr("The port is a number from 1 to 65535."));
    return {};
}

Result<void> takeOption(ServerAddress &address, const QString &name, const QString &value)
{
    static const QStringList known{QStringLiteral("sslmode"), QStringLiteral("sslrootcert"),
                                   QStringLiteral("connect_timeout")};
    if (name.contains(QStringLiteral("pass"), Qt::CaseInsensitive))
        return hasPassword();
    if (name == QStringLiteral("recording")) {
        if (!isName(value))
            return wrongAddress(
                Server::tr("The name of a recording has small letters, digits and underlines."));
        address.recording = value;
        return {};
    }
    if (!known.contains(name))
        return wrongAddress(
            Server::tr("Behind the question mark may stand sslmode, sslrootcert, connect_timeout and "
                       "recording, each with a value, and & between them."));
    if (!isOption(value))
        return wrongAddress(Server::tr("The value of %1 may have letters, digits and _ . / + -.").arg(name));
    address.options[name] = value;
    return {};
}

} // namespace

bool ServerAddress::isMeant(const QString &text)
{
    return text.startsWith(QStringLiteral("postgresql://")) || text.startsWith(QStringLiteral("postgres://"));
}

Result<ServerAddress> ServerAddress::parse(const QString &text)
{
    if (!isMeant(text))
        return wrongAddress(Server::tr("It begins with postgresql://."));
    const QStringView all = QStringView(text).sliced(text.indexOf(QStringLiteral("://")) + 3);
    const QStringView path = partUntil(all, u'?');
    QStringView host = partUntil(path, u'/');
    ServerAddress address;
    if (const qsizetype at = host.lastIndexOf(u'@'); at >= 0) {
        if (host.first(at).contains(u':'))
            return hasPassword();
        address.user = percentDecoded(host.first(at));
        host = host.sliced(at + 1);
    }
    if (auto taken = takeHost(address, host); !taken)
        return tl::unexpected(taken.error());
    address.database = percentDecoded(partAfter(path, u'/'));
    if (address.database.isEmpty())
        return wrongAddress(Server::tr("The name of the database is missing: postgresql://HOST/DATABASE."));
    if (address.database.toUtf8().size() > longestName)
        return wrongAddress(
            Server::tr("No database can have this name: it has more than %1 bytes.").arg(longestName));
    for (const QStringView option : partAfter(all, u'?').split(u'&', Qt::SkipEmptyParts))
        if (auto taken = takeOption(address, percentDecoded(partUntil(option, u'=')),
                                    percentDecoded(partAfter(option, u'=')));
            !taken)
            return tl::unexpected(taken.error());
    return address;
}

QString ServerAddress::place() const
{
    QString text = QStringLiteral("postgresql://");
    if (!user.isEmpty())
        text += percentEncoded(user) + u'@';
    text += host.contains(u':') ? u'[' + host + u']' : percentEncoded(host);
    if (port != 0)
        text += u':' + QString::number(port);
    return text + u'/' + percentEncoded(database);
}

QString ServerAddress::text() const
{
    QStringList parts;
    for (const auto &[name, value] : options)
        parts << name + u'=' + value;
    if (!recording.isEmpty())
        parts << QStringLiteral("recording=") + recording;
    return parts.isEmpty() ? place() : place() + u'?' + parts.join(u'&');
}

ServerAddress ServerAddress::withRecording(const QString &name) const
{
    ServerAddress address = *this;
    address.recording = name;
    return address;
}

} // namespace codewheel
