// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_reception.h"

#include <algorithm>

namespace codewheel::esc {
namespace {

using RowKind = EscLineRow::Kind;

// A clock read after the bytes came in gives a rather late time; one derived from the baud rate alone may be
// a little off.
constexpr int toleratedCharacters = 2;

} // namespace

Reception::Reception(const Request &request, Clock clock)
    : m_echo(request.bytes())
    , m_shape(&shapeOf(request.command))
    , m_clock(clock)
{}

void Reception::add(const QByteArray &bytes, Instant at)
{
    const qsizetype size = bytes.size();
    for (qsizetype i = 0; i < size; ++i) {
        const Instant time = at - m_clock.character * (size - 1 - i);
        m_times.push_back(m_times.empty() ? time : std::max(time, m_times.back()));
    }
    m_bytes += bytes;
}

std::vector<qsizetype> Reception::echoes() const
{
    std::vector<qsizetype> found;
    for (qsizetype i = m_bytes.indexOf(m_echo); i >= 0; i = m_bytes.indexOf(m_echo, i + m_echo.size()))
        found.push_back(i);
    return found;
}

qsizetype Reception::echoEnd() const
{
    const qsizetype last = m_bytes.lastIndexOf(m_echo);
    return last < 0 ? 0 : last + m_echo.size();
}

bool Reception::hasMoreThanEcho() const
{
    return m_bytes.size() > static_cast<qsizetype>(echoes().size()) * m_echo.size();
}

Instant Reception::earliestEnd(const Frame &frame) const
{
    return m_clock.requestEnd + m_clock.character * frame.size();
}

bool Reception::isTooEarly(const Frame &frame) const
{
    return endOf(frame) + m_clock.character * toleratedCharacters < earliestEnd(frame);
}

Instant Reception::settlesAt(const Frame &frame) const
{
    return std::max(lastHeard(), earliestEnd(frame)) + m_clock.character * silentCharacters;
}

// Bytes before the echo were there before the request was.
std::vector<Frame> Reception::frames() const
{
    const qsizetype from = echoEnd();
    std::vector<Frame> frames = valuesIn(QByteArrayView(m_bytes).sliced(from), *m_shape);
    for (Frame &frame : frames) {
        frame.begin += from;
        frame.end += from;
    }
    return frames;
}

// An answer that ended before a device could have sent it belongs to an earlier request, unless it is the
// only one: a peer that is not a real device need not keep to the line's timing.
std::optional<Frame> Reception::chosen() const
{
    std::vector<Frame> candidates = frames();
    const auto tooEarly = [this](const Frame &frame) { return isTooEarly(frame); };
    if (!std::ranges::all_of(candidates, tooEarly))
        std::erase_if(candidates, tooEarly);
    const auto differs = [&](const Frame &frame) { return frame.answer != candidates.front().answer; };
    if (candidates.empty() || std::ranges::any_of(candidates, differs))
        return std::nullopt;
    return candidates.front();
}

std::optional<Reception::Found> Reception::answer() const
{
    const qsizetype from = echoEnd();
    if (auto wordless = wordlessAnswer(QByteArrayView(m_bytes).sliced(from), *m_shape)) {
        const Frame frame{from, m_bytes.size(), std::move(*wordless)};
        return Found{frame, endOf(frame), settlesAt(frame), false};
    }
    const auto frame = chosen();
    if (!frame)
        return std::nullopt;
    return Found{*frame, endOf(*frame), settlesAt(*frame), !isTooEarly(*frame)};
}

std::vector<EscLineRow> Reception::rows(const std::optional<Found> &taken) const
{
    std::vector<RowKind> kinds(m_times.size(), RowKind::garbage);
    const auto mark = [&](qsizetype begin, qsizetype size, RowKind kind) {
        std::fill_n(kinds.begin() + begin, size, kind);
    };
    for (const qsizetype echo : echoes())
        mark(echo, m_echo.size(), RowKind::echo);
    if (taken) {
        for (const Frame &frame : frames())
            if (isTooEarly(frame))
                mark(frame.begin, frame.size(), RowKind::late);
        mark(taken->frame.begin, taken->frame.size(), RowKind::answer);
    }
    std::vector<EscLineRow> rows;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (i == 0 || kinds[i] != kinds[i - 1])
            rows.push_back({{}, kinds[i], {}});
        rows.back().bytes += m_bytes[static_cast<qsizetype>(i)];
        rows.back().at = m_times[i];
    }
    return rows;
}

} // namespace codewheel::esc
