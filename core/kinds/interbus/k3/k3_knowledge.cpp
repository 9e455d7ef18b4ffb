// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_knowledge.h"

#include "catalog/device_description.h"
#include "kinds/interbus/k3/k3_reading.h"
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/position_code.h"
#include "kinds/interbus/words/word_reach.h"

#include <utility>

namespace codewheel {
namespace {

// Read-out 3 "complement": 3/4 as written; 0/1 is accepted too (assumed).
std::int64_t directionOfReadOut(Word data)
{
    return data <= 1 ? std::int64_t{data} + 3 : data;
}

// Signed, in 16 or in 25 bits (FRABA manual 10.2: "as signed int").
std::int64_t temperatureOfReadOut(Word data)
{
    if (data <= 0xFFFF)
        return static_cast<std::int16_t>(data);
    return k3::signedData(data);
}

// A preset acts in operation, even while the encoder has no valid position.
bool mayTakePreset(Word in)
{
    return k3::isOperation(in) || in == k3::error;
}

} // namespace

void K3Knowledge::set(const std::vector<Known> &known)
{
    m_known.set(known);
    for (const Known &one : known) {
        // A start-up mode that was read says nothing about the present: something may have switched the mode
        // since.
        if (one.parameter == Parameter::startUpMode && one.evidence == Evidence::told &&
            one.at >= m_modeSince) {
            m_mode.believe(modeAfterStartUp(one.value.number()), camProgramAfterStartUp(one.value.number()));
            m_mayHoldOldCams = true;
        }
    }
}

void K3Knowledge::forget()
{
    (void)loseSight(k3::normalRunning, SentBy::hand);
    m_known.set({});
    m_cams.forgetValues();
    m_mode = {};
    m_mayHoldOldCams = true;
    m_presetArmed.reset();
}

void K3Knowledge::observe(Word in, Word out, Instant now)
{
    if (std::exchange(m_presetIsOpen, false)) // another exchange followed, so its word has arrived
        m_known.countEepromWrite();
    observeMode(out, now);
    if (k3::isOperation(in))
        m_lastPosition = in;
    const bool isFirst = !std::exchange(m_hasSeenWords, true); // what was in OUT by then was sent by others
    const bool isOfOthers = isFirst || m_othersWrite;
    if (m_device.capabilities.cams)
        m_cams.observe(in, out, {mode(), camProgram(), isOfOthers}, now);
    if (!isFirst && isManufacturerPreset(out) && mayTakePreset(m_in))
        observeManufacturerPreset();
    const bool outChanged = out != m_out;
    if (!outChanged && k3::isOperation(in) && k3::isOperation(m_in) && m_unproven.empty()) {
        m_answerIsFresh = true;
        m_in = in;
        return;
    }
    if (outChanged) {
        m_answerIsFresh = false;
        countConfirmed();
        if (!isFirst)
            observePreset(out);
        if (k3::isParameterWord(out)) {
            m_asked = out;
            m_inWhenAsked = m_in;
            m_askedIsProcessed = false;
            m_wordIsOfOthers = isOfOthers;
        }
    }
    if (!k3::isOperation(in))
        m_unproven.clear();
    switch (stateOf(in, m_device.dialect.as<k3::Dialect>())) {
    case EncoderState::operation:
        observeOperation(in, out, now);
        break;
    case EncoderState::parameterization:
        observeConfirmation(in, out);
        break;
    case EncoderState::error:
        if (in != m_in)
            observeError(in, out, now);
        break;
    case EncoderState::readOut:
        observeReadOut(in, out, now);
        break;
    case EncoderState::service:
    case EncoderState::waiting:
    case EncoderState::silent:
    case EncoderState::unknown:
    case EncoderState::notSeen:
        break;
    }
    if (stateOf(in, m_device.dialect.as<k3::Dialect>()) != EncoderState::readOut)
        m_answerIsFresh = true;
    m_in = in;
    m_out = out;
}

void K3Knowledge::tellMode(std::optional<Mode> mode, std::optional<unsigned> camProgram)
{
    m_mode.tell(mode, camProgram);
    m_mayHoldOldCams = true;
}

void K3Knowledge::doubtMode(Instant now)
{
    if (!modeIsOnlyTold())
        return;
    tellMode(std::nullopt);
    m_modeSince = now;
    m_known.forget(Parameter::startUpMode);
}

bool K3Knowledge::mayHoldOldCams() const
{
    return m_mayHoldOldCams && m_device.mayHaveModes() && mode().value_or(Mode::cam) == Mode::cam;
}

void K3Knowledge::observeMode(Word out, Instant now)
{
    const bool mayBeOld = mayHoldOldCams();
    const K3Mode::Switched switched = m_device.mayHaveModes() ? m_mode.observe(out) : K3Mode::Switched::no;
    if (switched == K3Mode::Switched::no)
        return;
    if (!m_device.quirks.hasModes && mode() != Mode::position) // only a FRABA can have gone there
        m_mode.tell(std::nullopt);
    m_modeSince = now;
    leaveCams(switched == K3Mode::Switched::certainly, mayBeOld);
    const auto startUp = value(Parameter::startUpMode); // an encoder starts in the mode it was in
    if (startUp && (mode() == Mode::cam || modeAfterStartUp(*startUp) != mode()))
        m_known.forget(Parameter::startUpMode);
}

// Whether it was changed, and left, may be in doubt: a job says so in the end. What is changed by hand
// counts: better twice than never.
void K3Knowledge::leaveCams(bool isCertain, bool mayBeOld)
{
    using enum K3CamKnowledge::Change;
    m_mayHoldOldCams = false;
    const auto change = m_cams.leave();
    if (m_othersWrite || (change == no && !mayBeOld))
        return;
    if (m_jobRuns && (change != certainly || !isCertain))
        ++m_perhapsWritten;
    else if (change != no)
        m_known.countEepromWrite();
}

int K3Knowledge::endJob()
{
    m_jobRuns = false;
    return std::exchange(m_perhapsWritten, 0);
}

// An encoder of unknown make may be a FRABA, too.
bool K3Knowledge::isManufacturerPreset(Word out) const
{
    return out == k3::frabaPreset && (m_device.capabilities.manufacturerPreset || m_device.isGeneric()) &&
           mode() != Mode::cam;
}

// Only in cam mode such a word is acknowledged. 40000000 is left out: C0000000 is also an encoder at its
// start.
bool K3Knowledge::provesCamMode(Word in, Word out) const
{
    return m_device.mayHaveModes() && in != m_in && in == (out | k3::confirmation) &&
           k3::isCamParameter(out) && out != k3::initialisePreset;
}

void K3Knowledge::observeConfirmation(Word in, Word out)
{
    if (mode() && mode() != Mode::cam && provesCamMode(in, out))
        tellMode(Mode::cam); // what was told, or switched meanwhile by others
    const bool stands = k3::isParameterWord(out);
    const Word asked = stands ? out : m_asked.value_or(k3::normalRunning);
    const unsigned number = k3::number(in);
    if (!k3::isParameterWord(asked)) {
        const bool isOfCams = mode() == Mode::cam || in == (k3::confirmation | out);
        if (!m_pending.contains(number) && !isOfCams)
            m_foundConfirmed = in; // by a word that was not seen, nor those before it
        return;
    }
    if (number != k3::number(asked)) { // an old confirmation, or processing (Baumer)
        m_askedIsProcessed = m_askedIsProcessed || k3::data(in) == k3::data(asked);
        return;
    }
    const bool isOfBefore = m_asked && in == m_inWhenAsked && k3::data(in) != k3::data(asked);
    if (isOfBefore) // the number comes again
        return;
    m_pending[number] = k3::data(in) == k3::data(asked) ? std::optional(k3::data(asked)) : std::nullopt;
    m_lastConfirmed = number;
    m_asked.reset();
    if (!stands && !m_wordIsOfOthers)
        m_known.countEepromWrite(); // confirmed after it left OUT
}

// An error in answer to run is about the whole set, which stays pending. Otherwise, or where a confirmation
// comes before the check (FRABA), it may be the last confirmed value that was refused late.
void K3Knowledge::observeError(Word in, Word out, Instant now)
{
    constexpr unsigned parametersLost = 3;
    constexpr unsigned unknownWord = 2;
    const bool refusesCams = k3::isCamReadOutRequest(out) && k3::number(in) == unknownWord;
    const bool isInPositionMode = !mode() || mode() == Mode::position;
    if ((mode() == Mode::cam && refusesCams) || (!isInPositionMode && k3::number(in) == parametersLost))
        tellMode(std::nullopt);
    if (mode() != Mode::cam && k3::isParameterWord(out) && k3::number(in) == unknownWord)
        doubtMode(now); // as in cam mode
    m_asked.reset();
    if (k3::isParameterWord(out) && m_pending.erase(k3::number(out)) != 0)
        return;
    const bool answersRun = (out & k3::startBit) != 0;
    if (m_lastConfirmed && (!answersRun || m_device.quirks.confirmsWhileProcessing))
        m_pending[*m_lastConfirmed] = std::nullopt;
}

void K3Knowledge::observeReadOut(Word in, Word out, Instant now)
{
    if (!m_answerIsFresh || !k3::isReadOutRequest(out) || k3::number(in) != 0)
        return;
    const unsigned code = out & 0xFFFF;
    if (mayBeTorn(code, in)) {
        m_answerIsFresh = false;
        return;
    }
    for (const ParameterDescription &parameter : m_device.parameters)
        if (wordReach(parameter).readOut == code)
            if (const auto value = valueOfReadOut(parameter.parameter, k3::data(in)))
                learn(parameter.parameter, *value, Evidence::read, now);
    m_answerIsFresh = false; // learned once per request
}

bool K3Knowledge::mayBeTorn(unsigned code, Word in)
{
    constexpr Word lowHalf = 0xFFFF;
    const bool isOfPosition = m_wordsMayTear && (in & lowHalf) == (m_lastPosition & lowHalf);
    if (m_doubtful && m_doubtful->code != code) {
        m_doubtful->anotherCame = true;
        return isOfPosition;
    }
    const bool isAgain = m_doubtful && m_doubtful->anotherCame && m_doubtful->answer == in;
    if (isOfPosition && !isAgain) {
        m_doubtful = Doubtful{code, in};
        return true;
    }
    m_doubtful.reset();
    return false;
}

void K3Knowledge::observeOperation(Word in, Word out, Instant now)
{
    if (in != 0)
        for (const auto &[number, data] : std::exchange(m_unproven, {}))
            activate(number, data, now);
    if ((out & k3::startBit) != 0 && !k3::isOperation(m_in))
        observeRun(in, now);
    else if (isConfirmed(out) && !m_wordIsOfOthers)
        m_known.countEepromWrite(); // a power cycle drops what is pending; its word is still in OUT
    if (m_wordsMayTear && (out & k3::startBit) == 0 && !k3::isOperation(m_in))
        forgetUnseenRun();
    m_pending.clear();
    m_lastConfirmed.reset();
    m_foundConfirmed.reset();
}

void K3Knowledge::observeRun(Word in, Instant now)
{
    if (m_asked) { // its word may have been taken unnoticed
        m_pending.insert_or_assign(k3::number(*m_asked), std::nullopt);
        if (m_askedIsProcessed && !m_wordIsOfOthers)
            m_known.countEepromWrite();
        m_asked.reset();
    }
    if (m_foundConfirmed)
        activateUnseen();
    if (m_pending.empty())
        return;
    for (const auto &[number, data] : m_pending)
        activate(number, in != 0 ? data : std::nullopt, now);
    if (in == 0 && !m_device.capabilities.reads) // otherwise the read-out tells
        m_unproven = m_pending;
    m_hasRun = true;
}

// Behind a gateway IN may be seen before the OUT that caused it: run of another master, as likely as a power
// cycle.
void K3Knowledge::forgetUnseenRun()
{
    for (const ParameterDescription &parameter : m_device.parameters)
        if (const auto number = wordReach(parameter).number;
            number && (m_foundConfirmed || m_pending.contains(*number)))
            forgetNumber(*number);
}

// What was taken while nobody saw the encoder becomes valid, too. Only the last of it stood in IN, and in cam
// mode that was a cam.
void K3Knowledge::activateUnseen()
{
    const bool mayBeCam =
        m_device.mayHaveModes() && (mode().value_or(Mode::cam) == Mode::cam || modeIsOnlyTold());
    for (const ParameterDescription &parameter : m_device.parameters)
        if (const auto number = wordReach(parameter).number; number && !m_pending.contains(*number))
            forgetNumber(*number);
    m_pending.emplace(k3::number(*m_foundConfirmed),
                      mayBeCam ? std::nullopt : std::optional(k3::data(*m_foundConfirmed)));
}

// D30 0 -> 1: there is a new zero offset. FRABA stores it, once per programmed preset; with a number or data
// beside D30 the word sets a cam, or is refused.
void K3Knowledge::observePreset(Word out)
{
    if ((out & k3::presetBit) == 0 || (m_out & k3::presetBit) != 0 || mode() == Mode::cam ||
        isManufacturerPreset(out) || !mayTakePreset(m_in))
        return;
    if (m_device.quirks.hasModes && out != k3::initialisePreset)
        return;
    m_known.forget(Parameter::zeroOffset);
    m_known.forget(Parameter::presetFlag);
    m_presetIsOpen = !m_othersWrite && mayStorePreset(m_device) && m_presetArmed.value_or(true);
    m_presetArmed = false;
}

// One write per cycle (assumed).
void K3Knowledge::observeManufacturerPreset()
{
    m_known.forget(Parameter::zeroOffset);
    m_known.forget(Parameter::presetFlag);
    m_presetArmed = false;
    if (!m_othersWrite)
        m_known.countEepromWrite();
}

// One write per parameter that was confirmed and not refused by the time its word leaves OUT.
void K3Knowledge::countConfirmed()
{
    if (isConfirmed(m_out) && !m_wordIsOfOthers)
        m_known.countEepromWrite();
}

void K3Knowledge::countStanding()
{
    countConfirmed();
    m_wordIsOfOthers = m_wordIsOfOthers || isConfirmed(m_out);
}

// A number that comes again is not, until its word is.
bool K3Knowledge::isConfirmed(Word out) const
{
    return k3::isParameterWord(out) && m_pending.contains(k3::number(out)) && m_asked != out;
}

InDoubt K3Knowledge::inDoubtWith(Word out) const
{
    InDoubt doubt;
    if (m_othersWrite)
        return doubt;
    const auto add = [&](unsigned number, std::optional<Word> data) {
        const ParameterDescription *parameter = findNumber(m_device, number);
        doubt.reset = doubt.reset || number == resetNumber;
        if (parameter != nullptr && data)
            replaceValue(doubt.values, {parameter->parameter, *data});
    };
    for (const auto &[number, data] : m_pending)
        add(number, data);
    for (const Word word : {m_asked.value_or(k3::normalRunning), out})
        if (k3::isParameterWord(word))
            add(k3::number(word), k3::data(word));
    doubt.position = setsPositionBy(out);
    return doubt;
}

// 40000000 or 60000000 that was not in OUT before.
bool K3Knowledge::setsPositionBy(Word out) const
{
    return out != m_out && (out & k3::presetBit) != 0 && (m_out & k3::presetBit) == 0 &&
           !k3::isParameterWord(out) && mode() != Mode::cam && mayTakePreset(m_in);
}

int K3Knowledge::loseSight(Word out, SentBy by)
{
    int perhaps = writesInDoubt(out);
    for (const auto &[number, data] : m_pending)
        forgetNumber(number);
    for (const auto &[number, data] : m_unproven)
        forgetNumber(number);
    if (m_asked)
        forgetNumber(k3::number(*m_asked));
    if (k3::isParameterWord(out))
        forgetNumber(k3::number(out));
    perhaps += losesCams(out, by) ? 1 : 0;
    m_pending.clear();
    m_unproven.clear();
    m_asked.reset();
    m_lastConfirmed.reset();
    m_foundConfirmed.reset();
    m_answerIsFresh = false;
    m_hasSeenWords = false; // what is in OUT when it is seen again may have been sent by others
    m_out = k3::normalRunning;
    return perhaps;
}

// Leaving a program that was changed saves it.
bool K3Knowledge::losesCams(Word out, SentBy by)
{
    const bool mayBeCamMode = mode().value_or(Mode::cam) == Mode::cam;
    const bool mayBeOld = mayHoldOldCams();
    const bool mayLeave = m_device.mayHaveModes() && m_mode.loseSight(out);
    m_mayHoldOldCams = m_mayHoldOldCams && !mayLeave;
    const bool isInDoubt =
        m_device.capabilities.cams &&
        m_cams.loseSight(
            {.out = out, .mayBeCamMode = mayBeCamMode, .mayLeave = mayLeave, .isOfJob = by == SentBy::job});
    return (isInDoubt || (mayBeOld && mayLeave)) && !m_othersWrite;
}

// A word that was confirmed, and followed by another one, is certain.
int K3Knowledge::writesInDoubt(Word out)
{
    int perhaps = std::exchange(m_presetIsOpen, false) ? 1 : 0;
    const bool stands = out == m_out;
    if (!stands) {
        countConfirmed();
        perhaps += m_asked && !m_wordIsOfOthers ? 1 : 0; // it may be confirmed after it left OUT
    } else if (k3::isParameterWord(out) && !m_wordIsOfOthers &&
               (m_asked || m_pending.contains(k3::number(out))))
        ++perhaps;
    if (!stands && k3::isParameterWord(out))
        ++perhaps;
    if (setsPositionBy(out)) {
        m_known.forget(Parameter::zeroOffset);
        m_known.forget(Parameter::presetFlag);
        perhaps += mayStorePreset(m_device) && m_presetArmed.value_or(true) ? 1 : 0;
        m_presetArmed.reset();
    }
    return perhaps;
}

void K3Knowledge::forgetNumber(unsigned number)
{
    if (number == resetNumber)
        reset(false, {});
    else if (const ParameterDescription *parameter = findNumber(m_device, number)) {
        m_known.forget(parameter->parameter);
        if (parameter->parameter == Parameter::preset)
            m_presetArmed.reset();
    }
}

void K3Knowledge::activate(unsigned number, std::optional<Word> data, Instant now)
{
    if (number == resetNumber) {
        reset(data.has_value(), now);
        return;
    }
    const ParameterDescription *parameter = findNumber(m_device, number);
    if (parameter == nullptr)
        return;
    if (parameter->parameter == Parameter::preset) {
        m_known.forget(Parameter::presetFlag);
        m_presetArmed = true;
    }
    const auto value = data ? valueOfReadOut(parameter->parameter, *data) : std::nullopt;
    if (value)
        learn(parameter->parameter, *value, Evidence::echoed, now);
    else
        m_known.forget(parameter->parameter);
}

// Factory settings. Where they can be read they are read, since those of FRABA are only assumed; otherwise a
// proven reset is their evidence.
void K3Knowledge::reset(bool isProven, Instant now)
{
    for (const ParameterDescription &parameter : m_device.parameters) {
        if (!parameter.canBeWritten)
            continue;
        if (isProven && !m_device.capabilities.reads && parameter.factory)
            learn(parameter.parameter, *parameter.factory, Evidence::echoed, now);
        else
            m_known.forget(parameter.parameter);
    }
    m_known.forget(Parameter::presetFlag);
    m_presetArmed.reset();
    m_cams.forgetAll();
    if (m_device.mayHaveModes() && mode() != Mode::position) { // position mode then (assumed)
        m_mode.tell(std::nullopt);
        m_modeSince = now;
        m_known.forget(Parameter::startUpMode);
    }
}

std::optional<PositionCoding> K3Knowledge::coding() const
{
    if (m_device.dialect == k3::Dialect::fraba)
        return PositionCoding::binary;
    const auto coding = value(Parameter::coding);
    if (!coding)
        return std::nullopt;
    if (*coding <= 2)
        return PositionCoding::signedBinary;
    return *coding <= 4 ? PositionCoding::binary : PositionCoding::gray;
}

std::optional<bool> K3Knowledge::countsStepsMinusOne() const
{
    if (!m_device.quirks.mayCountStepsMinusOne)
        return false;
    const auto flags = value(Parameter::multiTurnAndStepsMinusOne);
    return flags ? std::optional((*flags & 1) != 0) : std::nullopt;
}

Word K3Knowledge::dataFor(Parameter parameter, std::int64_t value) const
{
    if (parameter == Parameter::steps && countsStepsMinusOne().value_or(false))
        --value;
    return static_cast<Word>(value) & k3::dataMask;
}

std::optional<std::int64_t> K3Knowledge::valueOfReadOut(Parameter parameter, Word data) const
{
    if (parameter == Parameter::direction)
        return directionOfReadOut(data);
    if (parameter == Parameter::temperature)
        return temperatureOfReadOut(data);
    if (parameter != Parameter::steps)
        return data;
    const auto minusOne = countsStepsMinusOne();
    return minusOne ? std::optional(std::int64_t{data} + (*minusOne ? 1 : 0)) : std::nullopt;
}

void K3Knowledge::learn(Parameter parameter, std::int64_t value, Evidence evidence, Instant now)
{
    if (parameter == Parameter::presetFlag)
        m_presetArmed = value != 0;
    m_known.learn({parameter, value, evidence, now});
}

// In each cycle, in nearly none of which there are any.
std::optional<KnowledgeChanged> K3Knowledge::takeChanges()
{
    const bool hasRun = std::exchange(m_hasRun, false);
    if (!m_known.haveChanged() && !m_cams.mayHaveChanged() && !hasRun)
        return std::nullopt;
    auto values = m_known.takeChanges();
    const bool haveValues = values.has_value();
    KnowledgeChanged changes = std::move(values).value_or(KnowledgeChanged{});
    if (!m_cams.takeChanges(changes) && !haveValues && !hasRun)
        return std::nullopt;
    return changes;
}

} // namespace codewheel
