// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/eeprom_cost.h"

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <functional>
#include <span>

namespace codewheel {
namespace {

struct Eeprom
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Eeprom)
};

// While the mode is not known it may be cam mode, and an encoder of unknown make may be a FRABA.
bool mayBeInCamMode(const EncoderSession &encoder)
{
    return encoder.device().mayHaveModes() && encoder.latest().mode.value_or(Mode::cam) == Mode::cam;
}

struct Cost
{
    const EncoderSession &encoder;
    const Capabilities &can = encoder.can();
    const Quirks &quirks = encoder.device().quirks;

    static int size(const auto &list) { return static_cast<int>(std::ssize(list)); }

    int operator()(const ReadParameters &) const { return 0; }
    int operator()(const WriteParameters &job) const
    {
        return size(job.values) + (job.initialisePreset && mayStorePreset(encoder.device()) ? 1 : 0) +
               protocolOf(encoder.device()).writtenBesides(job.values);
    }
    int operator()(const SetPreset &job) const
    {
        if (can.presetNeedsValue) // the command carries it
            return 1;
        const bool isManufacturers = job.command == PresetCommand::manufacturer;
        const bool isProgrammed = job.value || (quirks.presetNeedsRearming && !isManufacturers);
        const bool isActivated = mayStorePreset(encoder.device()) || isManufacturers;
        return (isProgrammed ? 1 : 0) + (isActivated ? 1 : 0);
    }
    int operator()(const SendWords &job) const
    {
        return protocolOf(encoder.device())
            .eepromWrites(encoder.device(), job.words, mayBeInCamMode(encoder));
    }
    int operator()(const EndParameterization &job) const { return size(job.restore); }
    // Leaving cam mode stores a program that was changed.
    int operator()(const SwitchMode &) const { return mayBeInCamMode(encoder) ? 1 : 0; }
    int operator()(const ResetToDefault &) const { return 1 + (*this)(SwitchMode{}); }
    int operator()(const StoreParameters &) const { return 1; }
    int operator()(const ReadCams &job) const
    {
        return size(job.programs) + (leavesAnother(job.programs, std::identity()) ? 1 : 0);
    }
    int operator()(const WriteCams &job) const
    {
        return size(job.programs) + (leavesAnother(job.programs, &CamProgram::number) ? 1 : 0);
    }

    // Besides its own programs: the one it is in, or perhaps is in, which may have been changed.
    template <typename Number>
    bool leavesAnother(const auto &programs, Number number) const
    {
        const auto current = encoder.latest().camProgram;
        return mayBeInCamMode(encoder) && !(current && std::ranges::count(programs, *current, number) > 0);
    }
};

QString countedBy(const EepromCount &count)
{
    switch (count.by) {
    case CountedBy::serialNumber:
        return Eeprom::tr("counted by the serial number %1 read from the encoder").arg(count.serialNumber);
    case CountedBy::labelSerialNumber:
        return Eeprom::tr("counted by the serial number %1 on its label").arg(count.serialNumber);
    case CountedBy::place:
        return Eeprom::tr("counted by its place, since the serial number is not known");
    case CountedBy::session:
        break;
    }
    return Eeprom::tr("counted since the connection was made");
}

constexpr int usualPercent = 75;

int &askedFromPercent()
{
    static int percent = usualPercent;
    return percent;
}

QString dateText(const QDateTime &at)
{
    return QLocale().toString(at.toLocalTime().date(), QLocale::ShortFormat);
}

bool storesByStep(const EncoderSession &encoder)
{
    return protocolRules(encoder.device().profile).storesByStep();
}

// What is written along with the earlier values of these steps, and what the encoder sets along with them.
int writtenAlong(const Protocol &protocol, std::span<const Step> steps)
{
    ParameterValues taken;
    for (const Step &step : steps)
        if (takesValue(step))
            for (const Parameter parameter : step.parameters)
                replaceValue(taken, {parameter, step.data.value_or(0)});
    return protocol.writtenBesides(taken) + static_cast<int>(protocol.setAlong(taken, {}).size());
}

// What was taken is given back in one go, which has as many steps that store as the job has.
int writesToGiveBack(const EncoderSession &encoder, std::span<const Step> all, std::span<const Step> done)
{
    const DeviceDescription &device = encoder.device();
    if (std::ranges::none_of(done, takesValue))
        return 0;
    return storesByStep(encoder) ? storingSteps(all, device)
                                 : storingSteps(done, device) + writtenAlong(protocolOf(device), done);
}

} // namespace

int mostEepromWrites(const EncoderSession &encoder, const Job &job)
{
    if (!storesByStep(encoder))
        return std::visit(Cost{encoder}, job);
    const auto steps = encoder.planned({job});
    return steps ? eepromWritesOf(*steps, encoder.device()) : 0;
}

int mostEepromWrites(const EncoderSession &encoder, Word word)
{
    return protocolOf(encoder.device()).eepromWrites(encoder.device(), {&word, 1}, mayBeInCamMode(encoder));
}

int mostWritesToRestore(const EncoderSession &encoder, const Progress &progress)
{
    const auto done = std::min(std::ssize(progress.steps), std::ptrdiff_t{progress.index} + 1);
    const std::span steps = std::span(progress.steps).first(static_cast<std::size_t>(done));
    const auto count = [&](auto counts) { return std::ranges::count_if(steps, counts); };
    const auto cams = count([](const Step &step) { return step.effect == Effect::takesCams; });
    const auto programs = count([](const Step &step) { return step.effect == Effect::switchesMode; });
    return writesToGiveBack(encoder, progress.steps, steps) +
           static_cast<int>(cams > 0 ? std::max(programs, std::ptrdiff_t{1}) : 0);
}

void askFromEepromShare(int percent)
{
    askedFromPercent() = std::clamp(percent, 1, usualPercent);
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
    return 100 * std::int64_t{then} >= askedFromPercent() * std::int64_t{*can.eepromBudget}
               ? EepromConcern::question
               : EepromConcern::none;
}

EepromConcern eepromConcern(const EncoderSession &encoder, int planned)
{
    return eepromConcern(encoder.eepromCount().atMost(), planned, encoder.can());
}

QString eepromWritesText(int writes, int perhaps)
{
    const QString certain = QLocale().toString(writes);
    return perhaps > 0 ? Eeprom::tr("%1, perhaps %2 more").arg(certain, QLocale().toString(perhaps))
                       : certain;
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
            u' ' +
            Eeprom::tr("(and perhaps %1 more, which it began and did not see the end of)").arg(count.perhaps);
    if (count.atPlace > 0 && count.by == CountedBy::place)
        text +=
            u' ' +
            Eeprom::tr("(and perhaps %1 more, counted by its place for the encoder that was there before)")
                .arg(count.atPlace);
    else if (count.atPlace > 0)
        text += u' ' +
                Eeprom::tr("(and perhaps %1 more, counted by its place before its serial number was known)")
                    .arg(count.atPlace);
    return text + QStringLiteral(", ") + countedBy(count) + u'.';
}

QString eepromCountText(const EncoderSession &encoder)
{
    EepromCount count = encoder.eepromCount();
    bool isNumber = false;
    const Word serial = count.serialNumber.toUInt(&isNumber);
    const ParameterDescription *told = encoder.device().find(Parameter::serialNumber);
    if (isNumber && count.by == CountedBy::serialNumber && told != nullptr && told->form != nullptr)
        count.serialNumber = valueText(*told, serial);
    return eepromCountText(count);
}

QString eepromCountBrief(const EepromCount &count)
{
    QString number = QString::number(count.writes);
    if (count.atMost() > count.writes)
        number += QStringLiteral("-%1").arg(count.atMost());
    QString text = number == QStringLiteral("1") ? Eeprom::tr("1 write by Codewheel")
                                                 : Eeprom::tr("%1 writes by Codewheel").arg(number);
    if (count.since.isValid())
        text += u' ' + Eeprom::tr("since %1", "writes since a date").arg(dateText(count.since));
    if (count.by == CountedBy::place)
        text += QStringLiteral(", S/N?"); // the same in every language
    return text;
}

QString eepromConcernText(const EncoderSession &encoder, int planned)
{
    const Capabilities &can = encoder.can();
    const int soFar = encoder.eepromCount().atMost();
    switch (eepromConcern(encoder, planned)) {
    case EepromConcern::question:
        if (soFar + planned <= *can.eepromBudget)
            return Eeprom::tr("This program has written %1 times to the EEPROM; the manual states about %2 "
                              "writes. Write only what has to be written.")
                .arg(soFar)
                .arg(*can.eepromBudget);
        return Eeprom::tr("With %1 writes by this program and %2 more, the %3 or so that the manual states "
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
