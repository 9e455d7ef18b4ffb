// SPDX-License-Identifier: GPL-3.0-or-later
// What the cam editor shows for cams while another program with a shifted position is running.
#include "tests/widgets/cams/cam_editor_test.h"
#include "widgets/cams/cam_table_model.h"

namespace codewheel {
namespace {

using test::fraba;

// The shaft is somewhere from 256 to 511.
class CamsAtACoarsePosition : public test::CamEditorTest
{
protected:
    CamsAtACoarsePosition()
    {
        tellAll();
        sheet().setShift(8);
        trigger("Write…");
        click("confirmWriteCams");
        finishJob();
        trigger("Run this program in the encoder");
        finishJob();
        ring.controls->turnTo(fraba.node, 300);
        advance(60);
        sheet().setNumber(2);
    }
    std::optional<bool> isOn(const Cam &cam)
    {
        sheet().setCam(manual, cam, {});
        return sheet().isOn(manual);
    }

    static constexpr std::size_t manual = test::manualCam;
};

TEST_F(CamsAtACoarsePosition, ACamWithAnEdgeInItMayBeEither)
{
    ASSERT_EQ(sheet().live().position, (CamLive::Position{256, 511}));
    for (const Cam &cam : {Cam{277, 469, true}, Cam{257, 510, true}, Cam{300, 300, true}, Cam{100, 300, true},
                           Cam{300, 700, true}, Cam{100, 256, true}, Cam{511, 700, true},
                           // through zero
                           Cam{300, 100, true}, Cam{900, 300, true}, Cam{400, 390, true}})
        EXPECT_EQ(isOn(cam), std::nullopt) << cam.start << " to " << cam.stop;
}

TEST_F(CamsAtACoarsePosition, ACamOnAllOfItIsOn)
{
    for (const Cam &cam : {Cam{256, 511, true}, Cam{100, 700, true}, Cam{0, 33'554'431, true},
                           // through zero
                           Cam{900, 511, true}, Cam{256, 100, true}, Cam{401, 400, true}})
        EXPECT_EQ(isOn(cam), true) << cam.start << " to " << cam.stop;
}

TEST_F(CamsAtACoarsePosition, ACamOnNoneOfItIsOff)
{
    for (const Cam &cam : {Cam{100, 255, true}, Cam{512, 700, true}, Cam{277, 469, false},
                           // through zero
                           Cam{512, 255, true}, Cam{900, 100, true}})
        EXPECT_EQ(isOn(cam), false) << cam.start << " to " << cam.stop;
}

TEST_F(CamsAtACoarsePosition, TheOthersAreKnownBesideOneThatIsNot)
{
    sheet().setCam(0, {277, 469, true}, {});
    sheet().setCam(1, {256, 511, true}, {});
    EXPECT_EQ(sheet().isOn(0), std::nullopt);
    EXPECT_EQ(sheet().isOn(1), true);
    EXPECT_EQ(sheet().isOn(2), false);
    const auto &table = *editor.findChild<CamTableModel *>();
    const auto now = [&table](int row) {
        return table.index(row, CamTableModel::stateColumn).data().toString();
    };
    EXPECT_EQ(now(0), QStringLiteral("unknown"));
    EXPECT_EQ(now(1), QStringLiteral("on"));
    EXPECT_EQ(now(2), QStringLiteral("off"));
}

TEST_F(CamsAtACoarsePosition, TheRunningProgramIsWhatTheEncoderShows)
{
    sheet().setNumber(1);
    sheet().setCam(0, {277, 469, true}, {}); // not written
    EXPECT_TRUE(sheet().live().isTold);
    EXPECT_EQ(sheet().isOn(0), false);
}

} // namespace
} // namespace codewheel
