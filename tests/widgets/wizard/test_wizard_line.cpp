// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/position_scale.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/make_driver.h"
#include "tests/widgets/wizard/wizard_test.h"
#include "widgets/monitor/position_range.h"
#include "widgets/parameters/position_to_set.h"

#include <QRegularExpression>

// The wizard with a Kübler encoder on the simulated line: requests from chapter 2 of its manual.
namespace codewheel {
namespace {

const Place place = placeOnLine({5}); // at 1235h

class WizardLine : public test::WizardTest
{
protected:
    WizardLine()
    {
        EXPECT_TRUE(line.open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byHand));
        EXPECT_TRUE(line.add({5}, QStringLiteral("kuebler-esc-rs485")));
        buses.add(line);
        pass(500);
    }
    ~WizardLine() override { buses.remove(&line); }

    void pass(int milliseconds)
    {
        for (; milliseconds > 0; milliseconds -= 33)
            line.advance(std::chrono::milliseconds(33));
    }
    EncoderSession &encoder() { return *line.encoder(place); }
    void toValues(const ParameterValues &values = {})
    {
        wizard.setEncoder(&encoder());
        next();
        click("readAll");
        pass(4000);
        next();
        for (const ParameterValue &value : values)
            wanted.set(place, value.parameter, value.value);
        next();
    }
    QStringList plannedRequests() const
    {
        const QAbstractItemModel &model = *find<QTableView>("plannedWords")->model();
        QStringList requests;
        for (int row = 0; row < model.rowCount(); ++row)
            requests.append(model.index(row, 1).data().toString());
        return requests;
    }

    std::shared_ptr<SimulatedEscLine> simulated = std::make_shared<SimulatedEscLine>();
    EscLineSession line{std::make_unique<SimulatedEscLineLink>(simulated), catalog,
                        QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC), makeRequestDriver};
};

TEST_F(WizardLine, ItsEncodersStandBehindThoseOfTheRing)
{
    wizard.setEncoder(&encoder());
    auto *list = find<QListWidget>("encoders");
    EXPECT_TRUE(list->item(list->count() - 1)->text().startsWith(QStringLiteral("esc:05")));
    EXPECT_TRUE(isEnabled("wizardNext"));
}

TEST_F(WizardLine, StepsPerTurnMakeTheRange)
{
    toValues({{Parameter::steps, 360}, {Parameter::scaling, 1}});
    EXPECT_TRUE(text("scaleText").contains(QStringLiteral("360"))) << text("scaleText").toStdString();
    EXPECT_TRUE(text("scaleText").contains(QLocale().toString(360 * 4096)));
}

// The simulated encoder has its scaling off, as delivered.
TEST_F(WizardLine, StepsThatDoNotActMakeNoRangeAndEachPageSaysSo)
{
    toValues({{Parameter::steps, 500}});
    EXPECT_EQ(text("scaleText"), QStringLiteral("Resolution 8192 steps per turn, total range %1 steps over "
                                                "%2 turns.")
                                     .arg(QLocale().toString(33'554'432), QLocale().toString(4096)));
    EXPECT_TRUE(find<InlineMessage>("scaleWarning")->sentence().contains(QStringLiteral("Scaling is off")));
    next();
    EXPECT_TRUE(text("reviewNotes").contains(QStringLiteral("Scaling is off")));
    click("byItself");
    next();
    pass(5000);
    ASSERT_FALSE(wizard.isBusy());
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 500);
    EXPECT_TRUE(text("leftIn").contains(QStringLiteral("Scaling is off"))) << text("leftIn").toStdString();
    next();
    EXPECT_TRUE(find<QPlainTextEdit>("account")->toPlainText().contains(QStringLiteral("Not in force")));
}

// Manual, GR: "Number of revolutions is 4096".
TEST_F(WizardLine, StepsWarnOfTheRevolutionsTheySet)
{
    simulated->withEncoder({5}, [](SimulatedEscEncoder &one) {
        for (const char byte : QByteArray("\x1B"
                                          "05GM0010\r\n"))
            one.hear(byte);
    });
    toValues({{Parameter::steps, 360}});
    const auto warning = [this] { return find<InlineMessage>("scaleWarning")->sentence(); };
    EXPECT_TRUE(warning().contains(QStringLiteral("sets its revolutions to"))) << warning().toStdString();
    type("revolutions", "16");
    leaveField();
    EXPECT_FALSE(warning().contains(QStringLiteral("sets its revolutions to")));
}

TEST_F(WizardLine, AFieldThatIsTypedInOutlivesItsEncoder)
{
    toValues();
    type("steps", "360");
    EXPECT_TRUE(line.remove(place));
    if (QWidget *field = QApplication::focusWidget())
        field->clearFocus();
    EXPECT_FALSE(wizard.isBusy());
}

TEST_F(WizardLine, RequestsAreReviewedSentAndReadBack)
{
    toValues({{Parameter::upperLimit, 0x2000}});
    next();
    const QStringList requests = plannedRequests();
    EXPECT_TRUE(requests.contains(QStringLiteral("05GH00002000"))) << requests.join(u' ').toStdString();
    click("byItself");
    next();
    pass(4000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(encoder().known(Parameter::upperLimit)->value, 0x2000);
    EXPECT_EQ(encoder().known(Parameter::upperLimit)->evidence, Evidence::read);
}

TEST_F(WizardLine, ThePositionIsSetWithinTheRangeOfTheEncoder)
{
    toValues();
    const ParameterDescription position = positionToSet(encoder());
    EXPECT_EQ(position.minimum, 1);
    EXPECT_EQ(position.maximum, 33'554'431);
    click("initialisePreset");
    type("positionToSet", "0");
    EXPECT_FALSE(isEnabled("wizardNext"));
    type("positionToSet", "1000");
    next();
    EXPECT_TRUE(plannedRequests().contains(QStringLiteral("05GP000003E8")));
    click("byItself");
    next();
    pass(4000);
    EXPECT_EQ(encoder().latest().position, 1000);
    next();
    const QString report = find<QPlainTextEdit>("account")->toPlainText();
    EXPECT_TRUE(report.contains(QStringLiteral("1234340 (12D5A4h)"))) << report.toStdString();
    EXPECT_TRUE(report.contains(
        QRegularExpression(QStringLiteral("Position set to: +%1\n").arg(QLocale().toString(1000)))));
}

// Those of its second job, too.
TEST_F(WizardLine, TheHandshakeListsAllItsRequestsFromTheBeginning)
{
    toValues({{Parameter::upperLimit, 0x2000}});
    click("initialisePreset");
    type("positionToSet", "1000");
    next();
    const QStringList requests = plannedRequests();
    next();
    pass(200);
    const QAbstractItemModel &model = *find<QTableView>("steps")->model();
    QStringList listed;
    for (int row = 0; row < model.rowCount(); ++row)
        listed.append(model.index(row, 1).data().toString());
    EXPECT_EQ(listed, requests);
    click("runByItself");
    pass(4000);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_EQ(encoder().latest().position, 1000);
    EXPECT_FALSE(states().contains(QString())) << states().join(u' ').toStdString();
}

TEST_F(WizardLine, DirectionAndRangeAreThoseOfItsManual)
{
    wizard.setEncoder(&encoder());
    ASSERT_TRUE(encoder().start(ReadParameters{encoder().device().readableValues()}));
    pass(4000);
    EXPECT_EQ(positionRange(encoder()), (PositionRange{0, 33'554'431}));
    const auto scale = scaleOf(encoder().device(),
                               [this](Parameter parameter) { return knownNumber(encoder(), parameter); });
    ASSERT_TRUE(scale);
    EXPECT_EQ(scale->total(), 33'554'432);
    EXPECT_DOUBLE_EQ(scale->resolution(), 8192);
    EXPECT_TRUE(scale->clockwise);
}

// The project may contain a direction from a description that knew it.
TEST_F(WizardLine, ADirectionThatItsDescriptionDoesNotKnowTellsNoScale)
{
    DeviceDescription device = encoder().device();
    const auto anyValue = [](Parameter) { return std::optional<std::int64_t>(1); };
    EXPECT_TRUE(scaleOf(device, anyValue));
    std::erase_if(device.parameters,
                  [](const ParameterDescription &one) { return one.parameter == Parameter::direction; });
    EXPECT_FALSE(scaleOf(device, anyValue));
}

TEST_F(WizardLine, WhatFollowsANewAddressIsPlannedForIt)
{
    toValues({{Parameter::lineAddress, 7}});
    click("initialisePreset");
    type("positionToSet", "1000");
    next();
    const QStringList requests = plannedRequests();
    const auto moved = requests.indexOf(QStringLiteral("05X07"));
    ASSERT_GE(moved, 0) << requests.join(u' ').toStdString();
    EXPECT_GT(requests.indexOf(QStringLiteral("07P")), moved) << requests.join(u' ').toStdString();
    EXPECT_GT(requests.indexOf(QStringLiteral("07GP000003E8")), moved);
    for (auto row = moved + 1; row < requests.size(); ++row)
        EXPECT_TRUE(requests[row].startsWith(QStringLiteral("07"))) << requests[row].toStdString();
}

class WizardLineCancel : public WizardLine
{
protected:
    // Steps 360 by hand, with 16 revolutions before; until the steps are written.
    void begin()
    {
        simulated->withEncoder({5}, [](SimulatedEscEncoder &one) {
            for (const char byte : QByteArray("\x1B"
                                              "05GM0010\r\n"))
                one.hear(byte);
        });
        toValues({{Parameter::steps, 360}});
        next();
        next();
        pass(500);
        writesBefore = encoder().eepromWrites();
        while (encoder().eepromWrites() == writesBefore && isEnabled("nextStep")) {
            click("nextStep");
            pass(500);
        }
    }
    int writesBefore = 0;
};

TEST_F(WizardLineCancel, AsManyWritesAreAnnouncedAsRestoringTakes)
{
    begin();
    const int before = encoder().eepromWrites();
    ASSERT_EQ(before, writesBefore + 1);
    const auto question = test::Question::answeredBy(QStringLiteral("Restore"));
    click("wizardCancel");
    pass(4000);
    ASSERT_FALSE(wizard.isBusy());
    EXPECT_EQ(encoder().eepromWrites() - before, 3) << "steps, revolutions, and the factor";
    EXPECT_TRUE(question.text().contains(
        QStringLiteral("Restore writes the earlier values again. EEPROM writes for that: 3 at most.")))
        << question.text().toStdString();
    EXPECT_EQ(encoder().known(Parameter::revolutions)->value, 16);
}

TEST_F(WizardLineCancel, ThePositionItShowsIsThatOfNow)
{
    begin();
    simulated->withEncoder({5}, [](SimulatedEscEncoder &one) { one.shaft().turnBy(1'000); });
    pass(500);
    QString first;
    QString later;
    const auto asked = [](const QWidget &dialog) {
        QString text;
        for (const auto *label : dialog.findChildren<QLabel *>())
            text += label->text();
        return text;
    };
    const auto shown = [this] {
        return QStringLiteral("It shows %1 now.")
            .arg(QLocale().toString(qlonglong{*encoder().latest().position}));
    };
    const test::Question question([&](QWidget &dialog) {
        first = asked(dialog);
        EXPECT_TRUE(first.contains(shown())) << first.toStdString();
        simulated->withEncoder({5}, [](SimulatedEscEncoder &one) { one.shaft().turnBy(1'000); });
        pass(500);
        later = asked(dialog);
        EXPECT_TRUE(later.contains(shown())) << later.toStdString();
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    click("wizardCancel");
    EXPECT_NE(first, later);
}

} // namespace
} // namespace codewheel
