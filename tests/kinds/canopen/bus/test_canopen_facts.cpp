// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "kinds/canopen/bus/canopen_facts.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"

#include <gtest/gtest.h>
#include <set>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanopenFactsOfABus : public test::CanopenPlant
{
protected:
    QString text(const char *key) const { return canopenFact(QLatin1String(key)).text(*bus); }
    QJsonValue json(const char *key) const { return canopenFact(QLatin1String(key)).json(*bus); }
};

TEST_F(CanopenFactsOfABus, HaveKeyLabelAndToolTipEachOnce)
{
    std::set<std::string> keys;
    for (const CanopenFact &fact : canopenFacts()) {
        EXPECT_TRUE(keys.insert(fact.key).second) << fact.key;
        EXPECT_FALSE(fact.label().isEmpty() || fact.toolTip().isEmpty()) << fact.key;
    }
    keys.clear();
    for (const CanopenNodeFact &fact : canopenNodeFacts()) {
        EXPECT_TRUE(keys.insert(fact.key).second) << fact.key;
        EXPECT_FALSE(fact.label().isEmpty() || fact.toolTip().isEmpty()) << fact.key;
    }
}

TEST_F(CanopenFactsOfABus, TellTheBusInTextAndInJson)
{
    operate();
    EXPECT_EQ(text("rate"), QStringLiteral("125 kBit/s"));
    EXPECT_EQ(json("rate"), QJsonValue(125'000));
    EXPECT_GT(json("received").toInt(), 10);
    EXPECT_GT(json("sent").toInt(), 0);
    EXPECT_EQ(json("errorFrames"), QJsonValue(0));
    EXPECT_EQ(text("controller"), QStringLiteral("no errors"));
    EXPECT_EQ(json("controller"), QJsonValue(QStringLiteral("active")));
    EXPECT_EQ(json("otherMaster"), QJsonValue(false));
    EXPECT_EQ(text("otherMaster"), QStringLiteral("none is heard"));
    say(test::canFrame(0x80, {}));
    bus->advance(100ms);
    EXPECT_EQ(text("otherMaster"), QStringLiteral("SYNC"));
    EXPECT_TRUE(text("load").endsWith(QStringLiteral(" %")));
}

// Node 5 has no heartbeat that would tell.
TEST_F(CanopenFactsOfABus, ANodeThatWasStoppedIsToldAsStopped)
{
    operate();
    bus->transfer({.node = 5, .object = {0x1017, 0}, .value = std::vector<std::uint8_t>{0, 0}});
    bus->transfer({.node = 5, .object = {0x1800, 5}, .value = std::vector<std::uint8_t>{50, 0}});
    bus->advance(500ms);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 5}.frame());
    bus->advance(500ms);
    const auto fact = [this](const char *key) {
        const auto its = std::ranges::find_if(
            canopenNodeFacts(), [key](const CanopenNodeFact &each) { return qstrcmp(each.key, key) == 0; });
        return its->text(*bus->latest().heard(5)).toStdString();
    };
    const auto shownInTree = [this] { return bus->outline().state(0).shown; };
    EXPECT_EQ(fact("state"), "operational");
    EXPECT_EQ(fact("sendsPdos"), "sends");
    EXPECT_EQ(shownInTree().role, Role::running);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::stop, 5}.frame());
    bus->advance(200ms);
    EXPECT_EQ(fact("state"), "stopped (as commanded)");
    EXPECT_EQ(fact("sendsPdos"), "");
    EXPECT_EQ(shownInTree().role, Role::attention);
    EXPECT_EQ(shownInTree().word, QStringLiteral("stopped"));
}

TEST_F(CanopenFactsOfABus, TellANodeInTextAndInJson)
{
    const CanopenSnapshot::Node node{.node = 26,
                                     .state = canopen::NmtState::preOperational,
                                     .heartbeat = canopen::Heartbeat::lost,
                                     .isDoubled = true,
                                     .error = canopen::Emcy{.code = 0x8130, .errorRegister = 0x11}};
    QStringList texts;
    QStringList json;
    for (const CanopenNodeFact &fact : canopenNodeFacts()) {
        texts << fact.text(node);
        json << QStringLiteral("%1=%2").arg(QString::fromLatin1(fact.key),
                                            fact.json(node).toVariant().toString());
    }
    EXPECT_EQ(texts.join(u'|').toStdString(), "26 (1Ah)|pre-operational|lost||two nodes have this number|" +
                                                  node.error->text().toStdString());
    EXPECT_EQ(json.join(u' ').toStdString(), "node=26 state=preOperational heartbeat=lost sendsPdos=false "
                                             "doubled=true error=33072");
    const CanopenSnapshot::Node booted{.node = 26, .hasBooted = true};
    const auto stateFact = std::ranges::find_if(
        canopenNodeFacts(), [](const CanopenNodeFact &fact) { return qstrcmp(fact.key, "state") == 0; });
    EXPECT_EQ(stateFact->text(booted).toStdString(), "boot-up");
    EXPECT_TRUE(stateFact->json(booted).isNull());
    EXPECT_EQ(nodeTroubles(node).size(), 3);
    EXPECT_TRUE(nodeTroubles({.node = 5}).isEmpty());
    EXPECT_TRUE(nmtStateJson(static_cast<canopen::NmtState>(9)).isNull());
}

} // namespace
} // namespace codewheel
