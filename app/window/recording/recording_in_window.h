// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/recording/recording_subjects.h"
#include "widgets/recording/shown_recording.h"

#include <QPointer>

class QAction;
class QMainWindow;

namespace codewheel {

class EncoderScales;
class InlineMessage;
class Plant;
class ProjectDocument;
class RecordingDetails;
class RecordingEstimate;
class RecordingIndicator;
class StatusLine;
class TrendPage;
class WindowSettings;

// The recording of the plant in the window: begins one, shows that it runs, and asks before the program is
// quit.
class RecordingInWindow : public QObject
{
    Q_OBJECT

public:
    // All outlive it.
    struct Parts
    {
        Plant &plant;
        ProjectDocument &project;
        WindowSettings &settings;
        QAction &record;
        StatusLine &status;
        TrendPage &trend;
        InlineMessage &notice;
    };

    RecordingInWindow(const Parts &parts, QMainWindow *window);

    // Whether the recording that runs may be ended for quitting.
    bool mayEnd();
    // For a window that is rebuilt: whether more about the recording is shown, and to show it again.
    bool showsDetails() const;
    void openDetails();

private:
    void record();
    void showRecording();
    std::optional<ShownRecording> shown() const;
    RecordingSubjects subjects(RecordingEstimate &estimate) const;
    std::vector<RecordableEncoder> encoders() const;
    std::vector<TrackScale> scalesOf(Place place, const EncoderScales &scales) const;

    const Parts m_parts;
    QMainWindow &m_window;
    RecordingIndicator *m_indicator;
    QPointer<RecordingDetails> m_details;
};

} // namespace codewheel
