// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_status.h"

#include "app/window/look/status_line.h"
#include "kinds/esc/line/esc_line_session.h"
#include "widgets/look/role_label.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {

EscLineStatus::EscLineStatus(StatusLine &line)
    : m_label(line.addState())
{}

EscLineStatus::~EscLineStatus()
{
    delete m_label;
}

void EscLineStatus::show(const EscLineSession *session)
{
    const bool isOpen = session != nullptr && session->isOpen();
    m_label->setVisible(isOpen);
    if (!isOpen)
        return;
    const EscLineSnapshot &line = session->latest();
    const QString port = session->linkName().section(QStringLiteral("/dev/"), -1);
    if (!line.connected) {
        m_label->setState(Role::fault, tr("%1: port is gone", "serial port").arg(port));
        return;
    }
    const auto numbers = session->places();
    const auto answering = std::ranges::count_if(numbers, [session](Place number) {
        return session->encoder(number)->latest().state == EncoderState::operation;
    });
    const bool allAnswer = answering == std::ssize(numbers);
    m_label->setState(allAnswer ? Role::running : Role::fault,
                      tr("%1, %2 Bd, %3 of %4 answer", "serial port, baud rate, encoders")
                          .arg(port, QString::number(session->settings().baudRate))
                          .arg(answering)
                          .arg(numbers.size()));
    const QString figures = tr("Serial line: %1 answers, %2 time-outs, %3 garbage bytes")
                                .arg(QLocale().toString(qulonglong{line.figures.answers}),
                                     QLocale().toString(qulonglong{line.figures.timeOuts}),
                                     QLocale().toString(qulonglong{line.figures.garbageBytes}));
    if (m_label->toolTip() != figures)
        m_label->setToolTip(figures);
}

} // namespace codewheel
