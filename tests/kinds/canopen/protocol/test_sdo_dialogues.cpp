// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand dialogues over a bus that loses, delays and doubles frames and carries those of others.
#include "kinds/canopen/protocol/sdo_client.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

using Octet8 = std::array<std::uint8_t, 8>;

constexpr std::uint32_t requestIdentifier = 0x605;
constexpr std::uint32_t answerIdentifier = 0x585;
constexpr std::uint32_t answerOfAnother = 0x586;
constexpr Instant dialogueTimeOut = 500ms;

// An object dictionary and its server, which shares nothing with the client. Every value an object ever had
// is kept.
class SmallServer
{
public:
    struct Was
    {
        Instant from;
        ByteList value;
    };

    void put(int index, ByteList value, Instant now) { m_objects[index].push_back({now, std::move(value)}); }
    const std::vector<Was> &history(int index) const { return m_objects.at(index); }

    std::optional<Octet8> answer(const Octet8 &in, Instant now)
    {
        const int index = in[1] | in[2] << 8;
        switch (in[0] >> 5) {
        case 2:
            return readBegins(in, index);
        case 1:
            return writeBegins(in, index, now);
        case 3:
            return nextRead(in);
        case 0:
            return nextWritten(in, now);
        default:
            m_open = 0;
            return std::nullopt;
        }
    }

private:
    static Octet8 refuse(int index, std::uint8_t sub, std::uint32_t code)
    {
        Octet8 out{0x80, static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(index >> 8), sub};
        for (std::size_t at = 4; at < out.size(); ++at) {
            out[at] = static_cast<std::uint8_t>(code);
            code >>= 8;
        }
        return out;
    }

    Octet8 readBegins(const Octet8 &in, int index)
    {
        m_open = 0;
        if (!m_objects.contains(index))
            return refuse(index, in[3], 0x06020000);
        const ByteList value = m_objects[index].back().value;
        Octet8 out{0, in[1], in[2], in[3]};
        if (!value.empty() && value.size() <= 4) {
            out[0] = static_cast<std::uint8_t>(0x43 | (4 - value.size()) << 2);
            std::copy(value.begin(), value.end(), out.begin() + 4);
            return out;
        }
        open(index, false);
        m_data = value;
        out[0] = 0x41;
        out[4] = static_cast<std::uint8_t>(value.size());
        return out;
    }

    Octet8 writeBegins(const Octet8 &in, int index, Instant now)
    {
        m_open = 0;
        if (!m_objects.contains(index))
            return refuse(index, in[3], 0x06020000);
        if ((in[0] & 2) != 0)
            put(index, ByteList(in.begin() + 4, in.end() - (in[0] >> 2 & 3)), now);
        else
            open(index, true);
        return {0x60, in[1], in[2], in[3]};
    }

    Octet8 nextRead(const Octet8 &in)
    {
        if (m_open == 0 || m_isWrite)
            return refuse(0, 0, 0x05040001);
        if (((in[0] & 0x10) != 0) != m_toggle)
            return refuse(std::exchange(m_open, 0), 0, 0x05030000);
        const std::size_t size = std::min<std::size_t>(m_data.size() - m_at, 7);
        const bool isLast = m_at + size == m_data.size();
        Octet8 out{static_cast<std::uint8_t>((m_toggle ? 0x10 : 0) | (7 - size) << 1 | (isLast ? 1 : 0))};
        std::copy_n(m_data.begin() + static_cast<std::ptrdiff_t>(m_at), size, out.begin() + 1);
        m_at += size;
        m_toggle = !m_toggle;
        if (isLast)
            m_open = 0;
        return out;
    }

    Octet8 nextWritten(const Octet8 &in, Instant now)
    {
        if (m_open == 0 || !m_isWrite)
            return refuse(0, 0, 0x05040001);
        if (((in[0] & 0x10) != 0) != m_toggle)
            return refuse(std::exchange(m_open, 0), 0, 0x05030000);
        m_data.insert(m_data.end(), in.begin() + 1, in.end() - (in[0] >> 1 & 7));
        const Octet8 out{static_cast<std::uint8_t>(m_toggle ? 0x30 : 0x20)};
        m_toggle = !m_toggle;
        if ((in[0] & 1) != 0)
            put(std::exchange(m_open, 0), m_data, now);
        return out;
    }

    void open(int index, bool isWrite)
    {
        m_open = index;
        m_isWrite = isWrite;
        m_toggle = false;
        m_at = 0;
        m_data.clear();
    }

    std::map<int, std::vector<Was>> m_objects;
    int m_open = 0; // index of the transfer in segments; 0: none
    bool m_isWrite = false;
    bool m_toggle = false;
    std::size_t m_at = 0;
    ByteList m_data;
};

// Client and server with the bus between them, and its faults.
class FaultyBus
{
public:
    explicit FaultyBus(std::uint32_t seed)
        : m_random(seed)
    {
        server.put(position, {0, 0, 0, 0}, {});
        server.put(preset, {0, 0, 0, 0}, {});
        server.put(parameters, {0, 0}, {});
        server.put(name, text(20), {});
        server.put(domain, text(9), {});
    }

    static constexpr int position = 0x6004; // another one each time
    static constexpr int preset = 0x6003;
    static constexpr int parameters = 0x6000;
    static constexpr int name = 0x1008;
    static constexpr int domain = 0x2010;
    static constexpr int missing = 0x2FFF;

    SmallServer server;
    SdoClient client{SdoIdentifiers::predefined(5)};
    Instant now = 1s;
    int writesBegun = 0; // frames of the client in the dialogue
    int frames = 0;      // in all
    int faults = 0;

    int below(int limit) { return static_cast<int>(m_random() % static_cast<std::uint32_t>(limit)); }
    ByteList text(int size)
    {
        ByteList bytes(static_cast<std::size_t>(size));
        for (auto &each : bytes)
            each = static_cast<std::uint8_t>(below(256));
        return bytes;
    }

    SdoOutcome dialogue(const SdoRequest &request)
    {
        writesBegun = 0;
        client.begin(request, now);
        std::optional<SdoOutcome> outcome;
        while (!outcome || client.isBusy()) {
            send();
            if (const auto ready = client.takeOutcome())
                outcome = ready;
            else
                pass();
        }
        const Instant next = now + 1ms + Instant(below(3000));
        while (!m_underWay.empty() && m_underWay.begin()->first <= next)
            deliver();
        now = next;
        return *outcome;
    }

private:
    struct Frame
    {
        bool isRequest = false;
        std::uint32_t identifier = 0;
        Octet8 octets{};
    };

    void send()
    {
        while (const auto frame = client.next(now)) {
            EXPECT_EQ(frame->id, requestIdentifier);
            EXPECT_EQ(frame->length, 8);
            writesBegun += frame->bytes[0] >> 5 == 1 ? 1 : 0;
            put({true, frame->id, frame->bytes});
        }
    }

    void pass()
    {
        const auto wakes = client.wakesAt();
        if (!m_underWay.empty() && m_underWay.begin()->first <= wakes.value_or(Instant::max()))
            deliver();
        else
            now = std::max(now, wakes.value());
    }

    void deliver()
    {
        const auto [at, frame] = *m_underWay.begin();
        m_underWay.erase(m_underWay.begin());
        now = std::max(now, at);
        if (!frame.isRequest) {
            client.take({.id = frame.identifier, .length = 8, .bytes = frame.octets}, now);
            return;
        }
        server.put(position, text(4), now);
        if (const auto answer = server.answer(frame.octets, now))
            put({false, answerIdentifier, *answer});
    }

    // One of a hundred frames has a fault. What is sent after a late request is late as well; a late answer
    // is overtaken. There is one fault at a time.
    void put(const Frame &frame)
    {
        Instant at = std::max(now + 200us, frame.isRequest ? m_requestsFrom : Instant());
        ++frames;
        const int fault = now > m_faultUntil ? below(320) : 320;
        if (fault < 4) {
            ++faults;
            m_faultUntil = now + 1ms;
        }
        if (fault == 0)
            return;
        if (fault == 1) {
            at = now + 300ms + Instant(below(600'000));
            m_faultUntil = at + 1ms;
        }
        if (frame.isRequest)
            m_requestsFrom = at;
        m_underWay.emplace(at, frame);
        if (fault == 2)
            m_underWay.emplace(at + 130us, frame);
        if (fault == 3)
            m_underWay.emplace(now + 100us, ofAnother(frame));
    }

    // A node of another number, or the answer to another master.
    Frame ofAnother(const Frame &frame)
    {
        Frame other{false, below(2) == 0 ? answerOfAnother : answerIdentifier, frame.octets};
        other.octets[0] = 0x43;
        if (other.identifier == answerIdentifier) {
            other.octets[1] = 0x18;
            other.octets[2] = 0x10;
        }
        return other;
    }

    std::mt19937 m_random;
    std::multimap<Instant, Frame> m_underWay;
    Instant m_faultUntil{};
    Instant m_requestsFrom{};
};

bool hadValue(const SmallServer &server, int index, const ByteList &value, Instant from, Instant until)
{
    const auto &history = server.history(index);
    for (std::size_t at = history.size(); at-- > 0;) {
        if (history[at].from <= until && history[at].value == value)
            return true;
        if (history[at].from < from)
            return false;
    }
    return false;
}

struct Tally
{
    int read = 0;
    int written = 0;
    int aborted = 0;
    int noAnswer = 0;
};

void checkRead(FaultyBus &bus, int index, Tally &tally)
{
    const Instant from = bus.now;
    const SdoOutcome outcome =
        bus.dialogue({.node = 5, .object = {static_cast<std::uint16_t>(index)}, .timeOut = dialogueTimeOut});
    EXPECT_EQ(bus.writesBegun, 0);
    if (outcome.kind == SdoOutcome::Kind::read) {
        ++tally.read;
        EXPECT_TRUE(hadValue(bus.server, index, outcome.value, from, bus.now)) << std::hex << index;
    } else if (outcome.kind == SdoOutcome::Kind::aborted) {
        ++tally.aborted;
        EXPECT_TRUE((index == FaultyBus::missing && outcome.abortCode == 0x06020000) ||
                    (index == FaultyBus::name || index == FaultyBus::domain))
            << std::hex << index << ' ' << outcome.abortCode;
    } else {
        ++tally.noAnswer;
    }
}

void checkWrite(FaultyBus &bus, int index, Tally &tally)
{
    const ByteList value = bus.text(index == FaultyBus::domain ? 5 + bus.below(40) : 4);
    const SdoOutcome outcome = bus.dialogue({.node = 5,
                                             .object = {static_cast<std::uint16_t>(index)},
                                             .value = value,
                                             .timeOut = dialogueTimeOut});
    EXPECT_LE(bus.writesBegun, 1);
    if (outcome.kind == SdoOutcome::Kind::written) {
        ++tally.written;
        EXPECT_EQ(bus.server.history(index).back().value, value) << std::hex << index;
    } else if (outcome.kind == SdoOutcome::Kind::aborted) {
        ++tally.aborted;
        EXPECT_EQ(index, FaultyBus::domain) << outcome.abortCode;
    } else {
        ++tally.noAnswer;
    }
}

void tenThousandDialogues(std::uint32_t seed)
{
    FaultyBus bus(seed);
    Tally tally;
    std::size_t choice = 0;
    for (int dialogue = 0; dialogue < 10'000; ++dialogue) {
        constexpr std::array readable{FaultyBus::position,   FaultyBus::position, FaultyBus::preset,
                                      FaultyBus::parameters, FaultyBus::name,     FaultyBus::domain,
                                      FaultyBus::missing};
        if (bus.below(2) == 0) // often the same one again
            choice = static_cast<std::size_t>(bus.below(10));
        if (choice < readable.size())
            checkRead(bus, readable[choice], tally);
        else
            checkWrite(bus, choice == 9 ? FaultyBus::domain : FaultyBus::preset, tally);
        if (::testing::Test::HasFailure())
            FAIL() << "seed " << seed << ", dialogue " << dialogue;
    }
    EXPECT_GT(bus.faults * 100, bus.frames);
    EXPECT_GT(bus.client.lateAnswers(), 20);
    EXPECT_GT(bus.client.foreignAnswers(), 20);
    EXPECT_GT(tally.read, 5'000);
    EXPECT_GT(tally.written, 2'500);
    EXPECT_GT(tally.noAnswer, 10);
    EXPECT_LT(tally.noAnswer, 150);
    EXPECT_LT(tally.aborted, 1'300);
}

TEST(SdoDialogues, TenThousandOnAFaultyBusGiveNoWrongValueAndNoSecondWrite)
{
    for (const std::uint32_t seed : {1U, 39U, 406U})
        tenThousandDialogues(seed);
}

} // namespace
} // namespace codewheel::canopen
