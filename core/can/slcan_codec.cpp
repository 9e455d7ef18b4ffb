// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/slcan_codec.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype longestSlcanLine = 200; // of any text; a frame has at most 31 characters
constexpr char bellOfRefusal = '\a';
constexpr qsizetype stampDigits = 4;

bool isSlcanHex(char character)
{
    return (character >= '0' && character <= '9') || (character >= 'A' && character <= 'F') ||
           (character >= 'a' && character <= 'f');
}

bool isPrintableAscii(char character)
{
    return character >= ' ' && character <= '~';
}

// All of them are hexadecimal digits.
std::uint32_t hexAt(const QByteArray &line, qsizetype at, qsizetype digits)
{
    std::uint32_t number = 0;
    for (const char digit : QByteArrayView(line).sliced(at, digits))
        number = number << 4 | static_cast<std::uint32_t>((digit & 0xF) + (digit > '9' ? 9 : 0));
    return number;
}

// "t1232AABB", "T0000012300", "r1232", with four digits of time behind it or not.
std::optional<SlcanItem> slcanFrameOf(const QByteArray &line)
{
    constexpr qsizetype standardDigits = 3;
    constexpr qsizetype extendedDigits = 8;
    const char letter = line.isEmpty() ? '\0' : line.front();
    const bool isExtended = letter == 'T' || letter == 'R';
    const bool isRemote = letter == 'r' || letter == 'R';
    const qsizetype lengthAt = 1 + (isExtended ? extendedDigits : standardDigits);
    if ((!isExtended && !isRemote && letter != 't') || line.size() <= lengthAt ||
        !std::all_of(line.begin() + 1, line.end(), isSlcanHex))
        return std::nullopt;
    SlcanItem item{.kind = SlcanItem::Kind::frame};
    CanFrame &frame = item.frame;
    frame.id = hexAt(line, 1, lengthAt - 1);
    frame.isExtended = isExtended;
    frame.isRemote = isRemote;
    frame.length = static_cast<std::uint8_t>(hexAt(line, lengthAt, 1));
    if (frame.id > (isExtended ? largestExtendedId : largestStandardId) || frame.length > CanFrame::mostBytes)
        return std::nullopt;
    const qsizetype dataAt = lengthAt + 1;
    const qsizetype end = dataAt + 2 * std::ssize(frame.data());
    if (line.size() != end && line.size() != end + stampDigits)
        return std::nullopt;
    for (std::size_t i = 0; i < frame.data().size(); ++i)
        frame.bytes.at(i) = static_cast<std::uint8_t>(hexAt(line, dataAt + 2 * static_cast<qsizetype>(i), 2));
    if (line.size() > end)
        if (const auto stamp = static_cast<int>(hexAt(line, end, stampDigits)); stamp < slcanStampRange)
            item.stamp = stamp;
    return item;
}

} // namespace

std::vector<SlcanItem> SlcanReader::read(const QByteArray &bytes)
{
    std::vector<SlcanItem> items;
    for (const char byte : bytes) {
        const bool isSecondOfTwo = byte == '\n' && m_wasCarriageReturn;
        m_wasCarriageReturn = byte == '\r';
        if (byte == bellOfRefusal) { // it has no end of line, and nothing before it was completed
            m_skipped += static_cast<std::uint64_t>(m_line.size());
            m_line.clear();
            m_isTooLong = false;
            items.push_back({.kind = SlcanItem::Kind::refused});
        } else if (byte == '\r' || byte == '\n') {
            if (!isSecondOfTwo)
                endLine(items);
        } else if (m_isTooLong || m_line.size() == longestSlcanLine) {
            m_skipped += 1 + static_cast<std::uint64_t>(m_line.size());
            m_line.clear();
            m_isTooLong = true;
        } else {
            m_line += byte;
        }
    }
    return items;
}

void SlcanReader::endLine(std::vector<SlcanItem> &items)
{
    if (!std::exchange(m_isTooLong, false))
        takeLine(items);
    m_line.resize(0); // keeps its memory
}

void SlcanReader::takeLine(std::vector<SlcanItem> &items)
{
    if (m_line.isEmpty())
        items.push_back({.kind = SlcanItem::Kind::done});
    else if (m_line == "z" || m_line == "Z")
        items.push_back({.kind = SlcanItem::Kind::sent});
    else if (auto frame = slcanFrameOf(m_line))
        items.push_back(*std::move(frame));
    else if (std::ranges::all_of(m_line, isPrintableAscii))
        items.push_back({.kind = SlcanItem::Kind::text, .text = m_line});
    else
        m_skipped += static_cast<std::uint64_t>(m_line.size());
}

QByteArray slcanCommand(const CanFrame &frame)
{
    const char letter = frame.isRemote ? 'r' : 't';
    QByteArray command(1, frame.isExtended ? static_cast<char>(letter - 'a' + 'A') : letter);
    command += QByteArray::number(frame.id, 16).rightJustified(frame.isExtended ? 8 : 3, '0');
    command += QByteArray::number(frame.length);
    const auto data = frame.data();
    command += QByteArray(reinterpret_cast<const char *>(data.data()), std::ssize(data)).toHex();
    return command.left(1) + command.mid(1).toUpper() + '\r';
}

QByteArray slcanRateCommand(int rate)
{
    const auto found = std::ranges::find(slcanRates, rate);
    return found == slcanRates.end() ? QByteArray()
                                     : 'S' + QByteArray::number(found - slcanRates.begin()) + '\r';
}

bool isLawicelVersion(const QByteArray &text)
{
    constexpr qsizetype size = 5;
    return text.size() == size && text.front() == 'V' &&
           std::all_of(text.begin() + 1, text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool hasWords(const QByteArray &text)
{
    constexpr int least = 3; // letters that are in no frame
    return std::ranges::count_if(text, [](char c) {
               const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
               return isLetter && !isSlcanHex(c) && !QByteArray("tTrRzZ").contains(c);
           }) >= least;
}

std::optional<std::uint8_t> slcanStatusBits(const QByteArray &text)
{
    constexpr qsizetype size = 3;
    const bool isStatus =
        text.size() == size && text.front() == 'F' && isSlcanHex(text[1]) && isSlcanHex(text[2]);
    return isStatus ? std::optional(static_cast<std::uint8_t>(hexAt(text, 1, 2))) : std::nullopt;
}

} // namespace codewheel
