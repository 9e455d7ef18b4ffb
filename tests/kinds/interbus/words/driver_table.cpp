// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/driver_table.h"

#include "vocabulary/hex.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
const DeviceDescription &describe(QStringView key)
{
    static const Catalog catalog = Catalog::builtIn();
    return *catalog.find(key);
}

DriverTable::DriverTable(QStringView device, K3Timing timing)
    : m_driver(std::make_unique<K3Driver>(describe(device), timing))
{}

DriverTable::DriverTable(La66Timing timing)
    : m_driver(std::make_unique<La66Driver>(describe(u"tr-la66"), timing))
{}

void DriverTable::tell(Parameter parameter, std::int64_t value)
{
    m_told.push_back({parameter, value, Evidence::told, m_now});
    m_driver->setKnown(m_told);
}

Result<void> DriverTable::begin(const Job &job, Pace pace)
{
    m_outcome.reset();
    return m_driver->begin(1, job, pace, m_in, m_out, m_now);
}

void DriverTable::play(const std::vector<Row> &rows)
{
    int number = 0;
    for (const Row &row : rows) {
        ++number;
        ASSERT_EQ(m_out, row.out) << "row " << number << ": OUT is " << hexWord(m_out).toStdString()
                                  << " and should be " << hexWord(row.out).toStdString();
        m_in = row.in;
        m_now += std::chrono::milliseconds(1);
        m_out = m_driver->cycle(row.in, m_out, m_now);
    }
    collect();
}

void DriverTable::repeat(int cycles, Row row)
{
    play(std::vector<Row>(static_cast<std::size_t>(cycles), row));
}

void DriverTable::collect()
{
    for (const Event &event : m_driver->takeEvents()) {
        if (const auto *outcome = std::get_if<Outcome>(&event))
            m_outcome = *outcome;
        if (const auto *progress = std::get_if<Progress>(&event))
            m_progress = *progress;
        if (const auto *change = std::get_if<KnowledgeChanged>(&event)) {
            m_eepromWrites += change->eepromWrites;
            for (const unsigned gone : change->camsNoLongerKnown)
                m_cams.erase(gone);
            for (const KnownCams &fresh : change->cams)
                m_cams[fresh.program.number] = fresh;
            for (const Parameter gone : change->noLongerKnown)
                std::erase_if(m_known, [&](const Known &known) { return known.parameter == gone; });
            for (const Known &fresh : change->known) {
                std::erase_if(m_known,
                              [&](const Known &known) { return known.parameter == fresh.parameter; });
                m_known.push_back(fresh);
            }
        }
    }
}

const std::optional<Outcome> &DriverTable::outcome()
{
    collect();
    return m_outcome;
}

const Progress &DriverTable::progress()
{
    collect();
    return m_progress;
}

const Known *DriverTable::find(Parameter parameter)
{
    collect();
    const auto found = std::ranges::find(m_known, parameter, &Known::parameter);
    return found == m_known.end() ? nullptr : &*found;
}

std::optional<std::int64_t> DriverTable::known(Parameter parameter)
{
    const Known *known = find(parameter);
    return known == nullptr ? std::nullopt : known->value.asNumber();
}

std::optional<Evidence> DriverTable::evidence(Parameter parameter)
{
    const Known *known = find(parameter);
    return known == nullptr ? std::nullopt : std::optional(known->evidence);
}

std::optional<KnownCams> DriverTable::cams(unsigned program)
{
    collect();
    const auto found = m_cams.find(program);
    return found == m_cams.end() ? std::nullopt : std::optional(found->second);
}

int DriverTable::eepromWrites()
{
    collect();
    return m_eepromWrites;
}

} // namespace codewheel
