// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/simulator/node_bench.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;

std::uint32_t hexOf(std::string_view digits)
{
    std::uint32_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
    return number;
}

CanFrame frameOf(const std::string &text)
{
    CanFrame frame{.id = hexOf(std::string_view(text).substr(0, 3))};
    if (text.ends_with("#R")) {
        frame.isRemote = true;
        return frame;
    }
    for (std::size_t at = 4; at + 1 < text.size(); at += 3)
        frame.bytes[frame.length++] = static_cast<std::uint8_t>(hexOf(std::string_view(text).substr(at, 2)));
    return frame;
}

std::string textOf(const CanFrame &frame)
{
    char digits[8];
    std::snprintf(digits, sizeof digits, "%03X#", frame.id);
    std::string text = digits;
    for (const std::uint8_t byte : frame.data()) {
        std::snprintf(digits, sizeof digits, "%02X ", byte);
        text += digits;
    }
    if (text.ends_with(' '))
        text.pop_back();
    return text;
}

// "6004:1" as "04 60 01"
std::string objectOctets(const std::string &object)
{
    const std::string sub = object.size() > 5 ? object.substr(5) : "0";
    return object.substr(2, 2) + ' ' + object.substr(0, 2) + (sub.size() == 1 ? " 0" : " ") + sub;
}

} // namespace

SimulatedNode &NodeBench::add(const CanopenEncoderPlan &plan)
{
    m_nodes.push_back(std::make_unique<SimulatedNode>(plan));
    pass(SimulatedNode::bootTime);
    return *m_nodes.back();
}

Frames NodeBench::pass(Instant time)
{
    Frames frames;
    const Instant until = m_now + time;
    for (;;) {
        std::vector<CanFrame> sent;
        for (const auto &each : m_nodes)
            if (const CanFrame *frame = each->toSend()) {
                const CanFrame copy = *frame;
                each->sent(copy, m_now);
                if (std::ranges::find(sent, copy) == sent.end())
                    sent.push_back(copy);
            }
        for (const CanFrame &frame : sent) {
            frames.push_back(textOf(frame));
            for (const auto &each : m_nodes)
                each->take(frame, m_now);
        }
        if (!sent.empty())
            continue;
        Instant next = until;
        for (const auto &each : m_nodes)
            next = std::min(next, each->wakesAt().value_or(until));
        for (const auto &each : m_nodes)
            each->proceed(std::max(next, m_now));
        if (next >= until && m_now == until)
            return frames;
        m_now = std::max(next, m_now);
    }
}

Frames NodeBench::send(const std::string &frame)
{
    for (const auto &each : m_nodes)
        each->take(frameOf(frame), m_now);
    return pass(2ms);
}

std::string NodeBench::ask(const std::string &frame)
{
    const Frames frames = send(frame);
    EXPECT_LE(frames.size(), 1U) << frame;
    return frames.empty() ? "" : frames.front();
}

std::string NodeBench::read(const std::string &object)
{
    std::string answer = ask("605#40 " + objectOctets(object) + " 00 00 00 00");
    if (answer.size() != 27)
        return answer;
    const CanFrame frame = frameOf(answer);
    if (frame.bytes[0] == 0x80) {
        char code[9];
        std::snprintf(code, sizeof code, "%08X", numberOf(frame.data().subspan(4)));
        return code;
    }
    const std::size_t unused = frame.bytes[0] >> 2 & 3;
    return answer.substr(16, 3 * (4 - unused) - 1);
}

std::string NodeBench::write(const std::string &command, const std::string &object, const std::string &value)
{
    std::string request = "605#" + command + ' ' + objectOctets(object) + ' ' + value;
    while (request.size() < 27)
        request += " 00";
    const std::string answer = ask(request);
    if (answer.starts_with("585#60"))
        return "";
    if (!answer.starts_with("585#80"))
        return answer.empty() ? "no answer" : answer;
    char code[9];
    std::snprintf(code, sizeof code, "%08X", numberOf(frameOf(answer).data().subspan(4)));
    return code;
}

std::int64_t NodeBench::number(const std::string &object)
{
    const std::string octets = "000#" + read(object);
    return numberOf(frameOf(octets).data());
}

void NodeBench::powerCycle()
{
    for (const auto &each : m_nodes)
        each->setOn(false);
    pass(1s);
    for (const auto &each : m_nodes)
        each->setOn(true);
    pass(SimulatedNode::bootTime);
}

} // namespace codewheel::canopen
