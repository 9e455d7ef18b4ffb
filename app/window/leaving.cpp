// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/leaving.h"

#include "encoder/hex.h"
#include "journal/eeprom_cost.h"
#include "ring/bus_session.h"
#include "ring/word_channel.h"
#include "widgets/models/device_traits.h"
#include "widgets/wizard/cancel_question.h"

#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <iterator>
#include <utility>

namespace codewheel {
namespace {

bool setsParameter(const Step &step)
{
    return takesValue(step) || (step.kind == StepKind::word && k3::isParameterWord(step.out));
}

bool isSetting(const Progress &progress)
{
    return progress.index < std::ssize(progress.steps) && !progress.waitsForUser &&
           setsParameter(progress.steps.at(static_cast<std::size_t>(progress.index)));
}

// Else cancel has nothing to deal with: OUT goes back to 0.
bool mayHaveTaken(const EncoderSession &encoder, const Progress &progress)
{
    const auto done =
        progress.steps.begin() + std::min<std::ptrdiff_t>(progress.index, std::ssize(progress.steps));
    return !progress.confirmed.empty() || isSetting(progress) ||
           encoder.latest().state == EncoderState::parameterization ||
           std::any_of(progress.steps.begin(), done, setsParameter);
}

} // namespace

Leaving::Leaving(QWidget &window)
    : QObject(&window)
    , m_window(window)
{}

void Leaving::setBus(BusSession *bus)
{
    m_progress.clear();
    if (m_bus != nullptr)
        m_bus->disconnect(this);
    m_bus = bus;
    if (bus == nullptr)
        return;
    for (const DeviceNumber number : bus->numbers()) {
        EncoderSession *encoder = bus->encoder(number);
        if (encoder == nullptr)
            continue;
        connect(encoder, &EncoderSession::progressed, this,
                [this, number](const Progress &progress) { m_progress[number] = progress; });
        connect(encoder, &EncoderSession::finished, this, [this, number] {
            m_progress.erase(number);
            QTimer::singleShot(0, this, &Leaving::goOn);
        });
    }
    connect(bus, &BusSession::updated, this, [this] {
        if (m_waitsForZero)
            goOn();
    });
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
    if (m_bus != nullptr) {
        if (EncoderSession *encoder = busyEncoder()) {
            if (!endJob(*encoder))
                stay();
            return; // finished() comes back here
        }
        const std::vector<DeviceNumber> devices = m_bus->devicesWithOut();
        if (!devices.empty() && m_waitsForZero && m_bus->isRunning())
            return; // updated() comes back here
        if (!devices.empty() && !m_outAnswered && !askForOut(devices))
            return;
    }
    m_waitsForZero = false;
    std::exchange(m_then, nullptr)();
}

EncoderSession *Leaving::busyEncoder() const
{
    for (const DeviceNumber number : m_bus->numbers())
        if (EncoderSession *encoder = m_bus->encoder(number); encoder != nullptr && encoder->runningJob())
            return encoder;
    return nullptr;
}

bool Leaving::endJob(EncoderSession &encoder)
{
    const Progress progress = m_progress[encoder.number()];
    if (!mayHaveTaken(encoder, progress)) {
        encoder.cancel(OnCancel::leaveAsIs);
        return true;
    }
    const bool isActive = progress.confirmed.empty() && !isSetting(progress) &&
                          encoder.latest().state == EncoderState::operation;
    const auto how = askHowToCancel(&m_window, encoder,
                                    {.taken = progress.confirmed,
                                     .isActive = isActive,
                                     .canRestore = progress.canRestore,
                                     .writesToRestore = mostWritesToRestore(progress),
                                     .positionNote = {}});
    if (how && encoder.runningJob())
        encoder.cancel(*how);
    return how.has_value() || !encoder.runningJob();
}

// True: go on now. False: the user stays, or the zeros are on their way.
bool Leaving::askForOut(const std::vector<DeviceNumber> &devices)
{
    QStringList words;
    for (const DeviceNumber number : devices)
        words.append(tr("OUT %1 is %2").arg(number.toString(), hexWord(m_bus->channel(number)->out())));
    const QString title = m_why == Why::quit         ? tr("Quit Codewheel")
                          : m_why == Why::disconnect ? tr("Disconnect")
                                                     : tr("Stop the bus");
    QMessageBox box(QMessageBox::Question, title, tr("Not all OUT words are 00000000."),
                    QMessageBox::NoButton, &m_window);
    box.setInformativeText(words.join(u'\n') + QStringLiteral("\n\n") +
                           tr("Shall they be set to 00000000 (normal running) first?"));
    const bool canSend = m_bus->isRunning() && m_bus->isOperating();
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
        m_bus->zeroOut(number);
    return false;
}

void Leaving::stay()
{
    m_then = nullptr;
}

} // namespace codewheel
