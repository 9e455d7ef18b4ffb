// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/typed_request.h"

#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_frame.h"
#include "kinds/esc/protocol/esc_scaling.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace codewheel {
namespace {

constexpr qsizetype addressDigits = 2;

// What was typed, in its parts, and the sentences for what is wrong with it.
class TypedParts
{
    Q_DECLARE_TR_FUNCTIONS(TypedRequest)

public:
    explicit TypedParts(const QString &text)
        : m_address(text.left(addressDigits))
        , m_letters(text.mid(addressDigits, text.mid(addressDigits, 1) == QLatin1String("G") ? 2 : 1))
        , m_data(text.mid(addressDigits + m_letters.size()))
    {}

    // For the first wrong part; empty: for none.
    QString fault() const;
    // Precondition: fault() is empty.
    QString valueFault(int fractionBits) const;

private:
    QString addressFault() const;
    QString commandFault() const;
    QString dataFault(const esc::CommandShape &shape) const;
    const esc::CommandShape &shape() const { return esc::shapeOf(*esc::commandOf(m_letters.toLatin1())); }

    QString m_address;
    QString m_letters;
    QString m_data;
};

QString TypedParts::fault() const
{
    if (QString wrong = addressFault(); !wrong.isEmpty())
        return wrong;
    if (QString wrong = commandFault(); !wrong.isEmpty())
        return wrong;
    return dataFault(shape());
}

QString TypedParts::addressFault() const
{
    if (m_address.isEmpty())
        return tr("Type a request: two hexadecimal digits for the address, then the command, as in 05P.");
    if (m_address.size() == addressDigits && EscLineAddress::fromWire(m_address))
        return {};
    return sentence(tr("\"%1\" is not an address. A request begins with two hexadecimal digits: 01 to 1F, or "
                       "00 for whichever encoder is alone on the line."),
                    {m_address});
}

QString TypedParts::commandFault() const
{
    if (m_letters.isEmpty())
        return sentence(tr("The command is missing behind the address %1, as in %1P."), {m_address});
    if (esc::commandOf(m_letters.toLatin1()))
        return {};
    QStringList known;
    for (const esc::CommandShape &shape : esc::allCommands())
        known << QString::fromLatin1(shape.letters.data(), static_cast<qsizetype>(shape.letters.size()));
    return sentence(tr("There is no command \"%1\". The commands are %2."),
                    {m_letters, known.join(QStringLiteral(", "))});
}

QString TypedParts::dataFault(const esc::CommandShape &shape) const
{
    const QString name = esc::commandName(shape.command);
    if (!shape.writes)
        return m_data.isEmpty() ? QString()
                                : sentence(tr("%1 reads (%2) and takes no data: \"%3\" is too much."),
                                           {m_letters, name, m_data});
    if (m_data.isEmpty())
        return sentence(tr("%1 writes (%2) and needs a value behind it, in hexadecimal digits."),
                        {m_letters, name});
    if (m_data.size() > shape.digits)
        return sentence(tr("%1 takes %2 hexadecimal digits at most; these are %3."),
                        {m_letters, QLocale().toString(shape.digits), QLocale().toString(m_data.size())});
    return parseHexDigits(m_data, shape.digits)
               ? QString()
               : sentence(tr("\"%1\" is not a hexadecimal number."), {m_data});
}

QString TypedParts::valueFault(int fractionBits) const
{
    const std::uint32_t value = m_data.toUInt(nullptr, 16);
    const esc::ValueRange range = esc::valueRange(shape().command, fractionBits);
    if (!shape().writes || range.holds(value))
        return {};
    return sentence(
        tr("%1 is outside of what %2 takes: %3 to %4. All numbers are hexadecimal."),
        {bothNotations(value), m_letters, bothNotations(range.smallest), bothNotations(range.largest)});
}

tl::expected<esc::Request, QString> requestOf(const QString &typed)
{
    if (const QString wrong = TypedParts(typed).fault(); !wrong.isEmpty())
        return tl::unexpected(wrong);
    if (const auto request = esc::parseRequest(typed.toLatin1()))
        return *request;
    return tl::unexpected(TypedParts(QString()).fault());
}

} // namespace

QString bothNotations(std::uint32_t value)
{
    return QStringLiteral("%1h = %2")
        .arg(QString::number(value, 16).toUpper(), QLocale().toString(qulonglong{value}));
}

tl::expected<esc::Request, QString> typedRequest(const QString &text, int fractionBits)
{
    const QString typed = text.trimmed().toUpper();
    auto request = requestOf(typed);
    if (!request)
        return request;
    if (const QString wrong = TypedParts(typed).valueFault(fractionBits); !wrong.isEmpty())
        return tl::unexpected(wrong);
    return request;
}

tl::expected<esc::Request, QString> readRequest(const QString &text)
{
    return requestOf(text.trimmed().toUpper());
}

std::optional<esc::Request> sentRequest(const QByteArray &bytes)
{
    constexpr qsizetype frame = 1 + esc::lineEndSize;
    if (bytes.size() <= frame)
        return {};
    const auto request = esc::parseRequest(QByteArrayView(bytes).sliced(1).chopped(esc::lineEndSize));
    return request && request->bytes() == bytes ? request : std::nullopt;
}

} // namespace codewheel
