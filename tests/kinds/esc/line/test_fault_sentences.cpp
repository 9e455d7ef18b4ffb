// SPDX-License-Identifier: GPL-3.0-or-later
// Every fault of a serial line has a sentence that says where it is and what to do.
#include "bus/bus_outline.h"
#include "catalog/catalog.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr EscLineAddress sufferer{5};

class EscLineFaultSentences : public testing::Test
{
protected:
    EscLineFaultSentences()
    {
        EXPECT_TRUE(session.open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
        for (const EscLineAddress address : line->addresses())
            EXPECT_TRUE(session.add(address, QStringLiteral("kuebler-esc-rs485")));
        session.advance(2s);
    }

    void befall(void (*what)(EscCondition &condition))
    {
        EXPECT_TRUE(
            line->withEncoder(sufferer, [what](SimulatedEscEncoder &encoder) { what(encoder.condition()); }));
        session.advance(10s);
    }
    std::vector<Fault> faults() const { return session.outline().faults(); }
    void expectOne(NodeId node, const char *text) const
    {
        ASSERT_EQ(faults().size(), 1U);
        EXPECT_EQ(faults().front().node, node);
        EXPECT_EQ(faults().front().text.toStdString(), text);
    }

    const Catalog catalog = Catalog::builtIn();
    const std::shared_ptr<SimulatedEscLine> line = std::make_shared<SimulatedEscLine>();
    EscLineSession session{std::make_unique<SimulatedEscLineLink>(line), catalog,
                           QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
                           [](const DeviceDescription &device, EscLineAddress address) {
                               return std::make_unique<EscDriver>(device, address);
                           }};
};

TEST_F(EscLineFaultSentences, NothingIsWrongWithALineWhereAllAnswer)
{
    EXPECT_TRUE(faults().empty());
    session.close();
    EXPECT_TRUE(faults().empty());
}

TEST_F(EscLineFaultSentences, OneThatIsSilentIsLookedForAtItself)
{
    befall([](EscCondition &condition) { condition.mute = true; });
    expectOne(sufferer.node(), "esc:05 does not answer. Check address, baud rate, wiring and supply.");
    befall([](EscCondition &condition) { condition.mute = false; });
    EXPECT_TRUE(faults().empty());
}

TEST_F(EscLineFaultSentences, WhereNoneAnswersItIsWhatTheyShare)
{
    line->setSilent(true);
    session.advance(30s);
    expectOne(
        {}, "No encoder answers on training line at 19200 Bd. Check the wires (A and B may be swapped), the "
            "supply of the encoders, and the baud rate.");
    EXPECT_EQ(faults().front().extent, Fault::Extent::standstill);
}

TEST_F(EscLineFaultSentences, APortThatIsGoneStopsAll)
{
    line->setUnplugged(true);
    session.advance(2s);
    expectOne({},
              "The serial port training line is gone: the adapter was unplugged or has lost its supply. Plug "
              "it in again.");
    EXPECT_TRUE(session.outline().state(0).isCutOff);
    EXPECT_EQ(session.outline().state().word, QStringLiteral("no port"));
}

TEST_F(EscLineFaultSentences, AlarmsAndWarningsSayWhatToDo)
{
    befall([](EscCondition &condition) { condition.batteryLimit = true; });
    expectOne(sufferer.node(),
              "esc:05 reports an alarm: general fault, battery limit reached. Have its battery "
              "replaced, and check the position.");
    befall([](EscCondition &condition) {
        condition.batteryLimit = false;
        condition.batteryFlat = true;
    });
    expectOne(sufferer.node(), "esc:05 reports an alarm: battery flat. Have its battery replaced, "
                               "and check the position.");
    EXPECT_EQ(faults().front().shown.role, Role::fault);
    befall([](EscCondition &condition) {
        condition.batteryFlat = false;
        condition.temperatureExceeded = true;
    });
    EXPECT_TRUE(faults().front().text.contains(QStringLiteral("Let it cool down")));
    befall([](EscCondition &condition) {
        condition.temperatureExceeded = false;
        condition.positionError = true;
    });
    EXPECT_TRUE(faults().front().text.contains(QStringLiteral("Switch it off and on")));
}

} // namespace
} // namespace codewheel
