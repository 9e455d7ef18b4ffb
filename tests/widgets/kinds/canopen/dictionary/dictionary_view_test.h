// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/log_table.h"

#include <QAction>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

namespace codewheel::test {

// As a maker writes it: an object of his own that can only be written, and limits.
inline const QByteArray rotorFile =
    "[DeviceInfo]\nVendorName=Rotor Works\n"
    "[OptionalObjects]\nSupportedObjects=4\n1=0x6001\n2=0x6004\n3=0x1010\n4=0x6503\n"
    "[ManufacturerObjects]\nSupportedObjects=1\n1=0x2300\n"
    "[1010]\nObjectType=9\nSubNumber=1\n"
    "[1010sub1]\nParameterName=Save all\nDataType=7\nAccessType=rw\n"
    "[2300]\nParameterName=Save and reset\nDataType=5\nAccessType=wo\n"
    "[6001]\nParameterName=Units\nDataType=7\nAccessType=rw\nDefaultValue=1000\n"
    "HighLimit=8192\n"
    "[6004]\nParameterName=Position\nDataType=7\nAccessType=ro\n"
    "[6503]\nParameterName=Alarms\nDataType=6\nAccessType=ro\n";

// The objects of the nodes of the training plant, by hand.
class DictionaryViewTest : public CanopenPlant
{
protected:
    DictionaryViewTest()
    {
        view.resize(1'000, 500);
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
        view.setBus(bus.get());
    }
    void pass(Instant time)
    {
        for (Instant passed{}; passed < time; passed += 20ms) {
            bus->advance(20ms);
            QCoreApplication::processEvents();
        }
    }
    QString fileOf(const QByteArray &bytes, const char *name = "rotor.eds")
    {
        const QString path = folder.filePath(QLatin1String(name));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return path;
    }
    int rowOf(const char *object) const
    {
        for (int row = 0; row < table->model()->rowCount(); ++row)
            if (cell(row, ObjectModel::object) == QLatin1String(object))
                return row;
        return -1;
    }
    QString cell(int row, int column) const { return table->model()->index(row, column).data().toString(); }
    QString valueOf(const char *object) const { return cell(rowOf(object), ObjectModel::value); }
    void choose(const char *object) const
    {
        ASSERT_GE(rowOf(object), 0) << object;
        table->setCurrentIndex(table->model()->index(rowOf(object), 0));
    }
    QAction *action(const char *text) const
    {
        for (QAction *each : view.actions())
            if (each->text() == QString::fromUtf8(text))
                return each;
        ADD_FAILURE() << text;
        return nullptr;
    }
    // As far as the question.
    void enter(const char *value)
    {
        field->setText(QString::fromUtf8(value));
        QTest::keyClick(field, Qt::Key_Return);
        pass(200ms);
    }
    void answer(const QString &text)
    {
        QTest::qWait(400); // a question takes no click at once
        for (auto *button : question->findChildren<QPushButton *>())
            if (button->text() == text)
                QTest::mouseClick(button, Qt::LeftButton);
        pass(400ms);
    }

    QTemporaryDir folder;
    DictionaryView view;
    LogTable *table = view.findChild<LogTable *>();
    QLineEdit *field = view.findChild<QLineEdit *>(QStringLiteral("objectNewValue"));
    QPushButton *write = view.findChild<QPushButton *>(QStringLiteral("objectWrite"));
    InlineMessage *question = view.findChild<InlineMessage *>(QStringLiteral("objectWriteQuestion"));
    InlineMessage *written = view.findChild<InlineMessage *>(QStringLiteral("objectWriteMessage"));
    InlineMessage *message = view.findChild<InlineMessage *>(QStringLiteral("objectsMessage"));
};

} // namespace codewheel::test
