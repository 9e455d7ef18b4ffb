// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever comes as answers, at whatever time: a transfer ends, a write begins once, and only an answer of
// its object gives an outcome. What the client sends can be read.
//
// The first byte chooses the transfer: bit 7 it is written, with as many bytes as the others say; else it is
// read. Then follow frames: a byte with the delay after the one before in 4 ms, and bit 7 for the frame
// before once more; eight bytes of data, whose object is that of the transfer if they name 0000h:0.
#include "kinds/canopen/protocol/canopen_explain.h"
#include "kinds/canopen/protocol/frames.h"
#include "kinds/canopen/protocol/sdo_client.h"
#include "tests/fuzz/must.h"

using namespace codewheel;
using namespace codewheel::canopen;

namespace {

constexpr SdoObject object{0x1008, 0};
constexpr SdoIdentifiers identifiers{.request = 0x605, .answer = 0x585};
constexpr std::size_t frameSize = 8;

class Dialogue
{
public:
    explicit Dialogue(std::optional<std::vector<std::uint8_t>> value)
        : m_isWrite(value.has_value())
    {
        m_client.begin({.node = 5, .object = object, .value = std::move(value)}, m_now);
    }

    void comes(Octets data, Instant delay)
    {
        passUntil(m_now + delay);
        CanFrame frame = frameOf(identifiers.answer, data);
        if (numberOf(data.subspan(1, 3)) == 0) {
            frame.bytes[1] = object.index & 0xFF;
            frame.bytes[2] = object.index >> 8;
        }
        m_answers += data.size();
        must(m_client.take(frame, m_now), "it is an answer");
        look();
    }

    void end()
    {
        passUntil(m_now + std::chrono::hours(1));
        must(!m_client.isBusy() && m_outcomes == 1, "it ends");
        must(!m_client.wakesAt(), "nothing is left");
    }

private:
    void passUntil(Instant until)
    {
        for (int step = 0;; ++step) {
            must(step < 1'000, "it goes on");
            while (const auto frame = m_client.next(m_now))
                sent(*frame);
            look();
            const auto wakes = m_client.wakesAt();
            if (!wakes || *wakes >= until)
                break;
            must(*wakes > m_now, "it waits for something to come");
            m_now = *wakes;
        }
        m_now = until;
    }

    void sent(const CanFrame &frame)
    {
        must(frame.id == identifiers.request, "to the node");
        const auto request = SdoFrame::request(frame.data());
        must(request && !sdoText(*request).isEmpty(), "it can be read");
        must(request->kind != SdoFrame::Kind::unknown, "it is a request");
        const bool isWrite =
            request->kind == SdoFrame::Kind::write || request->kind == SdoFrame::Kind::writeBegins;
        m_begun += isWrite || request->kind == SdoFrame::Kind::read ? 1 : 0;
        must(isWrite ? m_isWrite : true, "a read writes nothing");
        must(m_begun <= (m_isWrite ? 1 : 3), "not too often");
    }

    void look()
    {
        const auto outcome = m_client.takeOutcome();
        if (!outcome)
            return;
        ++m_outcomes;
        using Kind = SdoOutcome::Kind;
        must(outcome->kind != Kind::notSent, "all was sent");
        must(outcome->kind != Kind::read || !m_isWrite, "a write reads nothing");
        must(outcome->kind != Kind::written || m_isWrite, "a read writes nothing");
        must(outcome->kind == Kind::noAnswer || m_answers > 0, "without an answer there is none");
        must(outcome->value.size() <= m_answers, "no more than came");
    }

    SdoClient m_client{identifiers};
    bool m_isWrite;
    Instant m_now{};
    std::size_t m_answers = 0; // bytes
    int m_begun = 0;
    int m_outcomes = 0;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    constexpr std::uint8_t choiceBit = 0x80;
    constexpr std::uint8_t otherBits = 0x7F;
    if (size == 0)
        return 0;
    Octets rest(data, size);
    const std::size_t bytes = rest[0] & otherBits;
    const bool isWrite = (rest[0] & choiceBit) != 0;
    Dialogue dialogue(isWrite ? std::optional(std::vector<std::uint8_t>(bytes, 'W')) : std::nullopt);
    for (rest = rest.subspan(1); rest.size() > frameSize; rest = rest.subspan(1 + frameSize)) {
        const Octets frame = rest.subspan(1, frameSize);
        dialogue.comes(frame, std::chrono::milliseconds(4) * (rest[0] & otherBits));
        if ((rest[0] & choiceBit) != 0)
            dialogue.comes(frame, {});
    }
    dialogue.end();
    return 0;
}
