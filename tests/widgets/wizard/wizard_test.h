// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/app/question.h"
#include "tests/support/places.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/project/project_document.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

namespace codewheel::test {

// The wizard on the training bus in virtual time, used with mouse and keys as by a person.
class WizardTest : public testing::Test
{
protected:
    explicit WizardTest(TrainingBus (*make)(const Catalog &) = makeTrainingBus)
        : training(make(catalog))
    {
        buses.add(bus);
        EXPECT_TRUE(bus.open(RingSession::Start::operating));
        bus.advance(20);
        wizard.resize(700, 560);
        wizard.show();
        wizard.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&wizard));
    }

    EncoderSession &fraba() { return *bus.encoder("1.0"_ring); }
    EncoderSession &baumer() { return *bus.encoder("2.0"_ring); }

    template <typename W>
    W *find(const char *name) const
    {
        const QList<W *> all = wizard.findChildren<W *>(QString::fromLatin1(name));
        const auto shown = std::ranges::find_if(all, [](const W *one) { return one->isVisible(); });
        EXPECT_FALSE(all.empty()) << name;
        return shown != all.end() ? *shown : all.value(0);
    }
    void click(const char *name)
    {
        auto *button = find<QAbstractButton>(name);
        ASSERT_TRUE(button->isEnabled()) << name;
        ASSERT_TRUE(button->isVisible()) << name;
        QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(12, button->height() / 2));
    }
    void next() { click("wizardNext"); }
    void type(const char *field, const char *text)
    {
        auto *edit = find<QLineEdit>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QString::fromLatin1(text));
    }
    void leaveField() { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab); }
    QString sentence(const char *message) const { return find<InlineMessage>(message)->sentence(); }
    QString text(const char *label) const { return find<QLabel>(label)->text(); }
    bool isEnabled(const char *button) const { return find<QAbstractButton>(button)->isEnabled(); }

    // Presses Next step while the encoder answers, until the job ends or it was pressed `steps` times.
    int stepByHand(int steps = 100)
    {
        int pressed = 0;
        for (; pressed < steps && wizard.isBusy(); ++pressed) {
            bus.advance(600); // a position of 0 has to last
            if (!wizard.isBusy() || !isEnabled("nextStep"))
                break;
            click("nextStep");
        }
        bus.advance(60);
        return pressed;
    }
    // The states shown on the handshake page.
    QStringList states() const
    {
        const QAbstractItemModel &model = *find<QTableView>("steps")->model();
        QStringList states;
        for (int row = 0; row < model.rowCount(); ++row)
            states.append(model.index(row, model.columnCount() - 1).data().toString());
        return states;
    }
    Word out(Place number = "1.0"_ring) const { return bus.channel(number)->out(); }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training;
    std::shared_ptr<TrainingControls> controls = training.controls;
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC)};
    ProjectDocument project;
    WantedValues wanted{project};
    Buses buses;
    ParameterWizard wizard{buses, wanted};
};

} // namespace codewheel::test
