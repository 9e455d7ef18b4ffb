// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/pdo_mappings_heard.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

// Of 18xxh and 1Axxh. Empty: it is an object of something else.
std::optional<int> pdoOf(const SdoObject &object)
{
    constexpr int settings = 0x1800;
    constexpr int mapping = 0x1A00;
    constexpr int behind = 0x1C00;
    if (object.index < settings || object.index >= behind)
        return std::nullopt;
    return object.index - (object.index < mapping ? settings : mapping) + 1;
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
    const auto number = pdoOf(object);
    if (!number)
        return;
    auto known = std::ranges::find_if(
        m_pdos, [&](const auto &pdo) { return pdo->node == node && pdo->mapping.number() == *number; });
    if (known == m_pdos.end())
        known = m_pdos.insert(known, std::make_shared<const Pdo>(Pdo{node, PdoMapping(*number)}));
    auto after = std::make_shared<Pdo>(**known); // what passed before keeps what was mapped then
    after->mapping.take(object, value);
    *known = std::move(after);
    sortByIdentifier();
}

void PdoMappingsHeard::restarted(int node)
{
    std::erase_if(m_pdos, [node](const auto &pdo) { return pdo->node == node; });
    sortByIdentifier();
}

void PdoMappingsHeard::sortByIdentifier()
{
    m_byIdentifier.clear();
    for (const auto &pdo : m_pdos)
        if (!pdo->mapping.isOff())
            m_byIdentifier.try_emplace(pdo->mapping.identifier(), pdo);
}

std::shared_ptr<const PdoMappingsHeard::Pdo> PdoMappingsHeard::of(const CanFrame &frame) const
{
    const auto found = m_byIdentifier.find(frame.id);
    return found != m_byIdentifier.end() && found->second->mapping.isOf(frame) ? found->second : nullptr;
}

bool PdoMappingsHeard::isElsewhere(int node, int number, std::uint32_t identifier) const
{
    return std::ranges::any_of(m_pdos, [&](const auto &pdo) {
        const PdoMapping &mapping = pdo->mapping;
        return pdo->node == node && mapping.number() == number && mapping.hasIdentifier() &&
               (mapping.isOff() || mapping.identifier() != identifier);
    });
}

} // namespace codewheel::canopen
