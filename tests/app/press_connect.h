// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/connect/connect_page.h"
#include "widgets/look/label_text.h"

#include <QComboBox>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel::test {

inline QPushButton *buttonOn(const ConnectPage &page, const QString &text)
{
    for (auto *button : page.findChildren<QPushButton *>())
        if (plainLabel(button->text()) == text && button->isVisibleTo(&page))
            return button;
    return nullptr;
}

// A line that is planned without a port is the training line.
inline void chooseSerialPort(const ConnectPage &page)
{
    auto *link = page.findChild<QComboBox *>(QStringLiteral("link"));
    ASSERT_NE(link, nullptr);
    link->setCurrentText(QStringLiteral("Serial port"));
}

// If a bus is connected, agrees that it is left.
inline void agreeToReplace(const ConnectPage &page)
{
    if (auto *agree = buttonOn(page, QStringLiteral("Disconnect and connect")))
        QTest::mouseClick(agree, Qt::LeftButton);
}

inline void pressConnect(const ConnectPage &page)
{
    auto *connect = buttonOn(page, QStringLiteral("Connect"));
    ASSERT_TRUE(connect != nullptr && connect->isEnabled());
    QTest::mouseClick(connect, Qt::LeftButton);
    agreeToReplace(page);
}

} // namespace codewheel::test
