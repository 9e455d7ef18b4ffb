// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/eeprom_cost.h"

#include "words/k3_word.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

struct Eeprom
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Eeprom)
};

struct Cost
{
    const EncoderSession &encoder;
    const Capabilities &can = encoder.can();

    static int size(const auto &list) { return static_cast<int>(std::ssize(list)); }

    int operator()(const ReadParameters &) const { return 0; }
    int operator()(const WriteParameters &job) const
    {
        return size(job.values) + (job.initialisePreset && can.presetIsStored ? 1 : 0);
    }
    int operator()(const SetPreset &job) const
    {
        const bool isWritten = can.presetIsStored || job.command == PresetCommand::manufacturer;
        return (job.value ? 1 : 0) + (isWritten ? 1 : 0);
    }
    // What words do by hand depends on all that went before: each may be one.
    int operator()(const SendWords &job) const
    {
        return static_cast<int>(std::ranges::count_if(
            job.words, [](Word word) { return word != k3::normalRunning && word != k3::run; }));
    }
    int operator()(const EndParameterization &job) const { return size(job.restore); }
    // Leaving cam mode stores a program that was changed.
    int operator()(const SwitchMode &) const
    {
        return can.cams && encoder.latest().mode.value_or(Mode::cam) == Mode::cam ? 1 : 0;
    }
    int operator()(const ResetToDefault &) const { return 1 + (*this)(SwitchMode{}); }
    int operator()(const ReadCams &job) const { return size(job.programs) + 1; }
    int operator()(const WriteCams &job) const { return size(job.programs) + 1; }
};

QString countedBy(const EepromCount &count)
{
    switch (count.by) {
    case CountedBy::serialNumber:
        return Eeprom::tr("counted by the serial number %1 the encoder told").arg(count.serialNumber);
    case CountedBy::labelSerialNumber:
        return Eeprom::tr("counted by the serial number %1 on its label").arg(count.serialNumber);
    case CountedBy::place:
        return Eeprom::tr("counted by its place, since the serial number is not known");
    case CountedBy::session:
        break;
    }
    return Eeprom::tr("counted since the connection was made");
}

QString dateText(const QDateTime &at)
{
    return QLocale().toString(at.toLocalTime().date(), QLocale::ShortFormat);
}

} // namespace

int mostEepromWrites(const EncoderSession &encoder, const Job &job)
{
    return std::visit(Cost{encoder}, job);
}

EepromConcern eepromConcern(int writesSoFar, int planned, const Capabilities &can)
{
    const int then = writesSoFar + planned;
    if (planned <= 0)
        return EepromConcern::none;
    if (can.eepromLimit && then > *can.eepromLimit)
        return EepromConcern::typed;
    if (!can.eepromBudget)
        return EepromConcern::none;
    if (then > *can.eepromBudget)
        return EepromConcern::question;
    return 4 * then >= 3 * *can.eepromBudget ? EepromConcern::warning : EepromConcern::none;
}

EepromConcern eepromConcern(const EncoderSession &encoder, int planned)
{
    return eepromConcern(encoder.eepromCount().atMost(), planned, encoder.can());
}

QString eepromCountText(const EepromCount &count)
{
    QString text = count.since.isValid()
                       ? Eeprom::tr("EEPROM writes by this program since %1: %2")
                             .arg(dateText(count.since))
                             .arg(count.writes)
                       : Eeprom::tr("EEPROM writes by this program so far: %1").arg(count.writes);
    if (count.perhaps > 0)
        text +=
            u' ' + Eeprom::tr("(and perhaps %1 more, which it began before it was ended)").arg(count.perhaps);
    return text + QStringLiteral(", ") + countedBy(count) + u'.';
}

QString eepromCountBrief(const EepromCount &count)
{
    QString number = QString::number(count.writes);
    if (count.perhaps > 0)
        number += QStringLiteral("-%1").arg(count.atMost());
    return count.since.isValid()
               ? Eeprom::tr("%1 writes from here since %2").arg(number, dateText(count.since))
               : Eeprom::tr("%1 writes from here").arg(number);
}

QString eepromConcernText(const EncoderSession &encoder, int planned)
{
    const Capabilities &can = encoder.can();
    const int soFar = encoder.eepromCount().atMost();
    switch (eepromConcern(encoder, planned)) {
    case EepromConcern::warning:
        return Eeprom::tr("This program has written %1 times to the EEPROM; the manual speaks of about %2. "
                          "Write only what has to be.")
            .arg(soFar)
            .arg(*can.eepromBudget);
    case EepromConcern::question:
        return Eeprom::tr(
                   "With %1 writes by this program and %2 more, the about %3 of which the manual speaks "
                   "are used up. The encoder may lose its values.")
            .arg(soFar)
            .arg(planned)
            .arg(*can.eepromBudget);
    case EepromConcern::typed:
        return Eeprom::tr(
                   "With %1 writes by this program and %2 more, the EEPROM is beyond the %3 that the "
                   "manual guarantees at most. The encoder may lose its values at any time: replace it "
                   "soon.")
            .arg(soFar)
            .arg(planned)
            .arg(*can.eepromLimit);
    case EepromConcern::none:
        break;
    }
    return {};
}

} // namespace codewheel
