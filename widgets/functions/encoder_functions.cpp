// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/encoder_functions.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "jobs/protocol.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/functions/function_questions.h"
#include "widgets/look/describe.h"
#include "widgets/look/icons.h"

#include <QWidget>

namespace codewheel {
namespace {

const SetPreset manufacturerPreset{{}, PresetCommand::manufacturer};

void describeAction(QAction &action, const char *name, const QString &what, const QKeySequence &key = {})
{
    action.setObjectName(QLatin1String(name));
    action.setStatusTip(what);
    action.setShortcut(key);
    action.setAutoRepeat(false); // what is sent to an encoder is sent once for each press
    action.setToolTip(
        key.isEmpty() ? what : QStringLiteral("%1 (%2)").arg(what, key.toString(QKeySequence::NativeText)));
}

} // namespace

EncoderFunctions::EncoderFunctions(const Buses &buses, QWidget *window)
    : QObject(window)
    , m_buses(buses)
    , m_window(window)
    , m_isInPositionMode(new QAction(tr("It &is in position mode"), this))
    , m_position(new QAction(tr("P&osition mode"), this))
    , m_velocity(new QAction(this))
    , m_frabaPreset(new QAction(lineIcon(Icon::preset), tr("FRABA &preset…"), this))
    , m_reset(new QAction(tr("Reset to &factory settings…"), this))
{
    m_position->setCheckable(true);
    m_velocity->setCheckable(true);
    describeAction(*m_isInPositionMode, "isInPositionMode",
                   tr("Only if you are sure: in cam mode, the word that sets the position sets a cam. "
                      "Nothing is sent."));
    describeAction(*m_position, "positionMode",
                   tr("The encoder sends its position; ends velocity and cam mode"),
                   Qt::CTRL | Qt::SHIFT | Qt::Key_M);
    describeAction(*m_velocity, "velocityMode",
                   tr("The encoder sends its speed in revolutions per minute instead of its position"),
                   Qt::CTRL | Qt::SHIFT | Qt::Key_V);
    foundBy(m_frabaPreset, tr("set the position, zero, zero point"));
    describeAction(*m_reset, "resetToDefault", tr("Shows what is lost, and asks first"));
    connect(m_isInPositionMode, &QAction::triggered, this, &EncoderFunctions::tellPositionMode);
    connect(m_position, &QAction::triggered, this, &EncoderFunctions::goToPositionMode);
    connect(m_velocity, &QAction::triggered, this, &EncoderFunctions::goToVelocityMode);
    connect(m_frabaPreset, &QAction::triggered, this, &EncoderFunctions::setToPreset);
    connect(m_reset, &QAction::triggered, this, &EncoderFunctions::reset);
    describeFrabaPreset();
    show();
}

void EncoderFunctions::setEncoder(EncoderSession *encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    m_resetJob.reset();
    m_switchJob.reset();
    describeFrabaPreset();
    if (encoder != nullptr) {
        connect(encoder, &EncoderSession::latestChanged, this, &EncoderFunctions::show);
        connect(encoder, &EncoderSession::jobStarted, this, &EncoderFunctions::show);
        connect(encoder, &EncoderSession::finished, this, &EncoderFunctions::finished);
        connect(encoder, &QObject::destroyed, this, &EncoderFunctions::show);
    }
    show();
}

QString EncoderFunctions::modeNow() const
{
    const Reading reading = m_encoder ? m_encoder->latest() : Reading();
    return reading.mode ? modeText(*reading.mode, reading.camProgram) : tr("not known", "mode");
}

void EncoderFunctions::show()
{
    const Capabilities can = m_encoder ? m_encoder->can() : Capabilities{};
    const bool hasModes = m_encoder && m_encoder->device().quirks.hasModes;
    const auto mode = m_encoder ? m_encoder->latest().mode : std::nullopt;
    const bool isFree = m_encoder && !m_encoder->runningJob();
    m_isInPositionMode->setVisible(m_encoder && m_encoder->device().mayHaveModes() && !mode);
    m_position->setVisible(hasModes);
    m_velocity->setVisible(can.velocity);
    m_frabaPreset->setVisible(m_encoder && m_encoder->device().capabilities.manufacturerPreset);
    m_reset->setVisible(can.resets);
    for (QAction *action : actions())
        action->setEnabled(isFree && action->isVisible());
    m_frabaPreset->setEnabled(m_frabaPreset->isEnabled() && can.manufacturerPreset);
    m_position->setChecked(mode == Mode::position);
    m_velocity->setChecked(mode == Mode::velocity);
    m_velocity->setText(tr("&Velocity mode (now: %1)").arg(modeNow()));
}

// Of a gateway, it is shown with the reason why it cannot be sent.
void EncoderFunctions::describeFrabaPreset()
{
    const bool linkForbidsIt = m_encoder && m_encoder->device().capabilities.manufacturerPreset &&
                               !m_encoder->can().manufacturerPreset;
    describeAction(*m_frabaPreset, "frabaPreset",
                   !linkForbidsIt
                       ? tr("Sets the position to the programmed preset, as often as wanted; asks first")
                       : refusalText({RefusalKind::notSupported,
                                      RefusalId::linkDoesNotBoundCycles,
                                      {firstWord(manufacturerPreset)}}),
                   Qt::CTRL | Qt::SHIFT | Qt::Key_P);
}

void EncoderFunctions::tellPositionMode()
{
    codewheel::tellPositionMode(*m_encoder);
}

bool EncoderFunctions::isRefusedInWatch()
{
    const Place place = m_encoder ? m_encoder->place() : Place();
    const EncoderBus *bus = m_buses.busOf(place);
    if (bus == nullptr || bus->isOperating())
        return false;
    Q_EMIT refused({RefusalKind::busy, RefusalId::watchOnly, {place.shown()}});
    return true;
}

void EncoderFunctions::goToPositionMode()
{
    show(); // the tick follows the encoder, not the click
    const auto mode = m_encoder->latest().mode;
    if (mode == Mode::position || isRefusedInWatch() ||
        (mode == Mode::cam && !askToLeaveCamMode(m_window, *m_encoder)))
        return;
    start(SwitchMode{Mode::position});
}

void EncoderFunctions::goToVelocityMode()
{
    show();
    if (isRefusedInWatch())
        return;
    const auto mode = m_encoder->latest().mode;
    if (mode == Mode::velocity)
        start(SwitchMode{Mode::position});
    else if (mode != Mode::cam || askToLeaveCamMode(m_window, *m_encoder))
        startInPositionMode(SwitchMode{Mode::velocity});
}

void EncoderFunctions::setToPreset()
{
    if (!isRefusedInWatch() && askForFrabaPreset(m_window, *m_encoder))
        startInPositionMode(manufacturerPreset);
}

void EncoderFunctions::reset()
{
    if (!isRefusedInWatch() && askForReset(m_window, *m_encoder))
        m_resetJob = start(ResetToDefault{});
}

// In position mode.
Word EncoderFunctions::firstWord(const Job &job) const
{
    const DeviceDescription &device = m_encoder->device();
    return protocolOf(device).firstWord(device, job);
}

// Asks for the mode if it is not known.
void EncoderFunctions::startInPositionMode(const Job &job)
{
    if (!m_encoder)
        return;
    if (m_encoder->latest().mode) {
        start(job);
        return;
    }
    switch (askForMode(m_window, *m_encoder, firstWord(job))) {
    case ModeAnswer::isInPositionMode:
        tellPositionMode();
        start(job);
        break;
    case ModeAnswer::switchFirst:
        m_next = job;
        m_switchJob = start(SwitchMode{Mode::position});
        break;
    case ModeAnswer::cancel:
        break;
    }
}

std::optional<JobId> EncoderFunctions::start(const Job &job)
{
    if (!m_encoder || !askForEeprom(m_window, *m_encoder, job)) // gone meanwhile, or refused
        return std::nullopt;
    const auto started = m_encoder->start(job);
    if (started)
        return *started;
    Q_EMIT refused(started.error());
    return std::nullopt;
}

void EncoderFunctions::finished(const Outcome &outcome)
{
    show();
    if (m_switchJob != outcome.job)
        return;
    m_switchJob.reset();
    if (outcome.result)
        start(m_next);
}

} // namespace codewheel
