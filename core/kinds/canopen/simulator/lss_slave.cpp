// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/lss_slave.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/lss.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr std::uint8_t noNode = 0xFF;
constexpr std::uint8_t lssDone = 0;
constexpr std::uint8_t lssRefused = 1; // out of range, or not supported

// The standard table of rates, in Bd; 0: there is none.
constexpr std::array rateAtPlace{1'000'000, 800'000, 500'000, 250'000, 125'000, 0, 50'000, 20'000, 10'000};

LssSlave::Frame lssAnswer(LssCommand command, std::uint32_t number = 0)
{
    LssSlave::Frame frame{static_cast<std::uint8_t>(command)};
    for (std::size_t i = 0; i < 4; ++i)
        frame[1 + i] = static_cast<std::uint8_t>(number >> 8 * i);
    return frame;
}

std::uint32_t fourOctets(const LssSlave::Frame &frame)
{
    return numberOf(Octets(frame).subspan(1, 4));
}

// Which of four commands in a row, one for each word of the identity.
std::size_t wordOf(const LssSlave::Frame &frame, LssCommand first)
{
    return frame[0] - static_cast<std::size_t>(first);
}

} // namespace

struct LssSlave::Row
{
    enum class When : std::uint8_t { waiting, configuring, always };

    LssCommand command;
    When when;
    Outcome (LssSlave::*act)(const Frame &);
};

constinit const std::array<LssSlave::Row, 16> LssSlave::rows{{
    {LssCommand::switchAll, Row::When::always, &LssSlave::switchAll},
    {LssCommand::selectVendor, Row::When::waiting, &LssSlave::select},
    {LssCommand::selectProduct, Row::When::waiting, &LssSlave::select},
    {LssCommand::selectRevision, Row::When::waiting, &LssSlave::select},
    {LssCommand::selectSerial, Row::When::waiting, &LssSlave::select},
    {LssCommand::configureNode, Row::When::configuring, &LssSlave::setNumber},
    {LssCommand::configureRate, Row::When::configuring, &LssSlave::setRate},
    {LssCommand::activateRate, Row::When::configuring, &LssSlave::activate},
    {LssCommand::store, Row::When::configuring, &LssSlave::store},
    {LssCommand::inquireVendor, Row::When::configuring, &LssSlave::inquireIdentity},
    {LssCommand::inquireProduct, Row::When::configuring, &LssSlave::inquireIdentity},
    {LssCommand::inquireRevision, Row::When::configuring, &LssSlave::inquireIdentity},
    {LssCommand::inquireSerial, Row::When::configuring, &LssSlave::inquireIdentity},
    {LssCommand::inquireNode, Row::When::configuring, &LssSlave::inquireNode},
    {LssCommand::identifyUnconfigured, Row::When::always, &LssSlave::identifyUnconfigured},
    {LssCommand::fastScan, Row::When::waiting, &LssSlave::fastScan},
}};

LssSlave::LssSlave(const Identity &identity, NodeSettings settings)
    : m_identity(identity)
    , m_settings(settings)
    , m_node(settings.node)
{}

void LssSlave::reset()
{
    m_isConfiguring = false;
    m_matched = 0;
    m_scanned = 0;
}

LssSlave::Outcome LssSlave::take(Octets data)
{
    Frame frame{};
    if (data.size() != frame.size())
        return {};
    std::ranges::copy(data, frame.begin());
    const auto row = std::ranges::find(rows, static_cast<LssCommand>(frame[0]), &Row::command);
    if (row == rows.end())
        return {};
    const auto now = m_isConfiguring ? Row::When::configuring : Row::When::waiting;
    return row->when == Row::When::always || row->when == now ? (this->*row->act)(frame) : Outcome{};
}

LssSlave::Outcome LssSlave::switchAll(const Frame &frame)
{
    const bool leaves = m_isConfiguring && frame[1] == 0;
    reset();
    m_isConfiguring = frame[1] == 1;
    return {.event = leaves ? Event::leaves : Event::none};
}

LssSlave::Outcome LssSlave::select(const Frame &frame)
{
    const std::size_t word = wordOf(frame, LssCommand::selectVendor);
    const bool fits = word == m_matched && fourOctets(frame) == m_identity[word];
    m_matched = fits ? word + 1 : 0;
    if (m_matched != m_identity.size())
        return {};
    m_matched = 0;
    m_isConfiguring = true;
    return {.answer = lssAnswer(LssCommand::selected)};
}

LssSlave::Outcome LssSlave::setNumber(const Frame &frame)
{
    const int number = frame[1];
    const bool isNode = number >= 1 && number <= lastNode;
    if (!isNode && number != noNode)
        return {.answer = lssAnswer(LssCommand::configureNode, lssRefused)};
    m_settings.node = isNode ? std::optional(number) : std::nullopt;
    return {.answer = lssAnswer(LssCommand::configureNode, lssDone)};
}

LssSlave::Outcome LssSlave::setRate(const Frame &frame)
{
    const std::size_t place = frame[2];
    if (frame[1] != 0 || place >= rateAtPlace.size() || rateAtPlace[place] == 0)
        return {.answer = lssAnswer(LssCommand::configureRate, lssRefused)};
    m_settings.rate = rateAtPlace[place];
    return {.answer = lssAnswer(LssCommand::configureRate, lssDone)};
}

LssSlave::Outcome LssSlave::activate(const Frame &frame)
{
    m_delay = static_cast<int>(numberOf(Octets(frame).subspan(1, 2)));
    return {.event = Event::activateRate};
}

LssSlave::Outcome LssSlave::store(const Frame & /*frame*/)
{
    return {.answer = lssAnswer(LssCommand::store, lssDone), .event = Event::store};
}

LssSlave::Outcome LssSlave::inquireIdentity(const Frame &frame)
{
    const std::size_t word = wordOf(frame, LssCommand::inquireVendor);
    return {.answer = lssAnswer(static_cast<LssCommand>(frame[0]), m_identity[word])};
}

LssSlave::Outcome LssSlave::inquireNode(const Frame & /*frame*/)
{
    return {.answer =
                lssAnswer(LssCommand::inquireNode, static_cast<std::uint32_t>(m_node.value_or(noNode)))};
}

LssSlave::Outcome LssSlave::identifyUnconfigured(const Frame & /*frame*/)
{
    return m_node ? Outcome{} : Outcome{.answer = lssAnswer(LssCommand::identifiedUnconfigured)};
}

// A word is found from its highest bit down; the one that is asked for with the word before it as the next
// one, which is the last, has been found.
LssSlave::Outcome LssSlave::fastScan(const Frame &frame)
{
    constexpr std::uint8_t whoIsThere = 0x80;
    constexpr std::uint8_t highestBit = 31;
    const std::uint8_t bit = frame[5];
    const std::size_t word = frame[6];
    const std::size_t next = frame[7];
    const Outcome yes{.answer = lssAnswer(LssCommand::identified)};
    if (m_node)
        return {};
    if (bit == whoIsThere) {
        m_scanned = 0;
        return yes;
    }
    if (bit > highestBit || word >= m_identity.size() || next >= m_identity.size() || word != m_scanned)
        return {};
    if ((fourOctets(frame) ^ m_identity[word]) >> bit != 0)
        return {};
    if (bit == 0) {
        m_scanned = next;
        m_isConfiguring = next < word;
    }
    return yes;
}

} // namespace codewheel::canopen
