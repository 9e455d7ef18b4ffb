// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/process_data_link.h"

#include <memory>
#include <utility>

namespace codewheel::test {

// A link that passes everything on to another one, for links that look at what passes, or stop it.
class PassingLink : public ProcessDataLink
{
public:
    explicit PassingLink(std::unique_ptr<ProcessDataLink> link)
        : m_link(std::move(link))
    {}

    Result<RingStructure> open() override { return m_link->open(); }
    void close() override { m_link->close(); }
    Result<std::vector<Word>> readBackOut() override { return m_link->readBackOut(); }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        return m_link->exchange(out, in);
    }
    Result<void> watch(std::span<Word> out, std::span<Word> in) override { return m_link->watch(out, in); }
    void claimOut(std::size_t device) override { m_link->claimOut(device); }
    bool writesOut(std::size_t device) const override { return m_link->writesOut(device); }
    Result<ZerosSent> sendZeros(std::span<Word> in) override { return m_link->sendZeros(in); }
    void hurryToZeros() override { m_link->hurryToZeros(); }
    bool sendZerosUnheard() override { return m_link->sendZerosUnheard(); }
    std::vector<QString> outPlaces() const override { return m_link->outPlaces(); }
    Result<void> acknowledgeWatchdog() override { return m_link->acknowledgeWatchdog(); }
    std::optional<ToldRing> toldRing() const override { return m_link->toldRing(); }
    std::optional<Instant> age(std::size_t device) const override { return m_link->age(device); }
    bool isUpToDate(std::size_t device) const override { return m_link->isUpToDate(device); }
    std::shared_ptr<const LinkFigures> figures() const override { return m_link->figures(); }
    std::optional<DataCheck> checkWord(std::size_t device, Word in,
                                       const EncoderSession &encoder) const override
    {
        return m_link->checkWord(device, in, encoder);
    }
    Instant now() const override { return m_link->now(); }
    void wait(Instant until) override { m_link->wait(until); }
    bool isDue() const override { return m_link->isDue(); }
    bool boundsWordsToCycles() const override { return m_link->boundsWordsToCycles(); }
    bool isSimulated() const override { return m_link->isSimulated(); }
    bool findsDevices() const override { return m_link->findsDevices(); }
    void interrupt() override { m_link->interrupt(); }
    MasterLink *master() override { return m_link->master(); }

private:
    std::unique_ptr<ProcessDataLink> m_link;
};

} // namespace codewheel::test
