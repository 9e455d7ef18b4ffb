// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_status.h"

#include "kinds/esc/line/esc_line_session.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {

ShownStatus EscLineStatus::of(const EscLineSession &session)
{
    const EscLineSnapshot &line = session.latest();
    const QString port = session.linkName().section(QStringLiteral("/dev/"), -1);
    if (!line.connected)
        return {Role::fault, tr("%1: port is gone", "serial port").arg(port)};
    const auto numbers = session.places();
    const auto answering = std::ranges::count_if(numbers, [&session](Place number) {
        return session.encoder(number)->latest().state == EncoderState::operation;
    });
    const bool allAnswer = answering == std::ssize(numbers);
    const QString text = tr("%1, %2 Bd, %3 of %4 answer", "serial port, baud rate, encoders")
                             .arg(port, QString::number(session.settings().baudRate))
                             .arg(answering)
                             .arg(numbers.size());
    const QString figures = tr("Serial line: %1 answers, %2 time-outs, %3 garbage bytes")
                                .arg(QLocale().toString(qulonglong{line.figures.answers}),
                                     QLocale().toString(qulonglong{line.figures.timeOuts}),
                                     QLocale().toString(qulonglong{line.figures.garbageBytes}));
    return {allAnswer ? Role::running : Role::fault, text, figures};
}

} // namespace codewheel
