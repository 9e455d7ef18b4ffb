// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_slcan_adapter.h"

namespace codewheel {
namespace {

const QByteArray endOfAnswer = "\r";
const QByteArray bellOfAdapter = "\a";

// Of the answer to F.
enum AdapterStatus : std::uint8_t {
    receiveQueueIsFull = 0x01,
    transmitQueueIsFull = 0x02,
    isAtWarning = 0x04,
    hasOverrun = 0x08,
    isErrorPassive = 0x20,
    hasBusError = 0x80,
};

std::uint8_t statusBitsOf(CanState state)
{
    switch (state) {
    case CanState::busOff:
    case CanState::passive:
        return isAtWarning | isErrorPassive;
    case CanState::warning:
        return isAtWarning;
    case CanState::active:
    case CanState::notKnown:
        break;
    }
    return 0;
}

QByteArray stampOf(Instant time)
{
    constexpr qsizetype digits = 4;
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(time).count() % slcanStampRange;
    return QByteArray::number(qlonglong{milliseconds}, 16).rightJustified(digits, '0').toUpper();
}

} // namespace

SimulatedSlcanAdapter::SimulatedSlcanAdapter(std::shared_ptr<SimulatedCanBus> bus)
    : m_bus(std::move(bus))
{}

void SimulatedSlcanAdapter::advance(Instant now)
{
    m_now = now;
    m_bus->advance(now);
    if (!m_link)
        return;
    if (const auto news = m_link->receive(m_link->now()))
        for (const CanFrame &frame : news->frames)
            deliver(frame);
}

void SimulatedSlcanAdapter::deliver(const CanFrame &frame)
{
    constexpr std::uint32_t busError = 0x80; // linux/can/error.h
    if (frame.isError) {
        if ((frame.id & busError) != 0)
            m_status |= hasBusError;
        return;
    }
    if (m_out.size() > mostUnfetched) {
        m_status |= receiveQueueIsFull | hasOverrun;
        return;
    }
    QByteArray line = slcanCommand(frame);
    if (m_hasStamps)
        line.insert(line.size() - endOfAnswer.size(), stampOf(m_openedAt + frame.time.value_or(Instant())));
    m_out += line;
}

void SimulatedSlcanAdapter::take(const QByteArray &bytes, Instant now)
{
    advance(now);
    for (const SlcanItem &item : m_reader.read(bytes)) {
        if (m_out.size() > 2 * mostUnfetched) // nobody reads the answers
            return;
        if (!obey(item))
            m_out += bellOfAdapter;
    }
}

void SimulatedSlcanAdapter::restart()
{
    close();
    m_rate = 0;
    m_hasStamps = false;
    m_status = 0;
    m_reader = {};
    m_out.clear();
}

bool SimulatedSlcanAdapter::obey(const SlcanItem &item)
{
    switch (item.kind) {
    case SlcanItem::Kind::frame:
        return send(item);
    case SlcanItem::Kind::done:
        return tell({});
    case SlcanItem::Kind::text:
        return command(item.text);
    case SlcanItem::Kind::sent:
    case SlcanItem::Kind::refused:
        break;
    }
    return false;
}

bool SimulatedSlcanAdapter::command(const QByteArray &text)
{
    const QByteArray rest = text.sliced(1);
    switch (text.front()) {
    case 'S':
        return rest.size() == 1 && setRate(rest.front());
    case 'O':
        return rest.isEmpty() && open(CanUse::operate);
    case 'L':
        return rest.isEmpty() && open(CanUse::watch);
    case 'C':
        return rest.isEmpty() && close() && tell({});
    case 'F':
        return rest.isEmpty() && tellStatus();
    case 'V':
        return rest.isEmpty() && tell("V1013");
    case 'N':
        return rest.isEmpty() && tell("NCW01");
    case 'Z':
        return setStamps(rest);
    default:
        return false;
    }
}

bool SimulatedSlcanAdapter::setRate(char digit)
{
    const auto which = static_cast<std::size_t>(static_cast<unsigned char>(digit)) - '0';
    if (m_link || which >= slcanRates.size())
        return false;
    m_rate = slcanRates.at(which);
    return tell({});
}

bool SimulatedSlcanAdapter::open(CanUse use)
{
    if (m_link || m_rate == 0)
        return false;
    m_openedAt = m_bus->now();
    m_link = std::make_unique<SimulatedCanLink>(m_bus, m_rate, [this] { return m_now; });
    m_status = 0;
    return m_link->open(use) && tell({});
}

bool SimulatedSlcanAdapter::close()
{
    const bool wasOpen = m_link != nullptr;
    m_link.reset();
    return wasOpen;
}

// Answered once it waits in the adapter, not when it is on the bus.
bool SimulatedSlcanAdapter::send(const SlcanItem &item)
{
    if (!m_link || item.stamp || m_link->status().listensOnly.value_or(true) ||
        m_link->status().state == CanState::busOff)
        return false;
    if (!m_link->send(item.frame).value_or(false)) {
        m_status |= transmitQueueIsFull;
        return false;
    }
    return tell(item.frame.isExtended ? "Z" : "z");
}

bool SimulatedSlcanAdapter::setStamps(const QByteArray &digit)
{
    if (m_link || (digit != "0" && digit != "1"))
        return false;
    m_hasStamps = digit == "1";
    return tell({});
}

bool SimulatedSlcanAdapter::tellStatus()
{
    if (!m_link)
        return false;
    const unsigned bits = std::exchange(m_status, std::uint8_t{0}) | statusBitsOf(m_link->status().state);
    return tell('F' + QByteArray::number(bits, 16).rightJustified(2, '0').toUpper());
}

bool SimulatedSlcanAdapter::tell(const QByteArray &text)
{
    m_out += text + endOfAnswer;
    return true;
}

} // namespace codewheel
