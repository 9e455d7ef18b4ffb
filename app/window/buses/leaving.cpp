// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/leaving.h"

#include "bus/buses.h"
#include "bus/word_channel.h"
#include "jobs/job_report.h"
#include "jobs/what_run_makes_valid.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "widgets/help/help_topic.h"
#include "widgets/job/cancel_question.h"

#include <QMessageBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace codewheel {
namespace {

// An answer to the question before is not to hit a button of the one that has taken its place.
constexpr std::chrono::seconds readingTime{1};

void enableOnceRead(QPushButton &button)
{
    const QString tip = button.toolTip();
    button.setEnabled(false);
    button.setToolTip(Leaving::tr("The question has just changed: read it first"));
    QTimer::singleShot(readingTime, &button, [&button, tip] {
        button.setEnabled(true);
        button.setToolTip(tip);
    });
}

} // namespace

Leaving::Leaving(QWidget &window)
    : QObject(&window)
    , m_window(window)
{}

void Leaving::setBuses(Buses &buses)
{
    m_buses = &buses;
    connect(&buses, &Buses::changed, this, &Leaving::watch);
    connect(&buses, &Buses::updated, this, [this] {
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
    for (const Place number : m_buses->places()) {
        EncoderSession *encoder = m_buses->encoder(number);
        if (encoder == nullptr || isWatched(encoder))
            continue;
        m_watched.emplace_back(encoder);
        connect(encoder, &EncoderSession::progressed, this,
                [this, encoder](const Progress &progress) { takeProgress(*encoder, progress); });
        connect(encoder, &EncoderSession::finished, this, [this, encoder] {
            m_progress.erase(encoder->place());
            if (m_cancelled == encoder)
                m_cancelled = nullptr;
            QTimer::singleShot(0, this, &Leaving::goOn);
        });
    }
}

// If the encoder has taken something before the cancel reached it, the user is asked how to leave it.
void Leaving::takeProgress(const EncoderSession &encoder, const Progress &progress)
{
    m_progress[encoder.place()] = progress;
    if (m_cancelled != &encoder || !progress.hasTaken)
        return;
    m_cancelled = nullptr;
    QTimer::singleShot(0, this, &Leaving::goOn);
}

void Leaving::ask(Why why, const std::vector<EncoderBus *> &left, std::function<void()> then)
{
    m_why = why;
    m_left = left;
    m_then = std::move(then);
    m_outAnswered = false;
    m_zerosAnswered = false;
    m_waitsForZero = false;
    goOn();
}

// Called again whenever something it was waiting for has happened.
void Leaving::goOn()
{
    if (!m_then || m_asks || m_breaksOff)
        return;
    const QScopedValueRollback asks(m_asks, true);
    if (const QPointer<EncoderSession> encoder = busyEncoder()) {
        if (m_waitsForZero)
            return; // it is being brought back
        if (!endJob(*encoder))
            stay();
        else if (!encoder || !encoder->runningJob())
            QTimer::singleShot(0, this, &Leaving::goOn);
        return; // otherwise finished() calls this again
    }
    if (const EncoderBus *bus = busWithOtherWork()) {
        askToBreakOff(bus->id());
        return;
    }
    if (m_why != Why::stop && !m_zerosAnswered && waitsForZeros() && !askAboutZeros())
        return;
    const std::vector<Place> devices = devicesToAskFor();
    const auto isRunning = [this](Place number) { return m_buses->busOf(number)->isRunning(); };
    const auto stillSends = [&](Place number) {
        return isRunning(number) && m_buses->channel(number)->out() != 0;
    };
    if (m_waitsForZero && std::ranges::any_of(devices, stillSends))
        return; // updated() calls this again
    if (!devices.empty() && !m_outAnswered && !askForOut(devices, Asked::first))
        return;
    m_waitsForZero = false;
    std::exchange(m_then, nullptr)();
}

// A bus that is stopped only goes on with it.
const EncoderBus *Leaving::busWithOtherWork() const
{
    if (m_why != Why::stop && m_otherWork.underWay)
        for (const EncoderBus *bus : buses())
            if (m_otherWork.underWay(bus->id()))
                return bus;
    return nullptr;
}

// If it ends while this is asked, nobody has answered: the user stays, and sees how it ended.
void Leaving::askToBreakOff(BusId bus)
{
    const WorkUnderWay work = m_otherWork.underWay(bus).value_or(WorkUnderWay());
    QMessageBox box(QMessageBox::Warning, title(), work.what, QMessageBox::NoButton, &m_window);
    setHelpTopic(box, "README.md#leaving");
    box.setInformativeText(work.atStake);
    QPushButton *go = box.addButton(tr("&Break it off, and go on"), QMessageBox::DestructiveRole);
    go->setToolTip(
        tr("What was not sent yet is not sent. If anything is in doubt then, you stay, and see it"));
    QPushButton *wait = box.addButton(QMessageBox::Cancel);
    wait->setText(tr("&Stay"));
    wait->setToolTip(tr("It goes on (Esc)"));
    box.setDefaultButton(wait);
    const QObject whileOpen;
    connect(m_buses, &Buses::updated, &whileOpen, [&] {
        if (!m_otherWork.underWay(bus))
            box.reject();
    });
    box.exec();
    if (box.clickedButton() != go) {
        stay();
        return;
    }
    m_breaksOff = true;
    m_otherWork.breakOff(bus, [this](bool isSettled) {
        m_breaksOff = false;
        if (isSettled)
            QTimer::singleShot(0, this, &Leaving::goOn);
        else
            stay();
    });
}

bool Leaving::waitsForZeros() const
{
    const std::vector<EncoderBus *> left = buses();
    return std::ranges::any_of(left, &EncoderBus::waitsForZeros);
}

// Nobody tries any longer once the bus is closed. If they arrive while this is asked, nobody has answered:
// the user stays, and sees it.
bool Leaving::askAboutZeros()
{
    QMessageBox box(QMessageBox::Warning, title(),
                    tr("Nothing says that the zeros of the ALARM STOP have arrived."), QMessageBox::NoButton,
                    &m_window);
    setHelpTopic(box, "README.md#leaving");
    box.setInformativeText(
        tr("The outputs may be as they were. The program goes on trying as long as the bus stays "
           "connected; afterwards nobody does. Stop the machine by its own means."));
    QPushButton *go = box.addButton(tr("&Give up, and go on"), QMessageBox::DestructiveRole);
    go->setToolTip(tr("The zeros are not sent any more"));
    QPushButton *cancel = box.addButton(QMessageBox::Cancel);
    cancel->setText(tr("&Keep trying"));
    box.setDefaultButton(cancel);
    const QObject whileOpen;
    connect(m_buses, &Buses::updated, &whileOpen, [&] {
        if (!waitsForZeros())
            box.reject();
    });
    box.exec();
    m_zerosAnswered = box.clickedButton() == go;
    if (!m_zerosAnswered)
        stay();
    return m_zerosAnswered;
}

// With a word in OUT, or an encoder that nobody has brought back from a parameterization or another mode.
std::vector<Place> Leaving::devicesToAskFor() const
{
    std::vector<Place> devices;
    for (const EncoderBus *bus : buses()) {
        std::ranges::copy(devicesWithOut(*bus), std::back_inserter(devices));
        for (const Place place : bus->places())
            if ((isInParameterization(place) || isInOtherMode(place)) &&
                std::ranges::count(devices, place) == 0)
                devices.push_back(place);
    }
    return devices;
}

bool Leaving::isInParameterization(Place device) const
{
    const EncoderSession *encoder = m_buses->encoder(device);
    return encoder != nullptr && (encoder->freshness().isLive() || isLost(device)) &&
           encoder->latest().state == EncoderState::parameterization;
}

bool Leaving::isInOtherMode(Place device) const
{
    const EncoderSession *encoder = m_buses->encoder(device);
    return encoder != nullptr && encoder->leftInMode();
}

// What its device shows is as it was last seen.
bool Leaving::isLost(Place device) const
{
    const EncoderBus *bus = m_buses->busOf(device);
    return bus != nullptr && bus->state() == BusState::lost;
}

std::vector<EncoderBus *> Leaving::buses() const
{
    std::vector<EncoderBus *> buses = m_buses->open();
    std::erase_if(buses, [this](EncoderBus *bus) { return std::ranges::find(m_left, bus) == m_left.end(); });
    return buses;
}

EncoderSession *Leaving::busyEncoder() const
{
    for (const EncoderBus *bus : buses())
        for (const Place number : bus->places())
            if (EncoderSession *encoder = bus->encoder(number); encoder != nullptr && encoder->runningJob())
                return encoder;
    return nullptr;
}

QString Leaving::whyNothingCanBeSent(const std::vector<Place> &devices) const
{
    if (std::ranges::any_of(devices, [this](Place device) { return isLost(device); }))
        return tr("Nothing can be sent now: the link is lost");
    const auto isOperating = [this](Place device) {
        const EncoderBus *bus = m_buses->busOf(device);
        return bus->isRunning() && bus->isOperating();
    };
    return std::ranges::all_of(devices, isOperating)
               ? QString()
               : tr("Nothing can be sent now: the bus is stopped, or in Watch");
}

bool Leaving::endJob(EncoderSession &encoder)
{
    const Progress progress = m_progress[encoder.place()];
    if (!progress.hasTaken) {
        m_cancelled = &encoder;
        encoder.cancel(OnCancel::ifNothingTaken);
        return true;
    }
    const QPointer<EncoderSession> stillThere = &encoder;
    const Place place = encoder.place();
    const auto how = askHowToCancel(&m_window, encoder, situationOf(encoder, progress));
    if (!stillThere || !encoder.runningJob())
        return goesOnWithoutJob(place);
    if (how)
        encoder.cancel(*how);
    return how.has_value();
}

// The job went on while its end was asked about, and has ended by itself: the question is gone without an
// answer.
bool Leaving::goesOnWithoutJob(Place place)
{
    QMessageBox box(QMessageBox::Question, title(),
                    tr("The job on %1 has ended before an answer was given.").arg(place.shown()),
                    QMessageBox::NoButton, &m_window);
    setHelpTopic(box, "README.md#leaving");
    box.setInformativeText(tr("Its result stands in the messages. %1 all the same?").arg(title()));
    QPushButton *go = box.addButton(title(), QMessageBox::AcceptRole);
    go->setToolTip(tr("Goes on without sending anything"));
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.exec();
    return box.clickedButton() == go;
}

QString Leaving::title() const
{
    switch (m_why) {
    case Why::quit:
        return tr("Quit Codewheel");
    case Why::disconnect:
        return tr("Disconnect");
    case Why::stop:
        return tr("Stop the bus");
    }
    return {};
}

QStringList Leaving::statesOf(const std::vector<Place> &devices) const
{
    QStringList states;
    for (const Place device : devices)
        states.append(stateOf(device));
    return states;
}

// "OUT 1.0 is 020000FF".
QString Leaving::stateOf(Place device) const
{
    const QString word = hexWord(m_buses->channel(device)->out());
    if (isLost(device))
        return (isInParameterization(device)
                    ? tr("OUT %1 was %2 when last seen, and the encoder was in parameterization")
                    : tr("OUT %1 was %2 when last seen"))
            .arg(device.shown(), word);
    const QString out = tr("OUT %1 is %2").arg(device.shown(), word);
    if (isInOtherMode(device) && !isInParameterization(device))
        return tr("%1. %2", "OUT 1.0 is 020000FF, a sentence")
            .arg(out, messageText(leftModeMessage(*m_buses->encoder(device)->leftInMode())));
    return isInParameterization(device)
               ? tr("%1. The encoder is in parameterization, and stays there without a position until run is "
                    "sent. %2",
                    "OUT 1.0 is 020000FF, sentences")
                     .arg(out, whatRunMakesValid(*m_buses->encoder(device)))
               : out;
}

QString Leaving::headline(const std::vector<Place> &devices, bool needsRun) const
{
    if (std::ranges::any_of(devices, [this](Place device) { return isLost(device); }))
        return tr("The link is lost.");
    if (needsRun)
        return tr("An encoder has been left in parameterization.");
    return std::ranges::any_of(devices, [this](Place device) { return isInOtherMode(device); })
               ? tr("An encoder has not been left in position mode.")
               : tr("Not all OUT words are 00000000.");
}

// True: go on now. False: the user stays, or the zeros are being sent.
bool Leaving::askForOut(const std::vector<Place> &devices, Asked asked)
{
    const QStringList states = statesOf(devices);
    const QString whyNot = whyNothingCanBeSent(devices);
    const bool needsRun =
        std::ranges::any_of(devices, [this](Place device) { return isInParameterization(device); });
    const bool hasOut =
        std::ranges::any_of(devices, [this](Place device) { return m_buses->channel(device)->out() != 0; });
    QMessageBox box(QMessageBox::Question, title(), headline(devices, needsRun), QMessageBox::NoButton,
                    &m_window);
    setHelpTopic(box, "README.md#leaving");
    const QString question = !hasOut && !needsRun && whyNot.isEmpty()
                                 ? tr("Leave it as it is? Otherwise cancel, and switch it to position mode.")
                             : !whyNot.isEmpty()
                                 ? tr("%1. Leave them as they are?", "why nothing can be sent").arg(whyNot)
                             : needsRun ? tr("What shall be sent first?")
                                        : tr("Set them to 00000000 (normal running) first?");
    box.setInformativeText(states.join(u'\n') + QStringLiteral("\n\n") + question);
    const auto add = [&](const QString &text, QMessageBox::ButtonRole role, const QString &tip,
                         const QString &whyDisabled) {
        QPushButton *button = box.addButton(text, role);
        button->setEnabled(whyDisabled.isEmpty());
        button->setToolTip(whyDisabled.isEmpty() ? tip : whyDisabled);
        if (asked == Asked::again && button->isEnabled())
            enableOnceRead(*button);
        return button;
    };
    const QPushButton *run =
        needsRun ? add(tr("Send &run, then 00000000"), QMessageBox::AcceptRole,
                       tr("Sends 80000000 to the encoders in parameterization, and 00000000 to "
                          "all devices named, then goes on"),
                       whyNot)
                 : nullptr;
    QPushButton *zeros = add(tr("Set to &00000000"), QMessageBox::AcceptRole,
                             needsRun ? tr("Sends 00000000 to these devices, then goes on. What is in "
                                           "parameterization stays there")
                                      : tr("Sends 00000000 to these devices, then goes on"),
                             hasOut ? whyNot : tr("OUT is 00000000 already"));
    const QPushButton *leave = add(tr("&Leave as they are"), QMessageBox::DestructiveRole,
                                   tr("Goes on without sending anything"), {});
    QPushButton *cancel = box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(whyNot.isEmpty() && hasOut && !needsRun ? zeros : cancel);
    bool isOld = false;
    const QObject whileOpen;
    connect(m_buses, &Buses::updated, &whileOpen, [&] {
        isOld = isOld || devicesToAskFor() != devices || statesOf(devices) != states ||
                whyNothingCanBeSent(devices) != whyNot;
        if (isOld)
            box.reject();
    });
    box.exec();
    if (isOld)
        return askForWhatIsLeft();

    m_outAnswered = true;
    m_waitsForZero = false;
    if (box.clickedButton() == leave)
        return true;
    if (box.clickedButton() == zeros || (run != nullptr && box.clickedButton() == run))
        zero(devices, box.clickedButton() == run);
    else
        stay();
    return false;
}

// What was asked about is another now: by ALARM STOP, say. Nothing is answered by that.
bool Leaving::askForWhatIsLeft()
{
    if (const std::vector<Place> devices = devicesToAskFor(); !devices.empty())
        return askForOut(devices, Asked::again);
    stay();
    return false;
}

// Where run fails, the question comes again: it says what is left.
void Leaving::zero(const std::vector<Place> &devices, bool runsFirst)
{
    m_waitsForZero = true;
    for (const Place device : devices) {
        EncoderSession *encoder = m_buses->encoder(device);
        if (runsFirst && isInParameterization(device) && encoder->start(EndParameterization{}))
            m_outAnswered = false;
        else if (WordChannel *channel = m_buses->channel(device))
            channel->zero();
    }
}

void Leaving::stay()
{
    m_then = nullptr;
}

} // namespace codewheel
