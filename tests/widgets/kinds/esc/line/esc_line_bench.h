// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/esc/line/esc_line_session.h"
#include "tests/kinds/esc/line/scripted_line.h"
#include "widgets/look/label_text.h"

#include <QAction>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel::test {

inline QByteArray wire(const char *text)
{
    return QByteArray("\x1B") + text + "\r\n";
}

// A line in virtual time with an encoder at 05 that answers requests for position, serial number and preset.
struct EscLineBench
{
    EscLineBench()
    {
        auto made = std::make_unique<ScriptedLink>();
        link = made.get();
        link->answers = {{wire("05P"), "\r\n00001235\r\n"},
                         {wire("05N"), "\r\n0BADCAFE\r\n"},
                         {wire("05B"), "\r\n9000\r\n"},
                         {wire("05V"), "\r\nENCODER V1.23\r\n"},
                         {wire("05GP00005200"), "\r\n"}};
        line = std::make_unique<EscLineSession>(
            std::move(made), catalog, QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
            [](const DeviceDescription &, EscLineAddress address) {
                return std::make_unique<PollingDriver>(address, std::chrono::milliseconds(10));
            });
    }
    void open(EscLineSession::Start start = EscLineSession::Start::watching)
    {
        ASSERT_TRUE(line->open({}, {}, start, EscLineSession::Drive::byHand));
    }
    void addEncoder() { ASSERT_TRUE(line->add({5}, QStringLiteral("kuebler-esc-rs485"))); }
    // Pumps the line as the window does.
    void pass(int milliseconds)
    {
        constexpr int step = 20;
        for (int passed = 0; passed < milliseconds; passed += step)
            line->advance(std::chrono::milliseconds(std::min(step, milliseconds - passed)));
    }

    const Catalog catalog = Catalog::builtIn();
    ScriptedLink *link = nullptr;
    std::unique_ptr<EscLineSession> line;
};

// As the user finds it: by its text, without the mnemonic.
inline QPushButton *button(const QWidget &in, const QString &text)
{
    for (auto *found : in.findChildren<QPushButton *>())
        if (plainLabel(found->text()) == text && found->isVisibleTo(&in))
            return found;
    return nullptr;
}

inline QAction *action(const QWidget &in, const QString &text)
{
    for (QAction *found : in.actions())
        if (found->text() == text)
            return found;
    return nullptr;
}

// Every control has a name and a tooltip, and can be reached by keyboard.
inline void expectAccessible(const QWidget &view)
{
    int checked = 0;
    for (const auto *found : view.findChildren<QPushButton *>()) {
        if (found->text().isEmpty() || found->isHidden())
            continue;
        ++checked;
        EXPECT_FALSE(found->toolTip().isEmpty()) << found->text().toStdString();
        EXPECT_NE(found->focusPolicy(), Qt::NoFocus) << found->text().toStdString();
    }
    EXPECT_GT(checked, 0);
}

} // namespace codewheel::test
