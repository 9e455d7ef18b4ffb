// SPDX-License-Identifier: GPL-3.0-or-later
// What a simulated node does with what is written to it.
#include "kinds/canopen/simulator/simulated_node.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr std::uint32_t saveSignature = 0x6576'6173; // "save"
constexpr std::uint32_t loadSignature = 0x6461'6F6C; // "load"

} // namespace

struct SimulatedNode::WriteRule
{
    std::uint16_t first;
    std::uint16_t last;
    Written (SimulatedNode::*act)(const SimulatedObject &);
    bool isValue = true; // and not only a command
};

constinit const std::array<SimulatedNode::WriteRule, 10> SimulatedNode::writeRules{{
    {0x1003, 0x1003, &SimulatedNode::clearErrors},
    {0x1010, 0x1010, &SimulatedNode::store, false},
    {0x1011, 0x1011, &SimulatedNode::restore, false},
    {0x1800, 0x1801, &SimulatedNode::setPdo},
    {0x1A00, 0x1A01, &SimulatedNode::setPdo},
    {0x2000, 0x2000, &SimulatedNode::setNode},
    {0x6000, 0x6000, &SimulatedNode::setOperatingParameters},
    {0x6003, 0x6003, &SimulatedNode::preset},
    {0x6200, 0x6200, &SimulatedNode::setCyclicTimer},
    {0x6401, 0x6402, &SimulatedNode::setWorkArea},
}};

SimulatedNode::Written SimulatedNode::write(SdoObject object, Octets octets, bool isSizeTold)
{
    const SimulatedObject *present = m_objects.find(object);
    if (!isSizeTold && present != nullptr)
        octets = octets.first(std::min(octets.size(), present->size()));
    const auto with = m_objects.written(object, octets);
    if (!with)
        return tl::unexpected(with.error());
    if (m_plan.quirks.writesOnlyPreOperational && m_state == NmtState::operational)
        return tl::unexpected(AbortCode::deviceState);
    const auto rule = std::ranges::find_if(writeRules, [object](const WriteRule &each) {
        return object.index >= each.first && object.index <= each.last;
    });
    if (rule != writeRules.end())
        if (const Written done = (this->*rule->act)(*with); !done)
            return done;
    if (rule == writeRules.end() || rule->isValue)
        m_objects.take(*with);
    return {};
}

SimulatedNode::Written SimulatedNode::clearErrors(const SimulatedObject &with)
{
    if (with.value != 0)
        return tl::unexpected(AbortCode::range);
    return {};
}

SimulatedNode::Written SimulatedNode::store(const SimulatedObject &with)
{
    if (with.value != saveSignature)
        return tl::unexpected(AbortCode::cannotStore);
    if (m_isEepromBroken)
        return tl::unexpected(AbortCode::hardware);
    m_stored = m_objects.kept(m_plan.quirks.keepsIdentifiers);
    if (m_plan.quirks.lssForgets || m_plan.quirks.hasNodeObject)
        m_storedSettings = m_lss.settings();
    m_silentUntil = std::max(m_silentUntil, m_now + m_plan.quirks.silenceWhileStoring);
    wrote();
    return {};
}

SimulatedNode::Written SimulatedNode::restore(const SimulatedObject &with)
{
    if (with.value != loadSignature)
        return tl::unexpected(AbortCode::cannotStore);
    if (m_plan.quirks.restore == NodeQuirks::Restore::atOnce) {
        m_objects = encoderObjects(m_plan, *m_node);
        return {};
    }
    if (m_isEepromBroken)
        return tl::unexpected(AbortCode::hardware);
    m_stored.clear();
    if (m_plan.quirks.restoresSettings)
        m_storedSettings = {.node = 1, .rate = 125'000};
    wrote();
    return {};
}

SimulatedNode::Written SimulatedNode::setNode(const SimulatedObject &with)
{
    if (m_plan.quirks.hasSwitches)
        return tl::unexpected(AbortCode::localControl);
    m_lss.setSettings({.node = static_cast<int>(with.value), .rate = m_lss.settings().rate});
    return {};
}

// The event timer of TPDO1 is 6200h, too.
SimulatedNode::Written SimulatedNode::setPdo(const SimulatedObject &with)
{
    if (const auto code = pdoRefusal(with, m_objects, m_plan.quirks))
        return tl::unexpected(*code);
    if (with.index == 0x1800 && with.sub == 5)
        m_objects.set(0x6200, 0, with.value);
    return {};
}

SimulatedNode::Written SimulatedNode::setCyclicTimer(const SimulatedObject &with)
{
    m_objects.set(0x1800, 5, with.value);
    return {};
}

SimulatedNode::Written SimulatedNode::setOperatingParameters(const SimulatedObject &with)
{
    constexpr std::int64_t direction = 0b0001;
    constexpr std::int64_t directionAndScaling = 0b0101;
    constexpr std::int64_t measuringDirection = 0b1000;
    const std::int64_t supported = m_plan.isLinear()         ? measuringDirection
                                   : m_plan.deviceClass == 2 ? directionAndScaling
                                                             : direction;
    if ((with.value & ~supported) != 0)
        return tl::unexpected(AbortCode::range);
    return {};
}

SimulatedNode::Written SimulatedNode::preset(const SimulatedObject &with)
{
    const auto offset = m_measurement.offsetFor(with.value, m_objects);
    if (!offset)
        return tl::unexpected(offset.error());
    m_objects.set(0x6509, 0, *offset);
    if (!m_plan.quirks.keepsPreset)
        return {};
    std::erase_if(m_stored,
                  [](const SimulatedObject &each) { return each.index == 0x6003 || each.index == 0x6509; });
    m_stored.push_back(with);
    m_stored.push_back(*m_objects.find({0x6509, 0}));
    wrote();
    return {};
}

SimulatedNode::Written SimulatedNode::setWorkArea(const SimulatedObject &with)
{
    const bool isLow = with.index == 0x6401;
    const std::int64_t low = isLow ? with.value : m_objects.number(0x6401, 1);
    const std::int64_t high = isLow ? m_objects.number(0x6402, 1) : with.value;
    if (low > high)
        return tl::unexpected(AbortCode::lowAboveHigh);
    return {};
}

} // namespace codewheel::canopen
