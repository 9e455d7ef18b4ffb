// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/ini_text.h"

#include <QStringDecoder>

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr std::string_view iniBlanks{" \t\v\f\0", 5};

char lowered(char letter)
{
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool isWholeUtf8(const QByteArray &bytes)
{
    QStringDecoder decoder(QStringDecoder::Utf8);
    [[maybe_unused]] const QString text = decoder(bytes);
    return !decoder.hasError();
}

std::int64_t lineAt(const QByteArray &bytes, qsizetype place)
{
    const QByteArrayView before = QByteArrayView(bytes).first(place);
    const auto count = before.count('\n');
    return 1 + (count > 0 ? count : before.count('\r'));
}

std::int64_t firstLineBeyondAscii(const QByteArray &bytes)
{
    const auto found = std::ranges::find_if(bytes, [](char letter) { return (letter & 0x80) != 0; });
    return lineAt(bytes, found - bytes.begin());
}

QByteArray asUtf8(const QByteArray &bytes, EdsNotes &notes)
{
    const auto marked = QStringConverter::encodingForData(bytes);
    if (marked && *marked != QStringConverter::Utf8) {
        QStringDecoder decoder(*marked);
        return QString(decoder(bytes)).toUtf8();
    }
    if (!isWholeUtf8(bytes)) {
        notes.add({firstLineBeyondAscii(bytes), {}, EdsFault::notUtf8});
        return QString::fromLatin1(bytes).toUtf8();
    }
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    constexpr std::string_view lostLetter = "\xEF\xBF\xBD"; // U+FFFD
    if (const qsizetype lost = bytes.indexOf(lostLetter.data()); lost >= 0)
        notes.add({lineAt(bytes, lost), {}, EdsFault::lettersLost});
    return bytes.startsWith(mark.data()) ? bytes.sliced(static_cast<qsizetype>(mark.size())) : bytes;
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(iniBlanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(iniBlanks) - first + 1);
}

bool isSameKey(std::string_view one, std::string_view other)
{
    return std::ranges::equal(one, other, {}, lowered, lowered);
}

QString textOf(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

const IniEntry *IniSection::find(std::string_view key) const
{
    const auto found =
        std::ranges::find_if(entries, [key](const IniEntry &entry) { return isSameKey(entry.key, key); });
    return found == entries.end() ? nullptr : &*found;
}

IniText::IniText(const QByteArray &bytes, EdsNotes &notes)
    : m_text(asUtf8(bytes, notes))
{
    std::string_view rest(m_text.constData(), static_cast<std::size_t>(m_text.size()));
    for (std::int64_t number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
        readLine(trimmed(rest.substr(0, end)), number, notes);
        const bool isPair = rest.substr(end, 2) == "\r\n";
        rest.remove_prefix(std::min(end + (isPair ? 2 : 1), rest.size()));
    }
}

void IniText::readLine(std::string_view line, std::int64_t number, EdsNotes &notes)
{
    if (line.empty() || line.front() == ';' || line.front() == '#')
        return;
    if (line.front() == '[')
        return readSection(line, number, notes);
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos)
        return notes.add({number, textOf(line), EdsFault::noEqualSign});
    const std::string_view key = trimmed(line.substr(0, equals));
    if (m_sections.empty())
        return notes.add({number, textOf(key), EdsFault::beforeSections});
    m_sections.back().entries.push_back({key, trimmed(line.substr(equals + 1)), number});
}

void IniText::readSection(std::string_view line, std::int64_t number, EdsNotes &notes)
{
    const std::size_t end = line.find(']');
    const QString written = textOf(trimmed(line.substr(1, end == std::string_view::npos ? end : end - 1)));
    if (end == std::string_view::npos) {
        notes.add({number, written, EdsFault::bracketOpen});
    } else if (const auto rest = trimmed(line.substr(end + 1));
               !rest.empty() && rest.front() != ';' && rest.front() != '#') {
        notes.add({number, written, EdsFault::behindBracket});
    }
    std::string name;
    for (const char letter : line.substr(1, end == std::string_view::npos ? end : end - 1))
        if (iniBlanks.find(letter) == std::string_view::npos)
            name += lowered(letter);
    m_sections.push_back({name, written, number});
}

} // namespace codewheel::canopen
