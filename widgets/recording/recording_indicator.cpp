// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recording_indicator.h"

#include "vocabulary/refusal_text.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"
#include "widgets/recording/recording_texts.h"

namespace codewheel {

RecordingIndicator::RecordingIndicator(QWidget *parent)
    : QToolButton(parent)
{
    setObjectName(QStringLiteral("recordingIndicator"));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setIconSize({grid::smallIcon, grid::smallIcon});
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    hide();
}

QSize RecordingIndicator::sizeHint() const
{
    return {QToolButton::sizeHint().width(), std::max(iconSize().height(), fontMetrics().height())};
}

void RecordingIndicator::showRecording(const std::optional<ShownRecording> &recording)
{
    setVisible(recording.has_value());
    if (!recording) {
        setMinimumWidth(0);
        return;
    }
    const bool isHeldUp = recording->status.problem.has_value();
    setIcon(isHeldUp           ? lineIcon(Icon::attention, Role::attention)
            : recording->waits ? lineIcon(Icon::record)
                               : lineIcon(Icon::record, Role::fault));
    const QString text = recordingInBrief(*recording);
    setText(text);
    setAccessibleName(text);
    const QString tip = isHeldUp ? refusalText(*recording->status.problem) : recording->plan.settings.file;
    setToolTip(tr("%1\nShows more about the recording", "file, or what is wrong").arg(tip));
    setMinimumWidth(std::max(minimumWidth(), sizeHint().width())); // its neighbours stay where they are
}

QString recordingInBrief(const ShownRecording &recording)
{
    if (recording.status.problem)
        return RecordingIndicator::tr("Recording held up");
    if (recording.waits)
        return RecordingIndicator::tr("Waits for its trigger");
    const Instant length = recording.span ? recording.status.written - recording.span->from : Instant();
    return RecordingIndicator::tr("Records %1, %2", "time, size")
        .arg(countedText(length), sizeText(recording.status.bytes));
}

} // namespace codewheel
