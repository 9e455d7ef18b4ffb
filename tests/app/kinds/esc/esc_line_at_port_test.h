// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/kinds/esc/esc_line_at_work.h"
#include "tests/app/planned_encoder.h"
#include "tests/app/press_connect.h"
#include "tests/app/window_test.h"
#include "tests/support/plans.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/port_field.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QWidget>

#include <vector>

namespace codewheel::test {

// The window with a project that has encoders on a serial line, and at the other end of the port
// tests/kinds/esc/line/esc_peer.py, which knows nothing of this program. In real time.
class EscLineAtPortTest : public WindowTest
{
protected:
    EscLineAtPortTest()
    {
        shown->line().setPortList([] { return std::vector<PortInfo>(); });
        advance(100);
    }
    ~EscLineAtPortTest() override
    {
        shown->line().close();
        for (const auto &peer : m_peers) {
            peer->closeWriteChannel();
            EXPECT_TRUE(peer->waitForFinished(60'000));
        }
    }

    // Gives the project this line, as if it had been opened from a file.
    void plan(const EscLinePlan &line, const std::vector<ProjectDevice> &encoders = {})
    {
        Project planned = project();
        setLinePlan(planned, firstLine, line);
        setEncodersOnLine(planned, encoders);
        shown->project().setProject(planned, {});
    }
    void plan(const std::vector<ProjectDevice> &encoders)
    {
        EscLinePlan line;
        line.settings.pollInterval = std::chrono::milliseconds(100);
        plan(line, encoders);
    }
    Project project() { return shown->project().project(); }

    // Starts encoders on a pseudo terminal and returns its path.
    QString startPeer(const QString &options)
    {
        QProcess &peer = *m_peers.emplace_back(std::make_unique<QProcess>());
        peer.start(QStringLiteral(CODEWHEEL_PYTHON),
                   QStringList{QStringLiteral(CODEWHEEL_ESC_PEER)} + options.split(u' ', Qt::SkipEmptyParts));
        while (!peer.canReadLine())
            if (!peer.waitForReadyRead(60'000)) {
                ADD_FAILURE() << peer.readAllStandardError().toStdString();
                return {};
            }
        return QString::fromLocal8Bit(peer.readLine()).trimmed();
    }

    ConnectPage &connection() { return *window().findChild<ConnectPage *>(QStringLiteral("lineSettings")); }
    EscLineSettingsForm &form() { return *window().findChild<EscLineSettingsForm *>(); }
    EscLineSession &line() { return *shown->line().session(); }
    void click(const QWidget &in, const QString &text)
    {
        for (auto *found : in.findChildren<QPushButton *>())
            if (plainLabel(found->text()) == text && found->isVisibleTo(&in)) {
                EXPECT_TRUE(found->isEnabled()) << text.toStdString();
                QTest::mouseClick(found, Qt::LeftButton);
                advance(50);
                return;
            }
        ADD_FAILURE() << text.toStdString();
    }
    QMessageBox *operateQuestion()
    {
        return window().findChild<QMessageBox *>(QStringLiteral("operateQuestion"));
    }
    // Of the chosen bus; agrees that it is real.
    void operate()
    {
        actions().operate->trigger();
        if (operateQuestion() != nullptr)
            click(*operateQuestion(), QStringLiteral("Operate"));
    }
    // As the user types it.
    void typePort(const QString &port)
    {
        lineActions().settings->trigger();
        chooseSerialPort(connection());
        auto *field = form().findChild<PortField *>()->findChild<QComboBox *>()->lineEdit();
        field->selectAll();
        QTest::keyClicks(field, port);
    }
    void connectNow()
    {
        pressConnect(connection());
        EXPECT_TRUE(QTest::qWaitFor([this] { return !shown->line().isOpening(); }));
    }
    void connectPort(const QString &port)
    {
        typePort(port);
        connectNow();
    }
    // All texts of the form, apart from the note that this computer has no ports.
    QString said()
    {
        QStringList sentences;
        for (const auto *message : connection().findChildren<InlineMessage *>())
            if (message->isVisibleTo(&connection()) &&
                !message->sentence().startsWith(QStringLiteral("This computer has no")))
                sentences << message->sentence();
        return sentences.join(u'\n');
    }
    template <typename Condition>
    bool comes(Condition condition)
    {
        return QTest::qWaitFor(
            [&] {
                advance(33);
                return condition();
            },
            20'000);
    }
    bool answers(Place number)
    {
        return comes([&] {
            const EncoderSession *encoder = line().encoder(number);
            return encoder != nullptr && encoder->latest().state == EncoderState::operation;
        });
    }

private:
    std::vector<std::unique_ptr<QProcess>> m_peers;
};

} // namespace codewheel::test
