// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/encoder_objects.h"

#include <limits>

namespace codewheel::canopen {
namespace {

using Objects = std::vector<SimulatedObject>;

constexpr SimulatedObject::Range positiveNumbers{1, std::numeric_limits<std::int32_t>::max()};

void add(Objects &objects, const Objects &more)
{
    objects.insert(objects.end(), more.begin(), more.end());
}

std::uint16_t plus(int index, int number)
{
    return static_cast<std::uint16_t>(index + number);
}

struct EncoderRows
{
    using enum SimulatedObject::Type;
    using enum SimulatedObject::Access;

    // Sub 0 says how many there are.
    static SimulatedObject count(std::uint16_t index, std::uint8_t highestSub)
    {
        return {index, 0, u8, readOnly, highestSub};
    }

    static SimulatedObject named(std::uint16_t index, const std::string &its)
    {
        return {.index = index, .type = SimulatedObject::Type::text, .text = its};
    }

    static Objects communication(const CanopenEncoderPlan &plan, int node)
    {
        Objects objects{
            {0x1000, 0, u32, readOnly, plan.deviceType()},
            {0x1001, 0, u8, readOnly, 0, {}, true},
            {0x1003, 0, u8, readWrite},
            {0x1005, 0, u32, readWrite, 0x80},
            named(0x1008, plan.name),
            named(0x1009, "1.00"),
            named(0x100A, "4.04 simulated"),
            {0x100C, 0, u16, readWrite},
            {0x100D, 0, u8, readWrite},
            count(0x1010, 1),
            {0x1010, 1, u32, readWrite, 1},
            count(0x1011, 1),
            {0x1011, 1, u32, readWrite, 1},
            {0x1014, 0, u32, readWrite, 0x80 + node},
            {0x1017, 0, u16, readWrite, plan.heartbeat},
            count(0x1018, 4),
            count(0x1200, 2),
            {0x1200, 1, u32, readOnly, 0x600 + node},
            {0x1200, 2, u32, readOnly, 0x580 + node},
        };
        std::uint8_t word = 0;
        for (const std::uint32_t number : plan.identity)
            objects.push_back({0x1018, ++word, u32, readOnly, number});
        for (std::uint8_t i = 1; i <= mostErrorsKept; ++i)
            objects.push_back({0x1003, i, u32, readOnly});
        return objects;
    }

    // TPDO1 on change, with the position; TPDO2 at each SYNC, with the speed as well where there is one.
    static Objects transmitPdos(const CanopenEncoderPlan &plan, int node)
    {
        constexpr std::int64_t position = 0x6004'0020;
        constexpr std::int64_t speed = 0x6030'0110;
        constexpr int onChange = 254;
        const bool hasSpeed = plan.deviceClass == 2;
        Objects objects;
        for (int i = 0; i < transmitPdoCount; ++i) {
            const std::uint16_t index = plus(0x1800, i);
            const std::uint16_t mapping = plus(0x1A00, i);
            const bool isFirst = i == 0;
            add(objects, {count(index, 5),
                          {index, 1, u32, readWrite, (isFirst ? 0x180 : 0x280) + node},
                          {index, 2, u8, readWrite, isFirst ? onChange : 1},
                          {index, 3, u16, readWrite, isFirst ? plan.inhibitTime : 0},
                          {index, 5, u16, readWrite, isFirst ? plan.cyclicTimer : 0},
                          {mapping, 0, u8, readWrite, !isFirst && hasSpeed ? 2 : 1},
                          {mapping, 1, u32, readWrite, position},
                          {mapping, 2, u32, readWrite, !isFirst && hasSpeed ? speed : 0}});
            for (std::uint8_t sub = 3; sub <= mostMapped; ++sub)
                objects.push_back({mapping, sub, u32, readWrite});
        }
        return objects;
    }

    static Objects ofEveryEncoder(const CanopenEncoderPlan &plan)
    {
        const std::int64_t step = plan.isLinear() ? plan.linearStep : plan.resolution.stepsPerTurn;
        return {
            {.index = 0x5F00,
             .type = SimulatedObject::Type::text,
             .access = readWrite}, // where it is mounted
            {0x6000, 0, u16, readWrite},
            {0x6004, 0, plan.isLinear() ? i32 : u32, readOnly, 0, {}, true},
            {0x6200, 0, u16, readWrite, plan.cyclicTimer},
            {0x6500, 0, u16, readOnly},
            {0x6501, 0, u32, readOnly, step},
            {0x6503, 0, u16, readOnly, 0, {}, true},
            {0x6504, 0, u16, readOnly, 0x1001},
            {0x6505, 0, u16, readOnly, 0, {}, true},
            {0x6506, 0, u16, readOnly, 0x0017},
            {0x6507, 0, u32, readOnly, 0x0404'0302},
            {0x6508, 0, u32, readOnly},
            count(0x650A, 3),
            {0x650A, 1, i32, readOnly},
            {0x650A, 2, i32, readOnly},
            {0x650A, 3, i32, readOnly, plan.positions() - 1},
            {0x650B, 0, u32, readOnly, plan.identity[3]},
        };
    }

    static Objects rotary(const CanopenEncoderPlan &plan)
    {
        const std::int64_t most = plan.positions() - (plan.quirks.rangeIsHighest ? 1 : 0);
        const std::int64_t steps = plan.resolution.stepsPerTurn;
        return {
            {0x6001, 0, u32, readWrite, steps, SimulatedObject::Range{1, steps}},
            {0x6002, 0, u32, readWrite, most, SimulatedObject::Range{1, most}},
            {0x6003, 0, u32, readWrite},
        };
    }

    static Objects linear(const CanopenEncoderPlan &plan)
    {
        return {
            {0x6003, 0, i32, readWrite},
            count(0x6005, 2),
            {0x6005, 1, u32, readWrite, plan.linearStep, positiveNumbers},
            {0x6005, 2, u32, readWrite, 1, positiveNumbers}, // 0.01 mm/s
        };
    }

    static Objects ofClass2()
    {
        Objects objects{
            count(0x6030, 1),           {0x6030, 1, i16, readOnly, 0, {}, true},
            count(0x6300, 1),           {0x6300, 1, u8, readOnly, 0, {}, true},
            count(0x6301, 1),           {0x6301, 1, u8, readWrite},
            count(0x6302, 1),           {0x6302, 1, u8, readWrite},
            count(0x6400, 1),           {0x6400, 1, u8, readOnly, 0, {}, true},
            count(0x6401, 1),           {0x6401, 1, i32, readWrite},
            count(0x6402, 1),           {0x6402, 1, i32, readWrite, positiveNumbers.high},
            {0x6509, 0, i32, readOnly},
        };
        for (int cam = 0; cam < camCount; ++cam)
            add(objects, {count(plus(0x6310, cam), 1),
                          {plus(0x6310, cam), 1, i32, readWrite},
                          count(plus(0x6320, cam), 1),
                          {plus(0x6320, cam), 1, i32, readWrite},
                          count(plus(0x6330, cam), 1),
                          {plus(0x6330, cam), 1, u16, readWrite}});
        return objects;
    }

    static Objects ofItsMaker(const NodeQuirks &quirks, int node)
    {
        Objects objects;
        if (quirks.hasNodeObject)
            objects.push_back({0x2000, 0, u8, readWrite, node, SimulatedObject::Range{1, 127}});
        if (quirks.speedIsOff)
            add(objects, {count(0x3010, 1),
                          {0x3010, 1, u8, readWrite, 0, SimulatedObject::Range{0, 1}},
                          {0x3011, 0, u32, readOnly, 0, {}, true}});
        return objects;
    }
};

} // namespace

ObjectDictionary encoderObjects(const CanopenEncoderPlan &plan, int node)
{
    Objects objects = EncoderRows::communication(plan, node);
    add(objects, EncoderRows::transmitPdos(plan, node));
    add(objects, EncoderRows::ofEveryEncoder(plan));
    if (plan.deviceClass == 2) {
        add(objects, plan.isLinear() ? EncoderRows::linear(plan) : EncoderRows::rotary(plan));
        add(objects, EncoderRows::ofClass2());
    }
    if (!plan.isLinear())
        objects.push_back(
            {.index = 0x6502, .type = SimulatedObject::Type::u16, .value = plan.resolution.turns});
    add(objects, EncoderRows::ofItsMaker(plan.quirks, node));
    return ObjectDictionary(std::move(objects));
}

} // namespace codewheel::canopen
