// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_edit.h"

#include "kinds/interbus/ring/ring_rules.h"
#include "kinds/interbus/ring/ring_tree.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct RingEdits
{
    Q_DECLARE_TR_FUNCTIONS(RingEdits)
};

tl::unexpected<Refusal> broken(const QString &rule)
{
    return refuse(RefusalKind::badInput, RefusalId::structureBroken, {rule});
}

bool isWorse(const RingFinding &finding, const std::vector<RingFinding> &before)
{
    return std::ranges::none_of(before, [&](const RingFinding &other) {
        return other.rule == finding.rule && other.count >= finding.count;
    });
}

// The edited structure, unless it breaks more rules than before.
Result<EditedRing> finish(const RingStructure &before, const RingTree &tree,
                          const RingStructure &participants)
{
    EditedRing edited{.structure = numbered(tree, participants), .from = {}};
    for (const std::size_t device : tree.order())
        edited.from.push_back(device < before.size() ? std::optional(device) : std::nullopt);
    const std::vector<RingFinding> findingsBefore = checkRing(before);
    for (const RingFinding &finding : checkRing(edited.structure))
        if (isWorse(finding, findingsBefore))
            return broken(ringFindingText(finding, edited.structure));
    return edited;
}

Result<void> checkPlace(const RingStructure &structure, const RingPlace &place, const RingDevice &device)
{
    if (place.onLocalBus && device.idCode() == busTerminalIdCode)
        return broken(RingEdits::tr("A bus terminal belongs on the remote bus."));
    if (!place.terminal)
        return place.onLocalBus ? Result<void>(broken(RingEdits::tr("A local bus needs a bus terminal.")))
                                : Result<void>();
    const RingDevice &terminal = structure.at(*place.terminal);
    if (terminal.idCode() == busTerminalIdCode)
        return {};
    return broken(RingEdits::tr("Nothing can hang below %1: it is not a bus terminal.")
                      .arg(terminal.number.toString()));
}

std::vector<std::size_t> &busAt(RingTree &tree, const RingPlace &place)
{
    if (!place.terminal)
        return tree.mainLine;
    RingTree::Node &terminal = tree.nodes[*place.terminal];
    return place.onLocalBus ? terminal.localBus : terminal.branch;
}

void putInto(RingTree &tree, const RingPlace &place, std::size_t row, std::size_t device)
{
    std::vector<std::size_t> &bus = busAt(tree, place);
    bus.insert(bus.begin() + static_cast<std::ptrdiff_t>(std::min(row, bus.size())), device);
    tree.nodes[device].parent = place.terminal;
    tree.nodes[device].isLocal = place.onLocalBus;
}

// Without those that are below another one of them, in ring order.
std::vector<std::size_t> topMost(const RingTree &tree, std::span<const std::size_t> devices)
{
    std::vector<std::size_t> top;
    for (const std::size_t device : devices)
        if (std::ranges::none_of(devices, [&](std::size_t other) {
                return other != device && tree.hangsBelow(device, other);
            }))
            top.push_back(device);
    std::ranges::sort(top);
    top.erase(std::unique(top.begin(), top.end()), top.end());
    return top;
}

} // namespace

RingPlace placeOf(const RingStructure &structure, std::size_t device)
{
    const RingTree tree = ringTree(structure);
    const RingTree::Node &node = tree.nodes.at(device);
    return {.terminal = node.parent, .onLocalBus = node.isLocal, .row = tree.rowOf(device)};
}

Result<EditedRing> insertDevice(const RingStructure &structure, const RingDevice &device,
                                const RingPlace &place)
{
    if (const auto checked = checkPlace(structure, place, device); !checked)
        return tl::unexpected(checked.error());
    RingTree tree = ringTree(structure);
    RingStructure participants = structure;
    participants.push_back(device);
    tree.nodes.emplace_back();
    putInto(tree, place, place.row, structure.size());
    return finish(structure, tree, participants);
}

Result<EditedRing> removeDevices(const RingStructure &structure, std::span<const std::size_t> devices)
{
    RingTree tree = ringTree(structure);
    for (const std::size_t device : topMost(tree, devices))
        std::erase(tree.busOf(device), device);
    return finish(structure, tree, structure);
}

Result<EditedRing> moveDevices(const RingStructure &structure, std::span<const std::size_t> devices,
                               const RingPlace &place)
{
    RingTree tree = ringTree(structure);
    const std::vector<std::size_t> moved = topMost(tree, devices);
    for (const std::size_t device : moved) {
        if (const auto checked = checkPlace(structure, place, structure.at(device)); !checked)
            return tl::unexpected(checked.error());
        if (place.terminal && tree.hangsBelow(*place.terminal, device))
            return broken(
                RingEdits::tr("%1 cannot hang below itself.").arg(structure[device].number.toString()));
    }
    std::size_t row = std::min(place.row, busAt(tree, place).size());
    for (const std::size_t device : moved) {
        std::vector<std::size_t> &bus = tree.busOf(device);
        if (&bus == &busAt(tree, place) && tree.rowOf(device) < row)
            --row;
        std::erase(bus, device);
    }
    for (const std::size_t device : moved)
        putInto(tree, place, row++, device);
    return finish(structure, tree, structure);
}

Result<EditedRing> changeDevice(const RingStructure &structure, std::size_t device, const RingDevice &to)
{
    const RingTree tree = ringTree(structure);
    if (!tree.nodes.at(device).isLeaf() && to.idCode() != busTerminalIdCode)
        return broken(RingEdits::tr("Devices hang below %1, so it has to stay a bus terminal.")
                          .arg(structure[device].number.toString()));
    RingStructure participants = structure;
    participants[device] = to;
    return finish(structure, tree, participants);
}

} // namespace codewheel
