// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include "can/simulator/simulated_can_link.h"
#include "cli/commands.h"
#include "cli/kinds/canopen/canopen_access.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr std::size_t sixth = 1; // its place among the encoders of the training bus

} // namespace

CliRun SharedCanBus::runLine(const QString &line, const Person &person)
{
    QStringList words = line.split(u' ', Qt::SkipEmptyParts);
    const Subcommand *command = commandNamed(words.takeFirst());
    const auto arguments = parseArguments(words, optionsOf(*command), {});
    if (!arguments) {
        ADD_FAILURE() << line.toStdString();
        return {};
    }
    const auto link = canopenLinkMeant(
        *LinkText::parse(arguments->value("--link").value_or(QStringLiteral("canopen:training"))));
    EXPECT_TRUE(link) << line.toStdString();
    return runWith(person, [&](const Terminal &terminal) {
        CanopenAccess access(std::make_unique<SimulatedCanLink>(m_plant.bus()), *link, m_catalog);
        access.keepLedger(arguments->value("--ledger"));
        return runOn(*command, *arguments, m_catalog, {&access}, terminal);
    });
}

std::uint64_t SharedCanBus::eepromWritesOf6()
{
    return m_plant.withEncoder(sixth, [](canopen::SimulatedNode &node) { return node.eepromWrites(); });
}

canopen::NmtState SharedCanBus::stateOf6()
{
    return m_plant.withEncoder(sixth, [](canopen::SimulatedNode &node) { return node.state(); });
}

} // namespace codewheel
