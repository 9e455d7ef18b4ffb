// SPDX-License-Identifier: GPL-3.0-or-later
// The review of the cam editor shows the words that are sent.
#include "kinds/interbus/words/k3_cam_word.h"
#include "tests/widgets/cams/cam_editor_test.h"
#include "vocabulary/hex.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::fraba;
using test::manualCam;
using test::manualValue;
using testing::HasSubstr;
using testing::StartsWith;

class CamReviewWords : public test::CamEditorTest
{
protected:
    QStringList words() { return reviewed(CamReview::wordColumn); }
    std::string joined(CamReview::Column column) { return reviewed(column).join(u'|').toStdString(); }
    std::string wordsShown() { return words().join(u' ').toStdString(); }
    void readPrograms(const char *tool)
    {
        tellAll();
        trigger(tool);
        finishJob();
    }
    void setCam(std::size_t cam, const Cam &value) { sheet().setCam(cam, value, {}); }
    void stand(Word word) // in OUT, as typed into a monitor
    {
        ring.channel(fraba).stage(word);
        ASSERT_TRUE(ring.channel(fraba).write());
        advance(60);
        ASSERT_EQ(out(), word);
    }
    std::string notes()
    {
        QString all;
        for (const QLabel *label : review().findChildren<QLabel *>())
            all += label->text() + u'\n';
        return all.toStdString();
    }
    // The OUT words as they changed, without the read-outs and the 00000000 after each.
    std::string wordsSentByTheJob()
    {
        std::vector<Word> sent{out()};
        const auto listens =
            QObject::connect(&encoder(), &EncoderSession::exchanged, &editor, [&sent](const Exchange &row) {
                if (row.out != sent.back())
                    sent.push_back(row.out);
            });
        click("confirmWriteCams");
        finishJob();
        QObject::disconnect(listens);
        QStringList words;
        for (std::size_t i = 1; i < sent.size(); ++i)
            if (k3::isCamReadOutRequest(sent[i]))
                i += i + 1 < sent.size() && sent[i + 1] == k3::normalRunning ? 1 : 0;
            else
                words << hexWord(sent[i]);
        return words.join(u' ').toStdString();
    }
    void expectWhatIsShownIsSent()
    {
        const std::string shown = wordsShown();
        EXPECT_EQ(wordsSentByTheJob(), shown);
        EXPECT_TRUE(message().contains(QStringLiteral("read back"))) << message().toStdString();
    }
};

TEST_F(CamReviewWords, AreThoseOfTheManualInTheOrderInWhichTheyAreSent)
{
    readPrograms("Read");
    sheet().setCam(manualCam, manualValue, {});
    trigger("Write…");
    ASSERT_TRUE(review().isVisible());
    EXPECT_EQ(out(), 0U);
    EXPECT_EQ(wordsShown(), "20800001 46000015 66000213 20400008 80000000 00000000 20800000 00000000");
    expectWhatIsShownIsSent();
    ASSERT_TRUE(encoder().cams(1));
    EXPECT_EQ(encoder().cams(1)->program, program(1));
    EXPECT_EQ(sheet().differs(1), false);
    EXPECT_EQ(encoder().latest().mode, Mode::position) << "as before";
    EXPECT_EQ(out(), 0U);
}

// Outside cam mode, 20400001 would switch to velocity mode.
TEST_F(CamReviewWords, ShowTheWordThatGoesBeforeOneWithAnotherMeaning)
{
    readPrograms("Read");
    setCam(0, {0, 0, true});
    trigger("Write…");
    EXPECT_EQ(wordsShown(), "20800001 20100000 20400001 80000000 00000000 20800000 00000000");
    EXPECT_THAT(notes(), HasSubstr("20100000"));
    expectWhatIsShownIsSent();
}

TEST_F(CamReviewWords, TellProgramMeaningAndWhatTheEncoderHas)
{
    readPrograms("Read");
    setCam(0, {0, 0, true});
    trigger("Write…");
    QAbstractItemModelTester tester(review().findChild<ReviewTable *>(),
                                    QAbstractItemModelTester::FailureReportingMode::Warning);
    EXPECT_EQ(joined(CamReview::meaningColumn),
              "Cam mode, program 1|Position beside the cams shifted by 0|Active cams: 0|"
              "Run: the values become valid|Back to normal running|Position mode|Back to normal running");
    EXPECT_EQ(joined(CamReview::programColumn), "1|1|1|1|1||");
    EXPECT_EQ(joined(CamReview::oldColumn), "|0|none||||");
}

TEST_F(CamReviewWords, OfAllThatIsThereBeginWithTheShiftToo)
{
    readPrograms("Read");
    trigger("Write…");
    ASSERT_TRUE(words().isEmpty());
    review().findChild<QCheckBox *>()->click();
    EXPECT_THAT(wordsShown(), StartsWith("20800001 20100000 40000000 60000000"));
    EXPECT_EQ(words().size(), 1 + 18 + 4);
    expectWhatIsShownIsSent();
}

TEST_F(CamReviewWords, OfAProgramThatIsStayedInLeaveItOnceSoThatItIsStored)
{
    readPrograms("Read");
    setCam(0, {0, 0, true});
    trigger("Write…");
    auto &afterwards = *review().findChild<QComboBox *>();
    afterwards.setCurrentIndex(afterwards.findText(QStringLiteral("cam mode, program 1")));
    EXPECT_EQ(wordsShown(), "20800001 20100000 20400001 80000000 00000000 20800000 20800001 00000000");
    expectWhatIsShownIsSent();
}

// The encoder's present program comes first, and before it OUT is cleared.
TEST_F(CamReviewWords, BeginWhereTheEncoderIs)
{
    readPrograms("Read all programs");
    setCam(manualCam, {5, 9, false});
    sheet().setNumber(2);
    setCam(0, {0, 7, false});
    stand(0x2080'0002);
    trigger("Write all programs…");
    EXPECT_EQ(wordsShown(), "00000000 60000007 80000000 00000000 "
                            "20800001 46000005 66000009 80000000 00000000 "
                            "20800002 00000000");
    EXPECT_EQ(joined(CamReview::programColumn), "2|2|2|2|1|1|1|1|1|2|2");
    expectWhatIsShownIsSent();
}

TEST_F(CamReviewWords, FollowAWordThatIsSentWhileTheyAreShown)
{
    readPrograms("Read");
    setCam(manualCam, {5, 9, false});
    trigger("Write…");
    EXPECT_THAT(wordsShown(), StartsWith("20800001 46000005"));
    stand(0x2080'0001);
    EXPECT_THAT(wordsShown(), StartsWith("00000000 46000005"));
    expectWhatIsShownIsSent();
}

TEST_F(CamReviewWords, AreNoneWhereTheEncoderHasAllOfIt)
{
    readPrograms("Read");
    trigger("Write…");
    EXPECT_TRUE(words().isEmpty());
    EXPECT_FALSE(button("confirmWriteCams")->isEnabled());
    EXPECT_THAT(notes(), HasSubstr("There is nothing to write."));
}

TEST_F(CamReviewWords, OfAProgramNobodyKnowsAreAllOfIt)
{
    tellAll();
    setCam(manualCam, manualValue);
    trigger("Write…");
    EXPECT_EQ(words().size(), 1 + 18 + 4);
    EXPECT_EQ(reviewed(CamReview::oldColumn).count(QStringLiteral("unknown")), 18);
    EXPECT_THAT(notes(), HasSubstr("is not written again"));
}

TEST_F(CamReviewWords, AreNoneWhereTheJobWouldBeRefused)
{
    readPrograms("Read");
    setCam(2, {0, 33'554'431, true});
    trigger("Write…");
    ASSERT_FALSE(words().isEmpty());
    encoder().tell(Parameter::steps, 4096);
    EXPECT_TRUE(words().isEmpty());
    EXPECT_FALSE(button("confirmWriteCams")->isEnabled());
    EXPECT_THAT(notes(), HasSubstr("Cam 2 cannot start or stop at 33554431."));
}

TEST_F(CamReviewWords, AreNotSentAfterEscape)
{
    tellAll();
    setManualCam();
    trigger("Write…");
    QTest::keyClick(&review(), Qt::Key_Escape);
    EXPECT_FALSE(review().isVisible());
    advance(100);
    EXPECT_EQ(out(), 0U);
    EXPECT_FALSE(encoder().runningJob());
}

} // namespace
} // namespace codewheel
