// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/pdo_mappings_heard.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr int firstOf(std::uint16_t index)
{
    return index & 0xFE00;
}

struct PdoName
{
    PdoDirection direction;
    int number;
};

// 14xxh and 16xxh of an RPDO, 18xxh and 1Axxh of a TPDO. Empty: it is an object of something else.
std::optional<PdoName> pdoOf(const SdoObject &object)
{
    constexpr int settings = 0x1400;
    constexpr int mapping = 0x1600;
    constexpr int transmit = 0x400; // further on
    const int first = firstOf(object.index);
    const int number = object.index - first + 1;
    if (first == settings || first == mapping)
        return PdoName{PdoDirection::receive, number};
    if (first == settings + transmit || first == mapping + transmit)
        return PdoName{PdoDirection::transmit, number};
    return std::nullopt;
}

} // namespace

void PdoMappingsHeard::followSdo(int node, const SdoFrame &sdo)
{
    SdoFrame &asked = m_asked.at(static_cast<std::size_t>(node));
    if (!sdo.isAnswer)
        asked = sdo;
    else if (sdo.kind == SdoFrame::Kind::value)
        take(node, sdo.object, sdo.data());
    else if (sdo.kind == SdoFrame::Kind::written && asked.kind == SdoFrame::Kind::write &&
             asked.object == sdo.object)
        take(node, sdo.object, asked.data());
}

void PdoMappingsHeard::take(int node, const SdoObject &object, Octets value)
{
    const auto name = pdoOf(object);
    if (!name)
        return;
    auto known = std::ranges::find_if(m_pdos, [&](const auto &pdo) {
        return pdo->node == node && pdo->direction == name->direction && pdo->number == name->number;
    });
    if (known == m_pdos.end())
        known = m_pdos.insert(known,
                              std::make_shared<const Pdo>(
                                  Pdo{node, name->direction, name->number, {name->direction, name->number}}));
    auto after = std::make_shared<Pdo>(**known); // what passed before keeps what was mapped then
    after->mapping.take(object, value);
    *known = std::move(after);
}

void PdoMappingsHeard::restarted(int node)
{
    std::erase_if(m_pdos, [node](const auto &pdo) { return pdo->node == node; });
}

std::shared_ptr<const PdoMappingsHeard::Pdo> PdoMappingsHeard::of(const CanFrame &frame) const
{
    const auto found =
        std::ranges::find_if(m_pdos, [&](const auto &pdo) { return pdo->mapping.isOf(frame); });
    return found == m_pdos.end() ? nullptr : *found;
}

} // namespace codewheel::canopen
