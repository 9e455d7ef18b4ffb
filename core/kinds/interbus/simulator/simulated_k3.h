// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/encoder_arithmetic.h"
#include "kinds/interbus/simulator/parameter_memory.h"
#include "kinds/interbus/simulator/simulated_device.h"
#include "kinds/interbus/words/k3_word.h"

#include <optional>

namespace codewheel {

// What a simulated encoder has seen of OUT: how long the word has been there, the edges of D31 and D30, and
// whether the word has been dealt with.
class WordWatch
{
public:
    // After power-up: the first word seen is not an edge.
    void reset() { *this = WordWatch(); }

    void see(Word out)
    {
        const Word rising = m_first ? 0 : out & ~m_word;
        const bool started = (out & k3::startBit) != 0;
        m_startEdge = (rising & k3::startBit) != 0;
        if ((out & k3::presetBit) == 0)
            m_presetEdge = false;
        else if ((rising & k3::presetBit) != 0 && !started) // D30 is ignored while D31 is 1
            m_presetEdge = true;
        if (m_first || out != m_word) {
            m_cycles = 0;
            m_done = false;
        }
        ++m_cycles;
        m_word = out;
        m_first = false;
    }

    bool isOld(Word out) const { return m_done && out == m_word; }
    bool isDone() const { return m_done; }
    bool hasStood(int cycles) const { return m_cycles >= cycles; }
    void setDone() { m_done = true; }

    bool startEdge() const { return m_startEdge; } // in the cycle just seen
    // D30 rose, and nobody has asked since.
    bool takePresetEdge()
    {
        const bool edge = m_presetEdge;
        m_presetEdge = false;
        return edge;
    }

private:
    Word m_word = 0;
    long long m_cycles = 0;
    bool m_first = true;
    bool m_done = false;
    bool m_startEdge = false;
    bool m_presetEdge = false;
};

// When an encoder acts, in bus cycles (assumed: the manuals give an order, but no times).
struct EncoderTiming
{
    int takenAfter = 2; // how long a word must have been there
    int processing = 2;
    int runAfter = 1;
    int startUp = 0; // from power-up to operation
};

// A simulated K3 encoder and its shaft: the handshake as both makes have it. What a word means to the make,
// and what it shows in operation, is up to the derived classes. Used by SimulatedRing, one cycle() per bus
// cycle of 1 ms.
class SimulatedK3 : public SimulatedDevice
{
public:
    static constexpr int slowFactor = 50; // "slow confirmation"

    Word cycle(Word out) final;
    void passTime(std::chrono::milliseconds time) final;

    std::optional<TrainingControls::Shaft> shaftState() const final;
    const TurningShaft &shaft() const { return m_shaft; }
    const ParameterSet &parameters() const { return m_memory.active(); } // the active ones
    int eepromWrites() const { return m_memory.eepromWrites(); }
    bool isPowered() const { return m_phase != Phase::off; }
    virtual bool hasBattery() const { return false; }
    virtual bool isBatteryLow() const { return false; }
    virtual bool reportsFaults() const { return false; }
    virtual bool isCodeDiscFaulty() const { return false; }
    virtual bool hasCams() const { return false; }
    virtual bool isCamOutOfRange() const { return false; }

    void turnTo(std::int64_t raw) final;
    void turnBy(std::int64_t rawSteps) final;
    void setSpeed(double rpm) final;
    void setSlow(bool slow) final { m_slow = slow; }
    void setPower(bool on) final;
    void powerCycle() final;
    void loseParameters() final;

protected:
    enum class Phase : std::uint8_t { off, startingUp, operation, processing, parameterization, error };

    SimulatedK3(TurningShaft shaft, ParameterSet factory, EncoderTiming timing);
    // To be called at the end of the constructor of the make.
    void begin() { refresh(); }

    // A word that has been there long enough, D31 = 0. False: offer it again in the next cycle.
    virtual bool take(Word out) = 0;
    // Every cycle in which OUT is new or not yet dealt with.
    virtual void seen(Word /*out*/) {}
    // The end of processing a parameter word; false: its data are refused.
    virtual bool confirm(unsigned number, Word data) = 0;
    // What is then in IN: a confirmation or an error.
    virtual Word answerTo(Word processed);
    // IN in operation.
    virtual Word operationWord() const = 0;
    // An error found at power-up, before that of lost parameters.
    virtual std::optional<unsigned> startUpError() const { return std::nullopt; }
    // What IN shows spontaneously, and at every run as long as its cause is there.
    virtual std::optional<Word> fault() const { return std::nullopt; }
    virtual void poweredUp() {}
    virtual void wentToDefault() {}

    Phase phase() const { return m_phase; }
    Word shown() const { return m_shown; }
    bool isSlow() const { return m_slow; }
    const ParameterMemory &memory() const { return m_memory; }
    ParameterMemory &memory() { return m_memory; }
    const EncoderArithmetic &arithmetic() const { return m_arithmetic; }

    // Starts to process a word; IN shows `meanwhile` until it is answered, 0: as in operation.
    void process(Word out, Word meanwhile);
    void acknowledge(Word shown) { enter(Phase::parameterization, shown); }
    void fail(unsigned errorNumber);
    void failWith(Word shown) { enter(Phase::error, shown); }
    void operate() { enter(Phase::operation, 0); }
    bool takePresetEdge() { return m_watch.takePresetEdge(); }
    void initialisePreset(ParameterMemory::Storing storing);
    // To be called by the make when fault() has changed.
    void faultChanged();
    // Shown in IN instead of everything else; 0: nothing.
    void showReadOut(Word answer) { m_readOut = answer; }
    Word readOut() const { return m_readOut; }

private:
    static constexpr int noRun = -1;

    void enter(Phase phase, Word shown);
    bool showsOperation() const;
    void refresh() { m_in = m_readOut != 0 ? m_readOut : showsOperation() ? operationWord() : m_shown; }
    void see(Word out);
    void passOffTime();
    void switchOn();
    void finishStartUp();
    void finishProcessing();
    void runWhenDue();
    void run();

    TurningShaft m_shaft;
    ParameterMemory m_memory;
    EncoderArithmetic m_arithmetic;
    EncoderTiming m_timing;
    WordWatch m_watch;
    Phase m_phase = Phase::operation;
    Word m_in = 0;      // prepared for the next cycle
    Word m_shown = 0;   // IN outside operation
    Word m_readOut = 0; // IN during read-out
    Word m_processed = 0;
    int m_remaining = 0; // cycles left of starting up, processing, or a power cycle
    int m_runIn = noRun; // cycles until a run that was seen takes effect
    bool m_slow = false;
};

} // namespace codewheel
