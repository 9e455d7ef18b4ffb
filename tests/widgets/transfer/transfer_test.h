// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/plan/project_take_over.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/project/project_document.h"

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>

namespace codewheel::test {

// A transfer page on the training bus in virtual time, used with mouse and keys as by a person.
class TransferTest : public testing::Test
{
protected:
    TransferTest()
    {
        project.setProject(projectOf(session.bus.structure()), {});
        session.encoder(fraba).tell(Parameter::startUpMode, 1);
        session.encoder(onLoop).tell(Parameter::startUpMode, 1);
        session.bus.advance(2);
    }
    void show(QWidget &page)
    {
        shown = &page;
        page.resize(700, 520);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
    }
    template <typename W>
    W *find(const char *name) const
    {
        W *found = shown->findChild<W *>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void click(const char *name)
    {
        auto *button = find<QAbstractButton>(name);
        ASSERT_TRUE(button->isEnabled()) << name;
        ASSERT_TRUE(button->isVisible()) << name;
        QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(12, button->height() / 2));
    }
    void type(const char *field, const char *text)
    {
        auto *edit = find<QLineEdit>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QString::fromLatin1(text));
    }
    QString text(const char *label) const { return find<QLabel>(label)->text(); }
    QString account() const { return find<QPlainTextEdit>("account")->toPlainText(); }
    bool isEnabled(const char *button) const { return find<QAbstractButton>(button)->isEnabled(); }
    void want(Place number, const ParameterValues &values)
    {
        project.editDevice(number, QStringLiteral("want"),
                           [&](ProjectDevice &device) { device.wanted = values; });
    }
    template <typename Page>
    void advanceWhileBusy(const Page &page)
    {
        for (int i = 0; i < 2000 && page.isBusy(); ++i)
            session.bus.advance(10);
        EXPECT_FALSE(page.isBusy());
    }

    TrainingBusSession session;
    ProjectDocument project;
    QWidget *shown = nullptr;
};

} // namespace codewheel::test
