// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/line_at_port_test.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/structure/structure_view.h"

#include <QComboBox>
#include <QLineEdit>

namespace codewheel {
namespace {

const DeviceNumber at3 = DeviceNumber::onLine({3});
const DeviceNumber at7 = DeviceNumber::onLine({7});

class LineAtPort : public test::LineAtPortTest
{
protected:
    // In Operate, as the parameter panel writes it.
    void write(DeviceNumber number, Parameter parameter, std::int64_t value)
    {
        actions().operate->trigger();
        ASSERT_TRUE(comes([&] { return line().isOperating(); }));
        window().findChild<StructureView *>()->choose(number);
        window().findChild<WantedValues *>()->set(number, parameter, value);
        advance(50);
        auto &panel = *window().findChild<ParameterPanel *>();
        click(panel, QStringLiteral("Write..."));
        auto *confirm = panel.findChild<QPushButton *>(QStringLiteral("confirmWrite"));
        ASSERT_TRUE(confirm->isVisibleTo(&panel));
        QTest::mouseClick(confirm, Qt::LeftButton);
    }
};

TEST_F(LineAtPort, AnEncoderOfAnotherAddressIsFoundThereByTheProject)
{
    plan({encoder(at3, QStringLiteral("Slide"))});
    const QString port = startPeer(QStringLiteral("--addresses 03"));
    connectPort(port);
    ASSERT_TRUE(answers(at3));
    write(at3, Parameter::lineAddress, 7);
    ASSERT_TRUE(comes([&] { return line().encoder(at7) != nullptr && !line().encoder(at7)->runningJob(); }));
    ASSERT_EQ(project().line->encoders.size(), 1u);
    EXPECT_EQ(project().line->encoders[0].participant.number, at7);
    EXPECT_EQ(project().line->encoders[0].station, QStringLiteral("Slide"));
    EXPECT_EQ(shown->project().undoStack().undoText(), QStringLiteral("Address of esc:03 to esc:07"));

    connectPort(port);
    EXPECT_EQ(line().numbers(), std::vector{at7});
    EXPECT_TRUE(answers(at7));
}

} // namespace
} // namespace codewheel
