// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/leaving.h"

#include "encoder/hex.h"
#include "ring/bus_session.h"
#include "ring/word_channel.h"
#include "widgets/models/connected_encoders.h"
#include "widgets/wizard/cancel_question.h"

#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace codewheel {
Leaving::Leaving(QWidget &window)
    : QObject(&window)
    , m_window(window)
{}

void Leaving::setEncoders(ConnectedEncoders &connected)
{
    m_connected = &connected;
    connect(&connected, &ConnectedEncoders::changed, this, &Leaving::watch);
    connect(&connected.bus(), &BusSession::updated, this, [this] {
        if (m_waitsForZero)
            goOn();
    });
    watch();
}

// Sessions come and go with the connections.
void Leaving::watch()
{
    std::erase(m_watched, nullptr);
    const auto isWatched = [this](const EncoderSession *encoder) {
        return std::ranges::any_of(m_watched, [encoder](const auto &watched) { return watched == encoder; });
    };
    for (const DeviceNumber number : m_connected->numbers()) {
        EncoderSession *encoder = m_connected->encoder(number);
        if (encoder == nullptr || isWatched(encoder))
            continue;
        m_watched.emplace_back(encoder);
        connect(encoder, &EncoderSession::progressed, this,
                [this, encoder](const Progress &progress) { takeProgress(*encoder, progress); });
        connect(encoder, &EncoderSession::finished, this, [this, encoder] {
            m_progress.erase(encoder->number());
            if (m_cancelled == encoder)
                m_cancelled = nullptr;
            QTimer::singleShot(0, this, &Leaving::goOn);
        });
    }
}

// An encoder that had taken something before it heard of the cancel: how shall it be left?
void Leaving::takeProgress(const EncoderSession &encoder, const Progress &progress)
{
    m_progress[encoder.number()] = progress;
    if (m_cancelled != &encoder || !progress.hasTaken)
        return;
    m_cancelled = nullptr;
    QTimer::singleShot(0, this, &Leaving::goOn);
}

void Leaving::ask(Why why, std::function<void()> then)
{
    m_why = why;
    m_then = std::move(then);
    m_outAnswered = false;
    m_waitsForZero = false;
    goOn();
}

// Called again each time something that was waited for has happened.
void Leaving::goOn()
{
    if (!m_then)
        return;
    if (EncoderSession *encoder = busyEncoder()) {
        if (!endJob(*encoder))
            stay();
        return; // finished() comes back here
    }
    if (const BusSession &bus = m_connected->bus(); bus.isOpen() && m_why != Why::disconnectLine) {
        const std::vector<DeviceNumber> devices = bus.devicesWithOut();
        if (!devices.empty() && m_waitsForZero && bus.isRunning())
            return; // updated() comes back here
        if (!devices.empty() && !m_outAnswered && !askForOut(devices))
            return;
    }
    m_waitsForZero = false;
    std::exchange(m_then, nullptr)();
}

// Ring and line are left one by one, and both by quitting.
bool Leaving::concerns(DeviceNumber number) const
{
    return m_why == Why::quit || number.isOnLine() == (m_why == Why::disconnectLine);
}

EncoderSession *Leaving::busyEncoder() const
{
    for (const DeviceNumber number : m_connected->numbers())
        if (EncoderSession *encoder = m_connected->encoder(number);
            concerns(number) && encoder != nullptr && encoder->runningJob())
            return encoder;
    return nullptr;
}

bool Leaving::endJob(EncoderSession &encoder)
{
    const Progress progress = m_progress[encoder.number()];
    if (!progress.hasTaken) {
        m_cancelled = &encoder;
        encoder.cancel(OnCancel::ifNothingTaken);
        return true;
    }
    const auto how = askHowToCancel(&m_window, encoder, situationOf(encoder, progress));
    if (how && encoder.runningJob())
        encoder.cancel(*how);
    return how.has_value() || !encoder.runningJob();
}

// True: go on now. False: the user stays, or the zeros are on their way.
bool Leaving::askForOut(const std::vector<DeviceNumber> &devices)
{
    BusSession &bus = m_connected->bus();
    QStringList words;
    for (const DeviceNumber number : devices)
        words.append(tr("OUT %1 is %2").arg(number.toString(), hexWord(bus.channel(number)->out())));
    const QString title = m_why == Why::quit         ? tr("Quit Codewheel")
                          : m_why == Why::disconnect ? tr("Disconnect")
                                                     : tr("Stop the bus");
    QMessageBox box(QMessageBox::Question, title, tr("Not all OUT words are 00000000."),
                    QMessageBox::NoButton, &m_window);
    box.setInformativeText(words.join(u'\n') + QStringLiteral("\n\n") +
                           tr("Shall they be set to 00000000 (normal running) first?"));
    const bool canSend = bus.isRunning() && bus.isOperating();
    QPushButton *zero = box.addButton(tr("Set to &00000000"), QMessageBox::AcceptRole);
    zero->setEnabled(canSend);
    zero->setToolTip(canSend ? tr("Sends 00000000 to these devices, then goes on")
                             : tr("Nothing can be sent now: the bus is stopped, or in Watch"));
    QPushButton *leave = box.addButton(tr("&Leave as they are"), QMessageBox::DestructiveRole);
    leave->setToolTip(tr("Goes on without sending anything"));
    QPushButton *cancel = box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(canSend ? zero : cancel);
    box.exec();

    if (box.clickedButton() == leave) {
        m_outAnswered = true;
        return true;
    }
    if (box.clickedButton() != zero) {
        stay();
        return false;
    }
    m_outAnswered = true;
    m_waitsForZero = true;
    for (const DeviceNumber number : devices)
        bus.zeroOut(number);
    return false;
}

void Leaving::stay()
{
    m_then = nullptr;
}

} // namespace codewheel
