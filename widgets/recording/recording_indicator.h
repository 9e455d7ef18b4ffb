// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/recording/shown_recording.h"

#include <QToolButton>

namespace codewheel {

// In the status line, as long as anything is recorded or waits for its trigger: how it gets on. A click opens
// more about it.
class RecordingIndicator : public QToolButton
{
    Q_OBJECT

public:
    explicit RecordingIndicator(QWidget *parent = nullptr);

    // No higher than what is beside it: a status bar has room for what is hidden, too.
    QSize sizeHint() const override;
    void showRecording(const std::optional<ShownRecording> &recording); // nothing: none, and it is hidden
};

// "Records 0:12:34, 34.1 MB", "Waits for its trigger"
QString recordingInBrief(const ShownRecording &recording);

} // namespace codewheel
