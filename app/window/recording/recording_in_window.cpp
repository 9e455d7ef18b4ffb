// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recording/recording_in_window.h"

#include "app/window/buses/plant.h"
#include "app/window/look/status_line.h"
#include "app/window/window_settings.h"
#include "bus/bus_outline.h"
#include "catalog/device_description.h"
#include "recording/recording_estimate.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"
#include "widgets/recording/recording_details.h"
#include "widgets/recording/recording_dialog.h"
#include "widgets/recording/recording_indicator.h"
#include "widgets/trend/encoder_scales.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QTimeZone>

namespace codewheel {

RecordingInWindow::RecordingInWindow(const Parts &parts, QMainWindow *window)
    : QObject(window)
    , m_parts(parts)
    , m_window(*window)
    , m_indicator(new RecordingIndicator(window))
{
    m_parts.status.addAlways(m_indicator);
    m_parts.trend.addButtonFor(m_parts.record);
    RecordingAtWork &recording = m_parts.plant.recording();
    connect(&m_parts.record, &QAction::triggered, this, &RecordingInWindow::record);
    connect(m_indicator, &QToolButton::clicked, this, &RecordingInWindow::openDetails);
    connect(&recording, &RecordingAtWork::changed, this, &RecordingInWindow::showRecording);
    connect(&recording, &RecordingAtWork::ended, this, [this](const QString &file, const QString &size) {
        m_parts.notice.showMessage(Role::running, tr("The recording has ended: %1, %2.").arg(file, size));
    });
    showRecording();
}

std::optional<ShownRecording> RecordingInWindow::shown() const
{
    const BusRecorder *recorder = m_parts.plant.recording().recorder();
    if (recorder == nullptr)
        return {};
    return ShownRecording{.plan = recorder->plan(),
                          .waits = recorder->state() == BusRecorder::State::waiting,
                          .span = recorder->span(),
                          .status = recorder->status()};
}

void RecordingInWindow::showRecording()
{
    const auto recording = shown();
    m_indicator->showRecording(recording);
    m_parts.status.fit();
    if (m_details == nullptr)
        return;
    if (recording)
        m_details->showRecording(*recording);
    else
        m_details->close();
}

bool RecordingInWindow::showsDetails() const
{
    return m_details != nullptr && m_details->isVisible();
}

void RecordingInWindow::openDetails()
{
    const auto recording = shown();
    if (!recording)
        return;
    if (m_details == nullptr) {
        m_details = new RecordingDetails(&m_window);
        m_details->setAttribute(Qt::WA_DeleteOnClose);
        RecordingAtWork &its = m_parts.plant.recording();
        connect(m_details, &RecordingDetails::fireWanted, &its, &RecordingAtWork::fire);
        connect(m_details, &RecordingDetails::noteWanted, &its, &RecordingAtWork::note);
        connect(m_details, &RecordingDetails::endWanted, &its, &RecordingAtWork::end);
    }
    m_details->showRecording(*recording);
    m_details->show();
    m_details->raise();
    m_details->activateWindow();
}

// There is one at a time.
void RecordingInWindow::record()
{
    if (m_parts.plant.recording().recorder() != nullptr) {
        openDetails();
        m_details->tellThatItRuns();
        return;
    }
    auto *estimate = new RecordingEstimate(m_parts.plant.buses(), m_parts.plant.histories());
    auto *dialog =
        new RecordingDialog(subjects(*estimate), recordingChoices(m_parts.settings.recording()), &m_window);
    estimate->setParent(dialog);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { m_parts.settings.setRecording(toJson(dialog->choices())); });
    dialog->open();
}

RecordingSubjects RecordingInWindow::subjects(RecordingEstimate &estimate) const
{
    Plant &plant = m_parts.plant;
    RecordingSubjects subjects;
    subjects.encoders = encoders();
    subjects.now = plant.wallClock();
    for (const EncoderBus *bus : plant.buses().connected())
        subjects.buses.emplace_back(bus->id(), plant.nameOf(bus->id()));
    subjects.bytesPerSecond = [&estimate](const std::set<Place> &places, bool withTraffic) {
        return estimate.bytesPerSecond(places, withTraffic);
    };
    subjects.begin = [&plant](RecordingPlan plan) {
        plan.settings.program = QStringLiteral("Codewheel ") + QCoreApplication::applicationVersion();
        plan.settings.zone = QString::fromLatin1(QTimeZone::systemTimeZoneId());
        return plant.recording().begin(plan);
    };
    return subjects;
}

// Those that are connected, and those whose bus was closed: it may be opened again.
std::vector<RecordableEncoder> RecordingInWindow::encoders() const
{
    Plant &plant = m_parts.plant;
    EncoderScales scales(plant.buses(), plant.histories(), m_parts.trend.tracks());
    scales.look();
    std::set<Place> places;
    for (const EncoderBus *bus : plant.buses().connected())
        for (const Place place : bus->places())
            if (bus->encoder(place) != nullptr)
                places.insert(place);
    for (const Place place : plant.histories().places())
        if (plant.histories().of(place) != nullptr)
            places.insert(place);
    std::vector<RecordableEncoder> all;
    for (const Place place : places) {
        const EncoderSession *encoder = plant.buses().encoder(place);
        const EncoderHistory *history = plant.histories().of(place);
        const QString station = m_parts.project.device(place).station;
        RecordableEncoder its{
            .place = place,
            .name = station.isEmpty() ? place.shown() : QStringLiteral("%1  %2").arg(place.shown(), station),
            .what = encoder != nullptr ? encoder->device().fullName() : QString()};
        its.hasWords = plant.buses().channel(place) != nullptr ||
                       (history != nullptr && !history->of(Channel::in).isEmpty());
        its.hasCams = (encoder != nullptr && encoder->can().cams) ||
                      (history != nullptr && !history->of(Channel::cams).isEmpty());
        its.scales = scalesOf(place, scales);
        all.push_back(std::move(its));
    }
    return all;
}

std::vector<TrackScale> RecordingInWindow::scalesOf(Place place, const EncoderScales &scales) const
{
    std::vector<TrackScale> all;
    const auto add = [&](TrackUnit unit) {
        if (scales.has(place, unit) && std::ranges::find(all, unit, &TrackScale::unit) == all.end())
            all.push_back(scales.of({.track = {place, Channel::position, {}}, .unit = unit}));
    };
    for (const TrendTracks::Shown &shown : m_parts.trend.tracks().shown())
        if (shown.track.place == place && bitCount(shown.track.channel) == 0)
            add(shown.unit);
    for (const TrackUnit unit : trackUnits)
        add(unit);
    return all;
}

bool RecordingInWindow::mayEnd()
{
    const BusRecorder *recorder = m_parts.plant.recording().recorder();
    if (recorder == nullptr)
        return true;
    QMessageBox box(QMessageBox::Question, tr("Quit Codewheel"),
                    recorder->state() == BusRecorder::State::waiting
                        ? tr("A recording waits for its trigger.")
                        : tr("A recording runs."),
                    QMessageBox::NoButton, &m_window);
    setHelpTopic(box, "recording.md#while-it-runs");
    box.setInformativeText(tr("It goes to %1. What has come so far is written there before the program ends.")
                               .arg(recorder->plan().settings.file));
    QPushButton *end = box.addButton(tr("&End it and quit"), QMessageBox::AcceptRole);
    end->setToolTip(tr("Ends the recording, then goes on quitting"));
    QPushButton *stay = box.addButton(tr("&Go on recording"), QMessageBox::RejectRole);
    stay->setToolTip(tr("The window stays open (Esc)"));
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == end;
}

} // namespace codewheel
